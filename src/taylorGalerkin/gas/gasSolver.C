/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasSolver.H"
#include "gasProperties.H"
#include "dictionaryCheck.H"
#include "OStringStream.H"
#include "uniformDimensionedFields.H"
#include "PstreamReduceOps.H"
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
    zones_(geometry_, feSchemes_),
    properties_
    (
        caseDictionary
        (
            "thermophysicalProperties",
            mesh.poly().time().constant(),
            mesh.poly()
        )
    ),
    state_(readPerfectGas(properties_), geometry_),
    transport_(readTransport(properties_, state_.eos)),
    boundary_(geometry_, state_.eos, p_, U_, T_, transport_.isPresent()),
    shockCapturing_(shockCapturing<dim>::New(feSchemes_)),
    timeScheme_
    (
        timeScheme<dim>::New(feSchemes_, geometry_, shockCapturing_())
    ),
    rates_(geometry_),
    stable_(),
    stableIsUpToDate_(false),
    stateTime_(mesh.poly().time().value())
{
    checkKeywords
    (
        feSchemes_, {"timeScheme", "shockCapturing", "quiescentZones"}
    );
    if (transport_.isPresent())
    {
        rates_.viscous.reset
        (
            new viscousTerms<dim>
            (
                transport_, boundary_.open(), boundary_.farField()
            )
        );
    }
    readGravity();
    sortPoints();
    readState();
    oldRows_ = state_.rows;
    if (feSchemes_.get<word>("timeScheme") == "threeStep")
    {
        zones_.forbid("timeScheme threeStep has none");
    }
    if (transport_.isPresent())
    {
        zones_.forbid("the gas is viscous");
    }
    if (state_.hasGravity)
    {
        zones_.forbid("gravity acts everywhere");
    }

    mesh_.report(Info);
    Info<< "Gas: "
        << returnReduce(mesh_.exchange().nOwned(), sumOp<label>())
        << " nodes, "
        << returnReduce(mesh_.nSimplices(), sumOp<label>())
        << (dim == 1 ? " lines" : dim == 2 ? " triangles" : " tetrahedra")
        << nl << "    R " << state_.eos.R() << " J/(kg K), gamma "
        << state_.eos.gamma() << nl
        << "    timeScheme " << feSchemes_.get<word>("timeScheme")
        << ", shockCapturing "
        << feSchemes_.getOrDefault<word>("shockCapturing", "fluxCorrected")
        << ", stable up to Courant number " << maxCourant() << nl;
    if (feSchemes_.get<word>("timeScheme") == "threeStep")
    {
        Info<< "    in gas at rest only: in moving gas threeStep lets sound"
            << " grow where artificial" << nl
            << "    viscosity does not cover it; twoStep does not" << nl;
    }
    if (transport_.isPresent())
    {
        Info<< "    viscous: kappa/mu " << transport_.kappaOverMu()
            << " J/(kg K)" << nl;
    }
    Info<< "    " << gasKernel::gasKernels<dim>::best().name
        << " instructions" << nl << endl;
}


template<int dim>
void Foam::gasSolver<dim>::readGravity()
{
    const polyMesh& mesh = mesh_.poly();
    IOobject io
    (
        "g", mesh.time().constant(), mesh,
        IOobject::MUST_READ, IOobject::NO_WRITE, false
    );
    if (!io.typeHeaderOk<uniformDimensionedVectorField>(true))
    {
        return;
    }
    const uniformDimensionedVectorField g(io);
    const Vec components = mesh_.components<dim>(g.value());
    if (mag(g.value() - mesh_.fullVector<dim>(components)) > SMALL
     || (mesh_.curvature() && components[mesh_.radial()] != 0))
    {
        FatalErrorInFunction
            << "Gravity " << g.value() << " of " << io.objectPath()
            << " has a component in a direction that the scene has not,"
            << nl << "    or along its radius. The scene has " << dim
            << " direction(s)" << exit(FatalError);
    }
    state_.hasGravity = true;
    state_.gravity = components;
    const auto& b = boundary_;
    rates_.gravity.reset
    (
        new gravityTerms<dim>(components, b.open(), b.farField())
    );
    Info<< "Gravity: " << g.value() << " m/s2" << nl << endl;
}


