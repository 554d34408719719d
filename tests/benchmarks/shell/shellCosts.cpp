// SPDX-License-Identifier: GPL-3.0-or-later
//
// Processor times of the shell library, for shellBenchmark.py.
//
//     shell <n> <displacement|assumedStrain> <seconds>
//
// A square wall of n x n quadrilaterals (2 n^2 triangles), clamped at its foot,
// under Friedlander's blast. Prints lines "name value": times in s of one
// call each, the median of as many as begin within the given time; steps begin
// within ten times as long, 60 at most.

#include "Constraints.hpp"
#include "CubicTriangle.hpp"
#include "FollowerPressure.hpp"
#include "LinearSolver.hpp"
#include "Newmark.hpp"
#include "BlastWave.hpp"
#include "Quadrature.hpp"
#include "SaintVenantKirchhoff.hpp"
#include "StructuredMesh.hpp"
#include "straightforwardTangent.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <iostream>
#include <stdexcept>

using namespace positionalShell;

namespace
{

// Aluminium, 1 m high, 5 mm thick; 50 kPa at first: bends by a tenth of its
// height within the steps that are taken
constexpr double E = 7e10;
constexpr double nu = 0.3;
constexpr double rho = 2700;
constexpr double thickness = 0.005;
constexpr double deltaT = 5e-5;
constexpr int maxSteps = 60;

double processorTime()
{
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return t.tv_sec + 1e-9*t.tv_nsec;
}

//- Median of the times of single calls
double timeOf(double seconds, const std::function<void()>& call)
{
    std::vector<double> times;
    const double start = processorTime();
    while (times.empty() || processorTime() - start < seconds)
    {
        const double before = processorTime();
        call();
        times.push_back(processorTime() - before);
    }
    std::sort(times.begin(), times.end());
    return times[times.size()/2];
}

void print(const char* name, double value)
{
    std::cout << name << ' ' << value << '\n';
}

struct Wall
{
    ShellMesh mesh;
    ShellModel model;

    Wall(int n, ElementForm form)
    :
        mesh(rectangleMesh(n, n, Vec3::Zero(), {0, 1, 0}, {0, 0, 1})),
        model
        (
            mesh,
            {{"all", thickness, std::make_shared<SaintVenantKirchhoff>(E, nu, rho)}},
            Constraints(mesh).clamped("vMin").dofMap(), {}, form
        )
    {}

    Loads blast() const
    {
        auto wave = std::make_shared<BlastWave>();
        wave->centre = Vec3(2, 0.5, 0);
        wave->referenceDistance = 2;
        wave->peak = 5e4;
        wave->peakExponent = 1;
        wave->speed = 500;
        wave->duration = 2e-3;
        return {std::make_shared<FollowerPressure>(model, "all", wave)};
    }
};

//- A state of finite bending
Vector bent(const ShellMesh& mesh)
{
    Vector q = mesh.initialPositions();
    for (int i = 0; i < mesh.nNodes(); ++i)
    {
        const double z = mesh.nodes()[i][2];
        q[7*i] += 0.1*z*z;
        q[7*i + 5] -= 0.2*z;
        q[7*i + 6] += 1e-4*z;
    }
    return q;
}

//- Integration points as ShellModel has them by default
std::vector<PlainPoint> plainPoints(const IntegrationOptions& rule)
{
    std::vector<PlainPoint> points;
    for (const TrianglePoint& t : triangleRule(rule.areaPoints))
    {
        const auto N = CubicTriangle::values(t.xi1, t.xi2);
        const auto dN = CubicTriangle::gradients(t.xi1, t.xi2);
        for (const LinePoint& z : gaussRule(rule.thicknessPoints))
        {
            PlainPoint p;
            p.zeta = z.xi;
            p.weight = t.weight*z.weight;
            for (int j = 0; j < nodesPerElement; ++j)
            {
                p.N[j] = N[j];
                p.dN[0][j] = dN(j, 0);
                p.dN[1][j] = dN(j, 1);
            }
            points.push_back(p);
        }
    }
    return points;
}

//- Tangent of all elements, element matrices full
class Straightforward
{
public:

    explicit Straightforward(const ShellModel& model)
    :
        model_(model),
        initial_(model.mesh().initialPositions()),
        points_(plainPoints(model.integration()))
    {}

    //- Into the sparse matrix entry by entry, unless null
    void tangent(const Vector& q, SystemMatrix* K) const
    {
        double initial[nUnknowns];
        double unknowns[nUnknowns];
        double matrix[nUnknowns][nUnknowns];
        const PlainElement element
        {
            initial, thickness/2, E*nu/((1 + nu)*(1 - 2*nu)), E/(2*(1 + nu))
        };
        for (int e = 0; e < model_.mesh().nElements(); ++e)
        {
            const Triangle& t = model_.mesh().triangle(e);
            for (int j = 0; j < nodesPerElement; ++j)
            {
                for (int c = 0; c < dofsPerNode; ++c)
                {
                    initial[7*j + c] = initial_[7*t[j] + c];
                    unknowns[7*j + c] = q[7*t[j] + c];
                }
            }
            straightforwardTangent
            (
                element, points_.data(), int(points_.size()), unknowns, matrix
            );
            if (!K) continue;
            for (int r = 0; r < nUnknowns; ++r)
            {
                for (int s = 0; s <= r; ++s)
                {
                    K->addSymmetricEntry(e, r, s, matrix[r][s]);
                }
            }
        }
    }

private:

