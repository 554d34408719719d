/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasSolver.H"
#include "gasProperties.H"
#include "dictionaryCheck.H"
#include "OStringStream.H"
#include "Time.H"

namespace
{

template<class FieldType>
Foam::IOobject fieldIO
(
    const Foam::word& name,
    const Foam::polyMesh& mesh,
    const Foam::IOobject::readOption read
)
{
    return Foam::IOobject
    (
        name,
        mesh.time().timeName(),
        mesh,
        read,
        Foam::IOobject::AUTO_WRITE
    );
}

Foam::IOdictionary caseDictionary
(
    const Foam::word& name,
    const Foam::fileName& folder,
    const Foam::polyMesh& mesh
)
{
    return Foam::IOdictionary
    (
        Foam::IOobject
        (
            name,
            folder,
            mesh,
            Foam::IOobject::MUST_READ,
            Foam::IOobject::NO_WRITE,
            false
        )
    );
}

} // End namespace


template<int dim>
Foam::gasSolver<dim>::gasSolver(feMesh& mesh)
:
    mesh_(mesh),
    geometry_(mesh),
    feSchemes_
    (
        caseDictionary("feSchemes", mesh.poly().time().system(), mesh.poly())
    ),
    p_
    (
        fieldIO<pointScalarField>("p", mesh.poly(), IOobject::MUST_READ),
        pointMesh::New(mesh.poly())
    ),
    U_
    (
        fieldIO<pointVectorField>("U", mesh.poly(), IOobject::MUST_READ),
        pointMesh::New(mesh.poly())
    ),
    T_
    (
        fieldIO<pointScalarField>("T", mesh.poly(), IOobject::MUST_READ),
        pointMesh::New(mesh.poly())
    ),
    rho_
    (
        fieldIO<pointScalarField>("rho", mesh.poly(), IOobject::NO_READ),
        pointMesh::New(mesh.poly()),
        dimensionedScalar(dimDensity, Zero)
    ),
    state_
    (
        readPerfectGas
        (
            caseDictionary
            (
                "thermophysicalProperties",
                mesh.poly().time().constant(),
                mesh.poly()
            )
        ),
        geometry_
    ),
    boundary_(geometry_, state_.eos, p_, U_, T_),
    shockCapturing_(shockCapturing<dim>::New(feSchemes_)),
    timeScheme_(timeScheme<dim>::New(feSchemes_)),
    stable_(),
    stableIsUpToDate_(false)
{
    checkKeywords(feSchemes_, {"timeScheme", "shockCapturing"});
    readState();

    Info<< "Gas: " << mesh_.nNodes() << " nodes, " << mesh_.nSimplices()
        << (dim == 1 ? " lines" : dim == 2 ? " triangles" : " tetrahedra")
        << nl << "    R " << state_.eos.R() << " J/(kg K), gamma "
        << state_.eos.gamma() << nl
        << "    timeScheme " << feSchemes_.get<word>("timeScheme")
        << ", shockCapturing " << feSchemes_.get<word>("shockCapturing") << nl
        << endl;
}


template<int dim>
void Foam::gasSolver<dim>::readState()
{
    for (label a = 0; a < mesh_.nNodes(); ++a)
    {
        const label pointi = mesh_.pointOfNode()[a];
        state_.U[a] = gasDynamics::conserved<dim>
        (
            state_.eos,
            state_.eos.density(p_[pointi], T_[pointi]),
            mesh_.components<dim>(U_[pointi]),
            p_[pointi]
        );
    }
    boundary_.impose(state_.U);

    const label bad = state_.derive();
    if (bad >= 0)
    {
        const label pointi = mesh_.pointOfNode()[bad];
        FatalErrorInFunction
            << "The initial state is not physical at the point "
            << mesh_.nodes()[bad] << ": p = " << p_[pointi] << " Pa, T = "
            << T_[pointi] << " K, U = " << U_[pointi] << nl
            << "    Change " << p_.objectPath() << ", T or U"
            << exit(FatalError);
    }
    updateFields();
}


template<int dim>
const Foam::stableStep& Foam::gasSolver<dim>::stable()
{
    if (!stableIsUpToDate_)
    {
        shockCapturing_->correct(geometry_, state_);
        stable_ = findStableStep(geometry_, state_);
        stableIsUpToDate_ = true;
    }
    return stable_;
}


template<int dim>
void Foam::gasSolver<dim>::stop
(
    const label node,
    const string& what,
    const scalar dt
)
{
    state_.U = oldU_;
    state_.derive();
    stableIsUpToDate_ = false;
    const scalar courant = dt/stable().deltaT;
    updateFields();
    p_.write();
    U_.write();
    T_.write();
    rho_.write();

    FatalErrorInFunction
        << "The gas is no longer in a physical state at time "
        << mesh_.poly().time().timeName() << " s:" << nl
        << "    node " << node << " at " << mesh_.nodes()[node] << ": "
        << what.c_str() << nl
        << "    the step of " << dt << " s was " << courant
        << " times the stable one of the state before" << nl
        << "    The state before this step is written to "
        << p_.instance() << nl
        << "    Try a smaller maxCo or deltaT, more artificial viscosity "
        << "(qDif), or a finer mesh there" << exit(FatalError);
}


template<int dim>
void Foam::gasSolver<dim>::step(const scalar dt)
{
    // The artificial viscosity belongs to the state at the step's start
    stable();
    oldU_ = state_.U;

    try
    {
        timeScheme_->step(geometry_, boundary_, state_, dt);
    }
    catch (const unphysicalSimplex& e)
    {
        OStringStream what;
        what<< "half step of cell " << mesh_.cellOfSimplex()[e.simplex]
            << " has rho = " << e.rho << " kg/m3, p = " << e.p << " Pa";
        stop(geometry_.nodes(e.simplex)[0], what.str(), dt);
    }

    geometry_.end();
    boundary_.impose(state_.U);

    const label bad = state_.derive();
    if (bad >= 0)
    {
        OStringStream what;
        what<< "rho = " << state_.U[bad][0] << " kg/m3, p = "
            << state_.p[bad] << " Pa";
        stop(bad, what.str(), dt);
    }
    stableIsUpToDate_ = false;
}


template<int dim>
void Foam::gasSolver<dim>::advance(const scalar dt)
{
    geometry_.begin();
    step(dt);
}


template<int dim>
void Foam::gasSolver<dim>::advance
(
    const scalar dt,
    const pointField& newNodes
)
{
    // Viscosity and stable step use the mesh of the step's start
    stable();
    geometry_.begin(dt, newNodes);
    step(dt);
    boundary_.updateNormals();
}


template class Foam::gasSolver<1>;
template class Foam::gasSolver<2>;
template class Foam::gasSolver<3>;