template<int dim>
void Foam::gasSolver<dim>::sortPoints()
{
    const labelList& nodeOfPoint = mesh_.nodeOfPoint();
    firstPoint_.setSize(mesh_.nNodes() + 1, Zero);
    for (const label a : nodeOfPoint)
    {
        ++firstPoint_[a + 1];
    }
    for (label a = 0; a < mesh_.nNodes(); ++a)
    {
        firstPoint_[a + 1] += firstPoint_[a];
    }
    labelList next(firstPoint_);
    points_.setSize(nodeOfPoint.size());
    forAll(nodeOfPoint, pointi)
    {
        points_[next[nodeOfPoint[pointi]]++] = pointi;
    }
}


template<int dim>
const std::vector<double>& Foam::gasSolver<dim>::viscosities()
{
    const std::vector<double>& artificial = shockCapturing_->nodalNu();
    if (!rates_.viscous.valid())
    {
        return artificial;
    }
    viscosities_ = rates_.viscous->nodal();
    for (std::size_t a = 0; a < artificial.size(); ++a)
    {
        viscosities_[a] += artificial[a];
    }
    return viscosities_;
}


template<int dim>
const Foam::stableStep& Foam::gasSolver<dim>::stable()
{
    if (!stableIsUpToDate_)
    {
        shockCapturing_->correct(geometry_, state_);
        if (rates_.viscous.valid())
        {
            rates_.viscous->correct(geometry_, state_);
        }
        if (geometry_.edges().sweep)
        {
            rates_.sumSpeeds(geometry_, state_);
        }
        else
        {
            // The sums that the step needs give the speeds as well
            rates_.sumEdges(geometry_, state_);
        }
        zones_.setSpeeds(rates_.speed);
        stable_ = findStableStep
        (
            geometry_, rates_.speed, viscosities(), blockSteps_,
            shockCapturing_->limits()
        );
        stableIsUpToDate_ = true;
        if (zones_.waits())
        {
            zones_.start(state_, boundary_, rates_.speed);
            zones_.report(Info);
        }
    }
    return stable_;
}


template<int dim>
void Foam::gasSolver<dim>::stopIfBad
(
    const label node,
    const string& what,
    const scalar dt
)
{
    // The lowest processor that found a bad state speaks for all
    label teller = node >= 0 ? Pstream::myProcNo() : labelMax;
    reduce(teller, minOp<label>());
    if (teller == labelMax)
    {
        return;
    }

    state_.rows = oldRows_;
    if (oldNodes_.size())
    {
        mesh_.moveNodes(oldNodes_);
    }
    rates_.clear();
    stableIsUpToDate_ = false;
    stable();

    const word failedAt(mesh_.poly().time().timeName());
    writeState();
    if (beforeStop_) beforeStop_();

    if (teller == Pstream::myProcNo())
    {
        FatalErrorInFunction
            << "The gas is no longer in a physical state at time "
            << failedAt << " s:" << nl
            << "    node " << mesh_.globalNode()[node] << " at "
            << mesh_.nodes()[node] << ": " << what.c_str() << nl
            << "    before the step it had rho = " << state_.rho(node)
            << " kg/m3, p = " << state_.p(node) << " Pa, U = "
            << mesh_.fullVector<dim>(state_.velocity(node)) << " m/s" << nl
            << "    the step of " << dt << " s was Courant number "
            << dt*rates_.speed[node]/geometry_.nodeVolume(node)
            << " there and " << dt/stable_.deltaT << " at most" << nl
            << "    The state before this step is written to "
            << p_.instance() << nl
            << "    Try a smaller maxCo or deltaT, shockCapturing "
            << "fluxCorrected, or a finer mesh there" << exit(FatalError);
    }
    // The others wait here until the error has ended the run
    returnReduce(true, andOp<bool>());
}


