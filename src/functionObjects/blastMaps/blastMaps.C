/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "blastMaps.H"
#include "fvMesh.H"
#include "OSspecific.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(blastMaps, 0);
    addToRunTimeSelectionTable(functionObject, blastMaps, dictionary);
}
}


namespace
{

const Foam::dimensionSet impulseDimensions
(
    Foam::dimPressure*Foam::dimTime
);

} // End namespace


Foam::functionObjects::blastMaps::blastMaps
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    fvMeshFunctionObject(name, runTime, dict),
    peak_(made("peakOverpressure", dimPressure, 0)),
    arrival_(made("arrivalTime", dimTime, -1)),
    impulse_(made("positiveImpulse", impulseDimensions, 0)),
    duration_(made("positiveDuration", dimTime, 0)),
    running_(made("impulseSinceArrival", impulseDimensions, 0)),
    timeBefore_(runTime.value())
{
    read(dict);
    before_ = pressure().primitiveField() - ambient_;
    peak_.primitiveFieldRef() = max(peak_.primitiveField(), before_);
    openFile();
}


Foam::pointScalarField Foam::functionObjects::blastMaps::made
(
    const word& name,
    const dimensionSet& dimensions,
    const scalar value
) const
{
    return pointScalarField
    (
        IOobject
        (
            name, time_.timeName(), mesh_,
            IOobject::READ_IF_PRESENT, IOobject::NO_WRITE
        ),
        pointMesh::New(mesh_),
        dimensionedScalar(name, dimensions, value)
    );
}


bool Foam::functionObjects::blastMaps::read(const dictionary& dict)
{
    fvMeshFunctionObject::read(dict);

    fieldName_ = dict.getOrDefault<word>("field", "p");
    dict.readEntry("ambient", ambient_);
    threshold_ = dict.getOrDefault<scalar>("threshold", 0.01*ambient_);
    for (const scalar value : {ambient_, threshold_})
    {
        if (value <= 0)
        {
            FatalIOErrorInFunction(dict)
                << "ambient (" << ambient_ << " Pa) and threshold ("
                << threshold_ << " Pa) of " << name()
                << " must be positive" << exit(FatalIOError);
        }
    }
    if (!mesh_.foundObject<pointScalarField>(fieldName_))
    {
        FatalIOErrorInFunction(dict)
            << name() << ": there is no pointScalarField " << fieldName_ << nl
            << "    There are "
            << flatOutput(mesh_.sortedNames<pointScalarField>())
            << exit(FatalIOError);
    }
    return true;
}


const Foam::pointScalarField&
Foam::functionObjects::blastMaps::pressure() const
{
    return mesh_.lookupObject<pointScalarField>(fieldName_);
}


void Foam::functionObjects::blastMaps::openFile()
{
    const fileName folder
    (
        time_.globalPath()/"postProcessing"/name()/time_.timeName()
    );
    if (Pstream::master())
    {
        mkDir(folder);
        file_.reset(new OFstream(folder/"blastMaps.csv"));
        file_().precision(10);
        file_()
            << "time [s],part,peak overpressure [Pa],x [m],y [m],z [m],"
            << "first arrival [s],positive impulse [Pa s],"
            << "positive duration [s]" << endl;
    }
}


bool Foam::functionObjects::blastMaps::execute()
{
    const scalarField& p = pressure().primitiveField();
    const scalar dt = time_.value() - timeBefore_;
    forAll(p, i)
    {
        const scalar now = p[i] - ambient_;
        peak_[i] = max(peak_[i], now);
        if (arrival_[i] >= 0)
        {
            running_[i] += 0.5*dt*(before_[i] + now);
        }
        else if (now >= threshold_)
        {
            // The part of the step behind the arrival
            const scalar rise = now - before_[i];
            const scalar part =
                rise > 0 ? min((now - threshold_)/rise, 1) : 1;
            arrival_[i] = time_.value() - part*dt;
            running_[i] = 0.5*part*dt*(now + (now - part*rise));
        }
        if (running_[i] > impulse_[i])
        {
            impulse_[i] = running_[i];
            duration_[i] = time_.value() - arrival_[i];
        }
        before_[i] = now;
    }
    timeBefore_ = time_.value();
    return true;
}


Foam::Tuple2<Foam::scalar, Foam::point>
Foam::functionObjects::blastMaps::largest
(
    const pointScalarField& field,
    const labelUList& points
) const
{
    using placed = Tuple2<scalar, point>;
    placed most(-GREAT, point::zero);
    for (const label i : points)
    {
        if (field[i] > most.first())
        {
            most = placed(field[i], mesh_.points()[i]);
        }
    }
    reduce
    (
        most,
        [](const placed& a, const placed& b)
        {
            return a.first() >= b.first() ? a : b;
        }
    );
    return most;
}


void Foam::functionObjects::blastMaps::writeRow
(
    const word& part,
    const labelUList& points
)
{
    scalar first = GREAT;
    for (const label i : points)
    {
        first = arrival_[i] >= 0 ? min(first, arrival_[i]) : first;
    }
    reduce(first, minOp<scalar>());
    const Tuple2<scalar, point> peak(largest(peak_, points));
    const scalar impulse = largest(impulse_, points).first();
    const scalar duration = largest(duration_, points).first();
    if (Pstream::master())
    {
        const point& x = peak.second();
        file_()
            << time_.timeName() << ',' << part << ',' << peak.first() << ','
            << x.x() << ',' << x.y() << ',' << x.z() << ','
            << (first < GREAT ? first : -1) << ',' << impulse << ','
            << duration << endl;
    }
}


bool Foam::functionObjects::blastMaps::write()
{
    for
    (
        const pointScalarField* field
      : {&peak_, &arrival_, &impulse_, &duration_, &running_}
    )
    {
        field->write();
    }

    writeRow("gas", identity(mesh_.nPoints()));
    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        if (!polyPatch::constraintType(patch.type()))
        {
            writeRow(patch.name(), patch.meshPoints());
        }
    }
    return true;
}
