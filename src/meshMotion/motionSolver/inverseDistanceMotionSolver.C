/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "inverseDistanceMotionSolver.H"
#include "addToRunTimeSelectionTable.H"
#include "pointConstraints.H"
#include "valuePointPatchField.H"

namespace Foam
{
    defineTypeNameAndDebug(inverseDistanceMotionSolver, 0);
    addToRunTimeSelectionTable
    (
        motionSolver,
        inverseDistanceMotionSolver,
        dictionary
    );
}


// * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * * //

void Foam::inverseDistanceMotionSolver::checkFixedValues() const
{
    for (const label patchi : fixedPatches_)
    {
        const auto& pf = pointDisplacement_.boundaryField()[patchi];
        if
        (
            isA<valuePointPatchField<vector>>(pf)
         && gMax(mag(refCast<const valuePointPatchField<vector>>(pf))) > 0
        )
        {
            FatalIOErrorInFunction(coeffDict())
                << "pointDisplacement is not zero on the fixed patch "
                << pf.patch().name() << " at time " << time().timeName() << nl
                << "    Add the patch to movingPatches" << nl
                << exit(FatalIOError);
        }
    }
}


Foam::vectorField Foam::inverseDistanceMotionSolver::nodeValues
(
    const vectorField& moving
) const
{
    vectorField values(setUp_->scene.size(), Zero);

    const labelList& gathered = setUp_->moving->gatheredOfNode();
    forAll(gathered, node)
    {
        if (gathered[node] >= 0)
        {
            values[node] = moving[gathered[node]];
        }
    }

    vectorField targetValues;
    setUp_->weights->apply(moving, targetValues);
    forAll(targetValues, i)
    {
        values[setUp_->targets[i]] = setUp_->scales[i]*targetValues[i];
    }
    return values;
}


void Foam::inverseDistanceMotionSolver::setPoints
(
    const vectorField& nodeValues,
    const bool onlyBoundary
)
{
    const sceneNodes& scene = setUp_->scene;
    const labelList& moving = setUp_->moving->gatheredOfNode();
    const labelList& fixed = setUp_->fixed->gatheredOfNode();
    vectorField& displacement = pointDisplacement_.primitiveFieldRef();

    forAll(displacement, pointi)
    {
        const label node = scene.nodeOfPoint()[pointi];
        if (!onlyBoundary || moving[node] >= 0 || fixed[node] >= 0)
        {
            displacement[pointi] = scene.toMesh(pointi, nodeValues[node]);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::inverseDistanceMotionSolver::inverseDistanceMotionSolver
(
    const polyMesh& mesh,
    const IOdictionary& dict
)
:
    displacementMotionSolver(mesh, dict, typeName),
    byArea_(false)
{
    const dictionary& coeffs = this->subDict(typeName + "Coeffs");

    readSettings(coeffs);
    readPatches(coeffs);
    checkPatchFields(coeffs);
    makeSetUp();
    report();
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::tmp<Foam::pointField>
Foam::inverseDistanceMotionSolver::curPoints() const
{
    return points0() + pointDisplacement_.primitiveField();
}


Foam::tmp<Foam::pointField> Foam::inverseDistanceMotionSolver::newPoints()
{
    solve();
    tmp<pointField> points(curPoints());
    const volumeWatch::place least
    (
        watch_->least(volumeWatch::cellVolumes(mesh(), points()))
    );
    if (watch_->tooSmall(least))
    {
        const word refused(time().timeName());
        volumeWatch::setTimeBack(mesh());
        volumeWatch::setDisplacement
        (
            pointDisplacement_,
            mesh().points() - points0()
        );
        watch_->stop(least, refused);
    }
    watch_->report(least);
    return points;
}


void Foam::inverseDistanceMotionSolver::solve()
{
    pointDisplacement_.boundaryFieldRef().updateCoeffs();
    checkFixedValues();

    const vectorField values
    (
        nodeValues(setUp_->moving->values(pointDisplacement_))
    );
    setPoints(values, false);

    // Takes the round-off normal to sliding patches away. This also sets value
    // types, the last patch last; moving and fixed points have their own rule.
    pointConstraints::New(pointDisplacement_.mesh()).constrain
    (
        pointDisplacement_,
        false
    );
    setPoints(values, true);
}


void Foam::inverseDistanceMotionSolver::updateMesh(const mapPolyMesh& mpm)
{
    displacementMotionSolver::updateMesh(mpm);
    makeSetUp();
}
