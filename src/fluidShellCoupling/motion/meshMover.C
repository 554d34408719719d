/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "meshMover.H"
#include "inverseDistanceMotionSolver.H"
#include "simplexVolumes.H"
#include "valuePointPatchField.H"

bool Foam::meshMover::declared(const polyMesh& mesh)
{
    return IOobject
    (
        "dynamicMeshDict",
        mesh.time().constant(),
        mesh,
        IOobject::MUST_READ,
        IOobject::NO_WRITE,
        false
    ).typeHeaderOk<IOdictionary>(false);
}


Foam::meshMover::meshMover(polyMesh& mesh)
:
    mesh_(mesh),
    solver_(motionSolver::New(mesh)),
    least_{1, -1, Zero},
    nSolves_(0)
{}


Foam::displacementMotionSolver& Foam::meshMover::displacementSolver()
{
    if (!isA<displacementMotionSolver>(solver_()))
    {
        FatalIOErrorInFunction(solver_())
            << "The motion solver " << solver_->type()
            << " is not a displacement solver" << nl
            << "    Coupled runs need one that moves the mesh by "
            << "pointDisplacement, such as inverseDistance" << nl
            << "    or displacementLaplacian" << exit(FatalIOError);
    }
    return refCast<displacementMotionSolver>(solver_());
}


const Foam::pointField& Foam::meshMover::points0()
{
    return displacementSolver().points0();
}


Foam::tmp<Foam::vectorField> Foam::meshMover::displacement
(
    const feMesh& mesh,
    const interfaceNodes& nodes,
    const vectorField& values
)
{
    displacementMotionSolver& solver = displacementSolver();
    pointVectorField& field = solver.pointDisplacement();

    forAll(nodes.patches(), i)
    {
        const fePatch& patch = *nodes.patches()[i];
        auto& pf = field.boundaryFieldRef()[patch.index];
        if (!isA<valuePointPatchField<vector>>(pf))
        {
            FatalErrorInFunction
                << "pointDisplacement has type " << pf.type()
                << " on the interface patch " << patch.name << " ("
                << field.objectPath() << ")" << nl
                << "    It must be fixedValue, so that the coupling can set it"
                << exit(FatalError);
        }

        auto& pointValues = refCast<valuePointPatchField<vector>>(pf);
        const labelList& points = pf.patch().meshPoints();
        forAll(points, j)
        {
            const label node = mesh.nodeOfPoint()[points[j]];
            pointValues[j] = values[findLower(nodes.nodes(), node + 1)];
        }
    }

    solver.solve();
    ++nSolves_;
    if (isA<inverseDistanceMotionSolver>(solver))
    {
        // Without rounding: zero is zero
        return tmp<vectorField>::New(field.primitiveField());
    }
    return solver.curPoints() - solver.points0();
}


Foam::tmp<Foam::pointField> Foam::meshMover::newPoints()
{
    ++nSolves_;
    if (!isA<displacementMotionSolver>(solver_()))
    {
        return solver_->newPoints();
    }
    solver_->solve();
    return solver_->curPoints();
}


bool Foam::meshMover::accepts
(
    const feMesh& mesh,
    const UList<pointField>& nodes
)
{
    if (!watch_.valid())
    {
        // Other motion solvers know no undeformed mesh: it is that of the
        // first step
        const bool known = isA<points0MotionSolver>(solver_());
        const pointField undeformed
        (
            known
          ? refCast<points0MotionSolver>(solver_()).points0()
          : mesh_.points()
        );
        watch_.reset
        (
            new volumeWatch
            (
                mesh_,
                solver_(),
                simplexVolumes(mesh, mesh.gather(undeformed))
            )
        );
    }

    least_.ratio = GREAT;
    for (const pointField& x : nodes)
    {
        const volumeWatch::place found
        (
            watch_->least(simplexVolumes(mesh, x), mesh.cellOfSimplex())
        );
        if (found.ratio < least_.ratio)
        {
            least_ = found;
        }
    }
    if (watch_->tooSmall(least_))
    {
        return false;
    }
    watch_->report(least_);
    return true;
}


void Foam::meshMover::watch
(
    const feMesh& mesh,
    const pointField& undeformedNodes,
    const cubicMotion& motion,
    const pointField& lastDisplacement,
    const std::function<void()>& goBack
)
{
    // A cubic may go further than its ends
    List<pointField> places;
    for (const scalar s : {0.25, 0.5, 0.75, 1.0})
    {
        places.append(pointField(motion.at(undeformedNodes, s)));
    }
    if (!accepts(mesh, places))
    {
        goBack();
        stop(points0() + lastDisplacement);
    }
}


void Foam::meshMover::reportEnd(const label nShellSteps) const
{
    Info<< "Mesh motion: the motion solver was applied " << nSolves_
        << " times in " << nShellSteps << " shell steps and at the start"
        << endl;
}


void Foam::meshMover::stop(const pointField& lastPoints)
{
    const word refused(mesh_.time().timeName());
    volumeWatch::setTimeBack(mesh_);

    if (isA<displacementMotionSolver>(solver_()))
    {
        displacementMotionSolver& solver = displacementSolver();
        volumeWatch::setDisplacement
        (
            solver.pointDisplacement(),
            lastPoints - solver.points0()
        );
    }
    if (returnReduce(lastPoints != mesh_.points(), orOp<bool>()))
    {
        move(lastPoints);
    }
    watch_->stop(least_, refused);
}
