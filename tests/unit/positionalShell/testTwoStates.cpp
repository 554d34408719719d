// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the elements compute from two states, for every form: the conserving force and
// its tangent, (T4)-(T11), and the tangent with a predicted stress, (N3).

#include "AssumedInterpolation.hpp"
#include "ShellTestModels.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

using namespace shellTest;

namespace
{

class TwoStates : public testing::TestWithParam<ElementForm>
{
protected:

    ShellMesh mesh_ = curvedPatch();
    ShellModel model_
    {
        mesh_, {{"all", 0.2, material(100, 0.3)}}, Constraints(mesh_).dofMap(), {}, GetParam()
    };

    Vector conservingForce(const Vector& start, const Vector& end) const
    {
        Vector f = Vector::Zero(start.size());
        model_.addConservingForce(start, end, f);
        return f;
    }

    //- Tangent at q with the stress of before, extrapolated to after
    SparseMatrix predicted(const Vector& before, const Vector& after, const Vector& q) const
    {
        SystemMatrix K = model_.makeMatrix();
        model_.addTangent({before, after}, q, K);
        return K.matrix();
    }

    SparseMatrix conservingTangent
    (
        const StressPrediction& stress, const Vector& start, const Vector& end
    ) const
    {
        SystemMatrix K = model_.makeMatrix();
        model_.addConservingTangent(stress, start, end, K);
        return K.matrix();
    }
};

std::string formName(const testing::TestParamInfo<ElementForm>& form)
{
    return elementFormName(form.param);
}

INSTANTIATE_TEST_SUITE_P
(
    Shell, TwoStates,
    testing::Values(ElementForm::displacement, ElementForm::assumedStrain), formName
);

//- One batch of the four elements of the patch with random functions, metric and stiffness
struct RandomBatch
{
    ElementRule rule;
    ElementBatch batch{nullptr, 0.1, lanes, {0, 1, 2, 3}, {}, {}, {}};

    explicit RandomBatch(ElementForm form)
    {
        rule.thickness = gaussRule(3);
        rule.area.resize(1);
        rule.area[0].weight = 0.5;
        const Vector random = randomVector(3*nodesPerElement, 5);
        for (int j = 0; j < nodesPerElement; ++j)
        {
            for (int d = 0; d < 3; ++d) rule.area[0].phi[j][d] = random[3*j + d];
        }
        if (form == ElementForm::assumedStrain)
        {
            rule.assumed = assumedInterpolation(triangleRule(7));
            rule.assumed.points.resize(1);
        }
        batch.points.resize(3);
        for (int l = 0; l < lanes; ++l)
        {
            for (ReferencePoint& p : batch.points)
            {
                for (int k = 0; k < 6; ++k) p.metric[k].lane[l] = 0.1*k + l;
                for (int k = 0; k < 21; ++k) p.C[k].lane[l] = 1 + 0.01*k*l;
            }
        }
    }
};

ElementVector randomUnknowns(int seed)
{
    const Vector random = randomVector(dofsPerElement, seed);
    ElementVector q;
    for (int k = 0; k < dofsPerElement; ++k)
    {
        for (int l = 0; l < lanes; ++l) q.x[k].lane[l] = random[k] + 0.1*l;
    }
    return q;
}

std::vector<const BatchKernel*> kernels(ElementForm form)
{
    std::vector<const BatchKernel*> all{&baselineKernel(form)};
    const BatchKernel* fast = avx2Kernel(form);
    if (fast && fast == &batchKernel(form)) all.push_back(fast);
    return all;
}

} // namespace

// The force between two arbitrary states does the work of the strain energy and has no
// resultant and no moment about the middle, (T4)
TEST_P(TwoStates, theForceHasTheWorkAndTheSymmetriesOfTheEnergy)
{
    for (int seed : {1, 3, 5})
    {
        const Vector q0 = randomState(mesh_, 0.1, seed);
        const Vector q1 = randomState(mesh_, 0.1, seed + 1);
        const Vector f = conservingForce(q0, q1);
        const double change = model_.strainEnergy(q1) - model_.strainEnergy(q0);
        EXPECT_NEAR(f.dot(q1 - q0), change, 1e-11*model_.strainEnergy(q0));

        const Vector middle = 0.5*(q0 + q1);
        Vec3 force = Vec3::Zero();
        Vec3 moment = Vec3::Zero();
        for (int i = 0; i < mesh_.nNodes(); ++i)
        {
            const Vec3 onPosition = f.segment<3>(7*i);
            const Vec3 onDirector = f.segment<3>(7*i + 3);
            force += onPosition;
            moment += Vec3(middle.segment<3>(7*i)).cross(onPosition);
            moment += Vec3(middle.segment<3>(7*i + 3)).cross(onDirector);
        }
        EXPECT_LT(force.norm(), 1e-11*f.norm());
        EXPECT_LT(moment.norm(), 1e-11*f.norm());
    }
}

TEST_P(TwoStates, betweenEqualStatesTheForceIsTheInternalOne)
{
    const Vector q = randomState(mesh_, 0.1, 1);
    const Vector internal = model_.internalForce(q);
    EXPECT_LT((conservingForce(q, q) - internal).norm(), 1e-12*internal.norm());
}

