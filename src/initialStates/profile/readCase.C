/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "radialProfile.H"
#include "feMesh.H"
#include "localIOdictionary.H"
#include "IOdictionary.H"
#include "scalarField.H"
#include "vectorField.H"
#include "Time.H"
#include "instantList.H"
#include "OSspecific.H"
#include "SortableList.H"
#include "thermodynamicConstants.H"

namespace
{

//- Values at the points, without the boundary conditions
template<class Type>
Foam::Field<Type> pointValues
(
    const Foam::polyMesh& mesh,
    const Foam::word& name,
    const Foam::word& type
)
{
    using namespace Foam;
    const localIOdictionary file
    (
        IOobject
        (
            name,
            mesh.time().timeName(),
            mesh,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        ),
        type
    );
    return Field<Type>("internalField", file, mesh.nPoints());
}


//- Set the clock to the entry time, default latestTime
void selectTime(Foam::Time& time, const Foam::dictionary& dict)
{
    using namespace Foam;
    const instantList times(time.times());
    label chosen = times.size() - 1;

    if (dict.found("time"))
    {
        const token wanted(dict.lookup("time"));
        if (wanted.isNumber())
        {
            chosen = Time::findClosestTimeIndex(times, wanted.number());
        }
        const bool there =
        (
            wanted.isNumber()
          ? chosen >= 0
         && mag(times[chosen].value() - wanted.number())
         <= 1e-6*mag(wanted.number())
          : wanted.isWord() && wanted.wordToken() == "latestTime"
        );
        if (!there)
        {
            FatalIOErrorInFunction(dict)
                << "The case " << time.path() << " has no time " << wanted
                << nl << "    Give one of its times or latestTime"
                << exit(FatalIOError);
        }
    }
    if (chosen < 0)
    {
        FatalIOErrorInFunction(dict)
            << "The case " << time.path() << " has no times"
            << exit(FatalIOError);
    }
    time.setTime(times[chosen], chosen);
}


void checkGas
(
    const Foam::Time& time,
    const gasDynamics::PerfectGas& gas,
    const Foam::dictionary& dict
)
{
    using namespace Foam;
    const IOdictionary properties
    (
        IOobject
        (
            "thermophysicalProperties",
            time.constant(),
            time,
            IOobject::MUST_READ,
            IOobject::NO_WRITE,
            false
        )
    );
    const dictionary& mixture = properties.subDict("mixture");
    const scalar R = constant::thermodynamic::RR
       /mixture.subDict("specie").get<scalar>("molWeight");
    const scalar Cp =
        mixture.subDict("thermodynamics").get<scalar>("Cp");
    if (mag(R - gas.R()) > 1e-9*R || mag(Cp - gas.Cp()) > 1e-9*Cp)
    {
        FatalIOErrorInFunction(dict)
            << "The gas of " << time.path() << " has R = " << R << ", Cp = "
            << Cp << " J/(kg K), that of this case R = " << gas.R()
            << ", Cp = " << gas.Cp() << nl
            << "    Mass and energy can be kept between equal gases only"
            << exit(FatalIOError);
    }
}

//- While it lives, this processor works on its own
struct serialScope
{
    const bool parallel = Foam::Pstream::parRun();

    serialScope() { Foam::Pstream::parRun() = false; }
    ~serialScope() { Foam::Pstream::parRun() = parallel; }
};

} // End namespace


Foam::List<Foam::profileRow> Foam::readCase
(
    const gasDynamics::PerfectGas& gas,
    const dictionary& dict
)
{
    fileName path(dict.get<fileName>("case"));
    path.expand();
    path.clean();
    if (!isFile(path/"system"/"controlDict"))
    {
        FatalIOErrorInFunction(dict)
            << "There is no case " << path << exit(FatalIOError);
    }

    Time time
    (
        Time::controlDictName, path.path(), path.name(),
        "system", "constant", false, false
    );
    selectTime(time, dict);
    checkGas(time, gas, dict);

    // Every processor reads the whole case, which is not decomposed
    const serialScope serial;

    const polyMesh poly
    (
        IOobject(polyMesh::defaultRegion, time.timeName(), time)
    );
    const feMesh& mesh = feMesh::New(poly);
    if (mesh.dim() != 1)
    {
        FatalIOErrorInFunction(dict)
            << "The case " << path << " is " << mesh.dim()
            << "-dimensional, not one line of cells" << exit(FatalIOError);
    }

    const scalarField p(pointValues<scalar>(poly, "p", "pointScalarField"));
    const vectorField U(pointValues<vector>(poly, "U", "pointVectorField"));
    const scalarField T(pointValues<scalar>(poly, "T", "pointScalarField"));

    const direction axis = mesh.axes()[0];
    SortableList<scalar> r(mesh.nodes().component(axis)());
    List<profileRow> rows(r.size());
    forAll(rows, i)
    {
        const label pointi = mesh.pointOfNode()[r.indices()[i]];
        rows[i] = profileRow
        {
            r[i],
            gas.density(p[pointi], T[pointi]),
            mesh.components<1>(U[pointi], poly.points()[pointi])[0],
            p[pointi],
            "a node of " + path + ", time " + time.timeName()
        };
    }
    return rows;
}