template<int dim>
Foam::gasAccount* Foam::gasSolver<dim>::account() const
{
    gasAccount* found =
        mesh_.poly().getObjectPtr<gasAccount>(gasAccount::typeName);
    if (found && !found->isOpen())
    {
        if (transport_.isPresent() || state_.hasGravity)
        {
            FatalErrorInFunction
                << "The account of mass, momentum and energy (function object"
                << " conservation)" << nl
                << "    knows neither viscosity nor gravity, and the gas has "
                << (transport_.isPresent() ? "viscosity" : "gravity") << nl
                << "    Remove the function object from system/controlDict"
                << exit(FatalError);
        }
        found->open(*this);
    }
    return found;
}


template<int dim>
template<class Change>
void Foam::gasSolver<dim>::accountHeld(const Change& change)
{
    boundary_.accountHeld
    (
        [&](const label a) { return State(state_.conserved(a)); },
        [&](const label a) { return geometry_.nodeVolume(a); },
        change
    );
}


template<int dim>
void Foam::gasSolver<dim>::step(const scalar dt)
{
    // The artificial viscosity belongs to the state at the step's start
    stable();
    boundary_.setAccount(account());
    geometry_.active().copy(state_.rows, oldRows_);
    boundary_.beginStep(state_.rows, stateTime_, dt);

    label bad = -1;
    OStringStream what;
    try
    {
        timeScheme_->step
        (
            geometry_, boundary_, shockCapturing_(), rates_, state_, dt
        );
    }
    catch (const unphysicalEdge& e)
    {
        bad = e.first;
        if (bad >= 0)
        {
            what<< "no physical state at the half step between it and "
                << mesh_.nodes()[e.second];
        }
    }
    catch (const unphysicalNode& e)
    {
        bad = e.node;
        what<< "rho = " << e.rho << " kg/m3, p = " << e.p
            << " Pa in the low-order state";
    }
    rates_.clear();
    stopIfBad(bad, what.str(), dt);

    geometry_.end();
    accountHeld([&]() { boundary_.impose(state_.rows); });
    boundary_.setAccount(nullptr);

    for (const label node : boundary_.prescribed())
    {
        if (geometry_.active().asleep(node))
        {
            state_.derive(node);
        }
    }
    bad = state_.derive(geometry_.active());
    if (bad >= 0)
    {
        what<< "rho = " << state_.rho(bad) << " kg/m3, p = "
            << state_.p(bad) << " Pa";
    }
    stopIfBad(bad, what.str(), dt);
    boundary_.endStep(state_.rows, dt);
    zones_.update(state_, boundary_.prescribed());
    stateTime_ += dt;
    stableIsUpToDate_ = false;
}


template<int dim>
void Foam::gasSolver<dim>::forgetMotion()
{
    if (geometry_.edges().sweep)
    {
        geometry_.begin();
        rates_.clear();
        stableIsUpToDate_ = false;
    }
}


template<int dim>
void Foam::gasSolver<dim>::expectMotion(const vectorField& ways)
{
    // Zones start from the sums at the start
    stable();
    geometry_.expect(ways);
    zones_.wake(geometry_.part().added());
}


template<int dim>
void Foam::gasSolver<dim>::advance(const scalar dt)
{
    // The mesh has come to rest
    forgetMotion();
    oldNodes_.clear();
    step(dt);
}


template<int dim>
void Foam::gasSolver<dim>::advance
(
    const scalar dt,
    const pointField& newNodes
)
{
    const bool moves = newNodes != mesh_.nodes();
    if (!returnReduce(moves, orOp<bool>()))
    {
        advance(dt);
        return;
    }

    // Viscosity and stable step belong to the mesh of the step's start, as
    // the totals do from which an account starts
    stable();
    account();
    rates_.clear();
    geometry_.active().copy(state_.rows, oldRows_);
    oldNodes_ = mesh_.nodes();
    geometry_.begin(dt, newNodes);
    zones_.wake(geometry_.part().added());

    // The walls' velocity has changed with the new step
    boundary_.setAccount(account());
    accountHeld([&]() { boundary_.constrainAtWalls(state_.rows); });
    const label bad = state_.derive(geometry_.active());
    stopIfBad(bad, "the wall's velocity leaves no physical state", dt);
    rates_.sumEdges(geometry_, state_);
    zones_.setSpeeds(rates_.speed);
    step(dt);
    boundary_.updateNormals();
}


template class Foam::gasSolver<1>;
template class Foam::gasSolver<2>;
template class Foam::gasSolver<3>;