// Without extrapolation the tangent differs from the derivative of the force by a term
// of first order in the step
TEST_P(TwoStates, theConservingTangentIsTheDerivativeForSmallSteps)
{
    const Vector q0 = randomState(mesh_, 0.05, 1);
    const Vector away = randomVector(q0.size(), 2);
    const Vector d = randomVector(q0.size(), 3);
    std::vector<double> errors;
    for (double size : {0.0, 1e-4, 2e-4})
    {
        const Vector q1 = q0 + size*away;
        const Vector df = polynomialDerivative<Vector>
        (
            [&](double s) -> Vector { return conservingForce(q0, q1 + s*d); }
        );
        const Vector Kd =
            model_.dofs().expand(conservingTangent({q1, q1}, q0, q1)*model_.dofs().reduce(d));
        errors.push_back((df - Kd).norm()/Kd.norm());
    }
    EXPECT_LT(errors[0], 1e-10);
    EXPECT_GT(errors[1], 1e-7);
    EXPECT_NEAR(errors[2]/errors[1], 2, 0.02);
}

// With start and end anywhere it is half the tangent of the middle with the mean of the
// stresses: of the start's, and of the one predicted for the end
TEST_P(TwoStates, theConservingTangentHasTheMeanStress)
{
    const Vector q0 = randomState(mesh_, 0.05, 1);
    const Vector q1 = randomState(mesh_, 0.05, 2);
    const Vector before = randomState(mesh_, 0.05, 3);
    const Vector after = randomState(mesh_, 0.05, 4);
    const Vector middle = 0.5*(q0 + q1);
    const SparseMatrix expected =
        0.25*predicted(q0, q0, middle) + 0.25*predicted(before, after, middle);
    const SparseMatrix K = conservingTangent({before, after}, q0, q1);
    EXPECT_LT((K - expected).norm(), 1e-12*K.norm());
}

// The stress of the state itself gives the tangent; where it is extrapolated, strain is
// the linear part of a polynomial along the way, and so is this tangent of a linear material
TEST_P(TwoStates, thePredictedStressIsTheLinearPart)
{
    const Vector before = randomState(mesh_, 0.05, 1);
    const Vector after = randomState(mesh_, 0.05, 2);
    const Vector q = randomState(mesh_, 0.05, 3);
    const SparseMatrix exact = model_.tangent(q);
    EXPECT_LT((predicted(q, q, q) - exact).norm(), 1e-12*exact.norm());

    const SparseMatrix rate = polynomialDerivative<SparseMatrix>
    (
        [&](double s) -> SparseMatrix
        {
            const Vector way = before + s*(after - before);
            return predicted(way, way, q);
        }
    );
    const SparseMatrix linear = predicted(before, before, q) + rate;
    const SparseMatrix K = predicted(before, after, q);
    EXPECT_GT(rate.norm(), 1e-2*K.norm());
    EXPECT_LT((K - linear).norm(), 1e-10*K.norm());
}

// Element by element, with each instruction set
TEST_P(TwoStates, theWorkIsThatOfTheEnergyWithEveryInstructionSet)
{
    const RandomBatch own(GetParam());
    const ElementVector q0 = randomUnknowns(1);
    const ElementVector q1 = randomUnknowns(2);
    for (const BatchKernel* kernel : kernels(GetParam()))
    {
        ElementVector f;
        LaneValues energy[2];
        kernel->conservingForce(own.rule, own.batch, q0, q1, f);
        kernel->energy(own.rule, own.batch, q0, energy[0]);
        kernel->energy(own.rule, own.batch, q1, energy[1]);
        for (int l = 0; l < lanes; ++l)
        {
            double work = 0;
            for (int k = 0; k < dofsPerElement; ++k)
            {
                work += f.x[k].lane[l]*(q1.x[k].lane[l] - q0.x[k].lane[l]);
            }
            const double size = std::abs(energy[0].lane[l]) + std::abs(energy[1].lane[l]);
            EXPECT_GT(size, 0);
            EXPECT_NEAR(work, energy[1].lane[l] - energy[0].lane[l], 1e-12*size);
        }
    }
}

TEST_P(TwoStates, vectorInstructionsGiveTheSameTangents)
{
    const auto all = kernels(GetParam());
    if (all.size() < 2) GTEST_SKIP() << "no AVX2 here: nothing to compare";
    ASSERT_EQ(mesh_.nElements(), lanes);

    const RandomBatch own(GetParam());
    ElementVector q[4];
    for (int i = 0; i < 4; ++i) q[i] = randomUnknowns(i + 1);
    SparseMatrix extrapolated[2];
    SparseMatrix conserving[2];
    for (int i : {0, 1})
    {
        SystemMatrix K = model_.makeMatrix();
        all[i]->addExtrapolatedTangent(own.rule, own.batch, q[0], q[1], q[2], K);
        extrapolated[i] = K.matrix();
        SystemMatrix L = model_.makeMatrix();
        all[i]->addConservingTangent(own.rule, own.batch, q[0], q[1], q[2], q[3], L);
        conserving[i] = L.matrix();
    }
    EXPECT_GT(conserving[0].norm(), 0);
    EXPECT_LT((extrapolated[1] - extrapolated[0]).norm(), 1e-13*extrapolated[0].norm());
    EXPECT_LT((conserving[1] - conserving[0]).norm(), 1e-13*conserving[0].norm());
}
