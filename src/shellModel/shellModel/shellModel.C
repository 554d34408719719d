/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellModel.H"
#include "dictionaryCheck.H"
#include "shellConstraints.H"
#include "shellFile.H"
#include "shellInput.H"
#include "shellLoads.H"
#include "shellMeshIO.H"
#include "shellSections.H"
#include "shellVector.H"
#include "Switch.H"

namespace Foam
{
    defineTypeNameAndDebug(shellModel, 0);
}


static bool readDynamic(const Foam::dictionary& properties)
{
    return
        !properties.found("analysis")
     || Foam::selectEntry(properties, "analysis", {"dynamic", "static"}) == 0;
}


static positionalShell::ElementForm readElementForm
(
    const Foam::dictionary& properties
)
{
    using positionalShell::ElementForm;

    if (!properties.found("elementForm"))
    {
        return ElementForm::assumedStrain;
    }
    Foam::wordList names;
    for (const std::string& name : positionalShell::elementFormNames())
    {
        names.append(name);
    }
    return static_cast<ElementForm>
    (
        Foam::selectEntry(properties, "elementForm", names)
    );
}


static positionalShell::IntegrationOptions readIntegration
(
    const Foam::dictionary& properties
)
{
    using namespace Foam;

    positionalShell::IntegrationOptions options;
    if (properties.found("integration"))
    {
        const dictionary& dict = properties.subDict("integration");
        checkKeywords(dict, {"areaPoints", "thicknessPoints"});
        dict.readIfPresent("areaPoints", options.areaPoints);
        dict.readIfPresent("thicknessPoints", options.thicknessPoints);
    }
    return options;
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::shellModel::instant::instant(const instant& other)
:
    state(other.state),
    externalForce(other.externalForce),
    memory(other.memory),
    account
    (
        other.account
      ? new positionalShell::EnergyBalance(*other.account)
      : nullptr
    ),
    report(other.report)
{}


Foam::shellModel::instant& Foam::shellModel::instant::operator=
(
    const instant& other
)
{
    instant copy(other);
    std::swap(state, copy.state);
    std::swap(externalForce, copy.externalForce);
    std::swap(memory, copy.memory);
    std::swap(account, copy.account);
    std::swap(report, copy.report);
    return *this;
}


void Foam::shellModel::makeModel()
{
    const dictionary& sections = properties_.subDict("sections");
    const dictionary& constraints = properties_.subDict("constraints");

    positionalShell::ShellMesh mesh
    (
        readShellMesh
        (
            runTime_,
            properties_.lookupOrDefault<word>("mesh", "shell")
        )
    );
    std::vector<positionalShell::Section> parts
    (
        readShellSections(sections, mesh)
    );
    positionalShell::DofMap dofs
    (
        readShellConstraints(constraints, mesh, dynamic_)
    );
    const auto integration = readIntegration(properties_);
    const auto form = readElementForm(properties_);

    rejectedIn(sections, [&]
    {
        model_.reset
        (
            new positionalShell::ShellModel
            (
                std::move(mesh), std::move(parts), std::move(dofs),
                integration, form
            )
        );
    });

    loads_ = readShellLoads(properties_.subOrEmptyDict("loads"), *model_);
}


void Foam::shellModel::makeIntegrator()
{
    const word keyword(dynamic_ ? "timeIntegrator" : "staticMethod");
    const word type
    (
        dynamic_
      ? properties_.get<word>(keyword)
      : properties_.lookupOrDefault<word>(keyword, "loadSteps")
    );
    integrator_ = shellIntegrator::New(keyword, type, *model_, properties_);

    if (integrator_->dynamic() != dynamic_)
    {
        FatalIOErrorInFunction(properties_)
            << keyword << ' ' << type << " is for "
            << (dynamic_ ? "statics; set analysis static" : "dynamics")
            << ", or select another" << nl
            << exit(FatalIOError);
    }
}


void Foam::shellModel::start()
{
    const word timeName(runTime_.timeName());

    if (shellStateExists(runTime_, timeName))
    {
        const shellRestart restart(readShellState(runTime_, timeName, nDofs()));
        now_.state = restart.state;
        now_.externalForce = restart.externalForce;
        now_.memory = restart.memory;
        earlier_ = restart.energies;
        startAccount();
    }
    else
    {
        now_.state = model_->initialState(runTime_.value());
        now_.externalForce = positionalShell::Vector::Zero(nDofs());
    }
    old_ = now_;
}


void Foam::shellModel::startAccount()
{
    now_.account.reset
    (
        new positionalShell::EnergyBalance
        (
            *model_,
            now_.state,
            now_.externalForce,
            integrator_->massDamping()
        )
    );
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::shellModel::shellModel(const objectRegistry& db)
:
    regIOobject
    (
        IOobject
        (
            typeName,
            db.time().timeName(),
            db.time(),
            IOobject::NO_READ,
            IOobject::AUTO_WRITE
        )
    ),
    runTime_(db.time()),
    properties_
    (
        IOobject
        (
            "shellProperties",
            runTime_.constant(),
            runTime_,
            IOobject::MUST_READ,
            IOobject::NO_WRITE
        )
    ),
    dynamic_(readDynamic(properties_))
{
    checkKeywords
    (
        properties_,
        {
            "mesh", "sections", "constraints", "loads", "analysis",
            "timeIntegrator", "staticMethod", "massDamping", "errorTolerance",
            "newton", "elementForm", "integration", "vtk", "results"
        }
    );

    makeModel();
    makeIntegrator();
    start();

    if (properties_.lookupOrDefault<Switch>("vtk", true))
    {
        vtk_.reset
        (
            new shellVTK
            (
                runTime_,
                *model_,
                properties_.lookupOrDefault<word>("mesh", "shell"),
                shellResultFields
                (
                    properties_.subOrEmptyDict("results"), *model_
                )
            )
        );
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::shellModel::declared(const Time& runTime)
{
    return shellFileExists(runTime, runTime.constant(), "shellProperties");
}


Foam::scalar Foam::shellModel::maxDisplacement() const
{
    using positionalShell::Component;

    return max
    (
        mag
        (
            nodeVectors(now_.state.position, Component::x)
          - nodeVectors(mesh().initialPositions(), Component::x)
        )
    );
}


bool Foam::shellModel::planeStrain() const
{
    return stripDirection() != vector::zero;
}


Foam::vector Foam::shellModel::stripDirection() const
{
    return planeStrainDirection(properties_.subDict("constraints"));
}


Foam::scalar Foam::shellModel::stripWidth() const
{
    const vector direction(stripDirection());

    scalar lowest = GREAT;
    scalar highest = -GREAT;
    for (const positionalShell::Vec3& node : mesh().nodes())
    {
        const scalar s = direction & toFoam(node);
        lowest = min(lowest, s);
        highest = max(highest, s);
    }
    return highest - lowest;
}