    const ShellModel& model_;
    const Vector initial_;
    const std::vector<PlainPoint> points_;
};

//- Both tangents are the same, or the comparison means nothing
void check(const ShellModel& model, const Vector& q, SystemMatrix& K)
{
    K.setZero();
    Straightforward(model).tangent(q, &K);
    const SparseMatrix ours = model.tangent(q);
    const double error = (SparseMatrix(K.matrix()) - ours).norm()/ours.norm();
    if (!(error < 1e-12))
    {
        throw std::runtime_error
        (
            "the straightforward tangent differs from the library's by "
          + std::to_string(error)
        );
    }
    print("tangentDifference", error);
}

void elementTimes(const Wall& wall, double seconds)
{
    const ShellModel& model = wall.model;
    const Vector q = bent(wall.mesh);
    SystemMatrix K = model.makeMatrix();

    print("tangent", timeOf(seconds, [&] { K.setZero(); model.addTangent(q, K); }));
    Vector force = Vector::Zero(q.size());
    print("residual", timeOf(seconds, [&] { model.addInternalForce(q, force); }));

    if (model.elementForm() == ElementForm::displacement)
    {
        check(model, q, K);
        const Straightforward plain(model);
        print("straightforward", timeOf(seconds, [&]
        {
            K.setZero();
            plain.tangent(q, &K);
        }));
    }
}

void solverTimes(const Wall& wall, double seconds)
{
    const ShellModel& model = wall.model;
    SystemMatrix K = model.makeMatrix();
    model.addTangent(wall.mesh.initialPositions(), K);
    model.addMass(4/(deltaT*deltaT), K);

    LinearSolver solver;
    const double start = processorTime();
    solver.factorise(K);
    const double both = processorTime() - start;
    const double numeric = timeOf(seconds, [&] { solver.factorise(K); });
    print("firstFactorisation", both);
    print("factorisation", numeric);
    if (solver.report().last != Factorisation::cholesky)
    {
        throw std::runtime_error("the matrix is not positive definite");
    }
    const Vector b = Vector::Ones(K.nEquations());
    print("solve", timeOf(seconds, [&] { solver.solve(b); }));
    print("equations", K.nEquations());
}

//- Steps through the blast; with the tangent of every iteration, or kept factors
void motion(const Wall& wall, TangentUpdate update, const char* name, double seconds)
{
    NewmarkOptions options;
    options.newton.tangentUpdate = update;
    Newmark newmark(wall.model, options);
    const Loads loads = wall.blast();
    ShellState state = wall.model.initialState();
    newmark.initialise(state, loads);

    const int before = newmark.linearReport().nCholesky + newmark.linearReport().nLU;
    int iterations = 0;
    const double start = processorTime();
    int nSteps = 0;
    for (; nSteps < maxSteps; ++nSteps)
    {
        if (nSteps > 0 && processorTime() - start > 10*seconds) break;
        DynamicStep step = newmark.step(state, deltaT, loads);
        if (!step.converged) throw std::runtime_error(step.report.describe());
        iterations += step.report.iterations;
        state = std::move(step.state);
    }
    const double time = processorTime() - start;

    const LinearSolverReport report = newmark.linearReport();
    const std::string prefix(name);
    print((prefix + "Steps").c_str(), nSteps);
    print((prefix + "Step").c_str(), time/nSteps);
    print((prefix + "Iteration").c_str(), time/iterations);
    print((prefix + "IterationsPerStep").c_str(), double(iterations)/nSteps);
    print((prefix + "Factorisations").c_str(), report.nCholesky + report.nLU - before);
    const int corner = wall.mesh.nodeSet("uMinVMax")[0];
    print((prefix + "Deflection").c_str(), state.position[7*corner]);
}

} // namespace

int main(int argc, char* argv[])
{
    try
    {
        if (argc != 4)
        {
            throw std::invalid_argument("usage: shell <n> <element form> <seconds>");
        }
        const double seconds = std::stod(argv[3]);
        const Wall wall(std::stoi(argv[1]), elementForm(argv[2]));
        std::cout.precision(8);
        print("elements", wall.mesh.nElements());
        elementTimes(wall, seconds);
        solverTimes(wall, seconds);
        if (wall.mesh.nElements() < 2000)   // Minutes of UMFPACK above
        {
            motion(wall, TangentUpdate::everyIteration, "newton", seconds);
        }
        motion(wall, TangentUpdate::whenSlow, "kept", seconds);
        return 0;
    }
    catch (const std::exception& problem)
    {
        std::cerr << "shell: error: " << problem.what() << '\n';
        return 1;
    }
}
