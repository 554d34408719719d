// SPDX-License-Identifier: GPL-3.0-or-later

#include "ShellModel.hpp"
#include "CubicTriangle.hpp"
#include "ElementData.hpp"
#include "Quadrature.hpp"

#include <Eigen/Geometry>

#include <stdexcept>

namespace positionalShell
{

namespace
{

using BasisProducts =
    Eigen::Matrix<double, nodesPerElement, nodesPerElement>;

std::vector<int> sectionOfElements
(
    const ShellMesh& mesh,
    const std::vector<Section>& sections
)
{
    std::vector<int> sectionOf(mesh.nElements(), -1);
    for (std::size_t s = 0; s < sections.size(); ++s)
    {
        const std::string& set = sections[s].elementSet;
        if (!(sections[s].thickness > 0))
        {
            throw std::invalid_argument
            (
                "shell model: the section of element set " + set
              + " has thickness " + std::to_string(sections[s].thickness)
              + "; it must be positive"
            );
        }
        if (!sections[s].material)
        {
            throw std::invalid_argument
            (
                "shell model: the section of element set " + set
              + " has no material"
            );
        }
        if (sections[s].material->directional() && sections[s].axis.isZero())
        {
            throw std::invalid_argument
            (
                "shell model: material " + sections[s].material->name()
              + " of element set " + set + " needs the axis of its direction 1"
            );
        }
        for (int e : mesh.elementSet(set))
        {
            if (sectionOf[e] >= 0)
            {
                throw std::invalid_argument
                (
                    "shell model: element " + std::to_string(e)
                  + " belongs to two sections, of the element sets "
                  + sections[sectionOf[e]].elementSet + " and " + set
                );
            }
            sectionOf[e] = int(s);
        }
    }
    for (std::size_t e = 0; e < sectionOf.size(); ++e)
    {
        if (sectionOf[e] < 0)
        {
            throw std::invalid_argument
            (
                "shell model: element " + std::to_string(e)
              + " belongs to no section"
            );
        }
    }
    return sectionOf;
}

DofMap checked(DofMap dofs, const ShellMesh& mesh)
{
    if (dofs.nFull() != dofsPerNode*mesh.nNodes())
    {
        throw std::invalid_argument
        (
            "shell model: the map of unknowns is for "
          + std::to_string(dofs.nFull()/dofsPerNode) + " nodes, the mesh has "
          + std::to_string(mesh.nNodes())
        );
    }
    return dofs;
}

//- X,1 x X,2 of positions taken from a full vector
Vec3 areaVector
(
    const Triangle& triangle,
    const Vector& q,
    const CubicTriangle::Gradients& dN
)
{
    Vec3 x1 = Vec3::Zero();
    Vec3 x2 = Vec3::Zero();
    for (int j = 0; j < nodesPerElement; ++j)
    {
        const auto x = q.segment<3>(dofsPerNode*triangle[j]);
        x1 += dN(j, 0)*x;
        x2 += dN(j, 1)*x;
    }
    return x1.cross(x2);
}

//- Integral of N_i N_j over the mid-surface of an element
BasisProducts basisProducts(const Triangle& triangle, const Vector& q)
{
    BasisProducts products = BasisProducts::Zero();
    for (const TrianglePoint& p : triangleRuleOfDegree(10))
    {
        const auto N = CubicTriangle::values(p.xi1, p.xi2);
        const auto dN = CubicTriangle::gradients(p.xi1, p.xi2);
        products +=
            p.weight*areaVector(triangle, q, dN).norm()*N*N.transpose();
    }
    return products;
}

//- Scalar products over nodes of one component triple of full vectors
template<class Operation>
void forEach(const SparseMatrix& M, const Operation& operation)
{
    for (int j = 0; j < M.cols(); ++j)
    {
        for (SparseMatrix::InnerIterator it(M, j); it; ++it)
        {
            operation(int(it.row()), j, it.value());
        }
    }
}

//- Position part of a node in a full vector starts here, director part there
constexpr int positionOffset = 0;
constexpr int directorOffset = 3;

Vec3 momentOf
(
    const SparseMatrix& M,
    int offset,
    const Vector& q,
    const Vector& v
)
{
    Vec3 sum = Vec3::Zero();
    forEach
    (
        M,
        [&](int i, int j, double m)
        {
            const Vec3 arm = q.segment<3>(dofsPerNode*i + offset);
            const Vec3 rate = v.segment<3>(dofsPerNode*j + offset);
            sum += m*arm.cross(rate);
        }
    );
    return sum;
}

} // namespace

ShellModel::ShellModel
(
    ShellMesh mesh,
    std::vector<Section> sections,
    DofMap dofs,
    IntegrationOptions integration,
    ElementForm form
)
:
    mesh_(std::move(mesh)),
    sections_(std::move(sections)),
    dofs_(checked(std::move(dofs), mesh_)),
    integration_(integration),
    form_(form),
    sectionOfElement_(sectionOfElements(mesh_, sections_)),
    elements_
    (
        new ElementData
        (
            mesh_, sections_, sectionOfElement_,
            integration.areaPoints, integration.thicknessPoints, form
        )
    ),
    sparsity_(std::make_shared<SparsityMap>(mesh_, dofs_)),
    mass_(sparsity_)
{
    makeMass();
}

ShellModel::~ShellModel() = default;

const Section& ShellModel::section(int element) const
{
    return sections_[sectionOfElement_[element]];
}

ShellState ShellModel::initialState(double t) const
{
    ShellState state;
    state.time = t;
    state.position = mesh_.initialPositions();
    state.velocity = Vector::Zero(dofs_.nFull());
    state.acceleration = Vector::Zero(dofs_.nFull());
    dofs_.setPrescribedPositions(t, state.position);
    dofs_.setPrescribedRates(t, state.velocity, state.acceleration);
    return state;
}

double ShellModel::strainEnergy(const Vector& q) const
{
    return elements_->energy(q);
}

Vector ShellModel::internalForce(const Vector& q) const
{
    Vector force = Vector::Zero(dofs_.nFull());
    elements_->addForce(q, force);
    return force;
}

void ShellModel::addInternalForce(const Vector& q, Vector& force) const
{
    elements_->addForce(q, force);
}

void ShellModel::addTangent(const Vector& q, SystemMatrix& K) const
{
    elements_->addTangent(q, K);
}

void ShellModel::addTangent
(
    const StressPrediction& stress,
    const Vector& q,
    SystemMatrix& K
) const
{
    elements_->addExtrapolatedTangent(stress, q, K);
}

void ShellModel::addConservingForce
(
    const Vector& start,
    const Vector& end,
    Vector& force
) const
{
    elements_->addConservingForce(start, end, force);
}

void ShellModel::addConservingTangent
(
    const StressPrediction& endStress,
    const Vector& start,
    const Vector& end,
    SystemMatrix& K
) const
{
    elements_->addConservingTangent(endStress, start, end, K);
}

SparseMatrix ShellModel::tangent(const Vector& q) const
{
    SystemMatrix K = makeMatrix();
    addTangent(q, K);
    return K.matrix();
}

double ShellModel::minimumVolumeRatio(const Vector& q) const
{
    return elements_->leastVolumeRatio(q);
}

std::vector<Strain> ShellModel::strainGaps(const Vector& q) const
{
    return elements_->strainGaps(q);
}

void ShellModel::makeMass()
{
    using Entry = Eigen::Triplet<double>;
    const Vector q0 = mesh_.initialPositions();
    std::vector<Entry> position;
    std::vector<Entry> director;
    for (int e = 0; e < mesh_.nElements(); ++e)
    {
        const Triangle& triangle = mesh_.triangle(e);
        const double h = thickness(e);
        const double rho = section(e).material->density();
        const BasisProducts products = basisProducts(triangle, q0);
        for (int j = 0; j < nodesPerElement; ++j)
        {
            for (int i = 0; i < nodesPerElement; ++i)
            {
                const double m = rho*h*products(i, j);
                const double rotary = m*h*h/12;
                position.emplace_back(triangle[i], triangle[j], m);
                director.emplace_back(triangle[i], triangle[j], rotary);
                if (i < j) continue;
                for (int c = 0; c < 6; ++c)
                {
                    mass_.addSymmetricEntry
                    (
                        e, dofsPerNode*i + c, dofsPerNode*j + c,
                        c < directorOffset ? m : rotary
                    );
                }
            }
        }
    }
    positionMass_.resize(mesh_.nNodes(), mesh_.nNodes());
    directorMass_.resize(mesh_.nNodes(), mesh_.nNodes());
    positionMass_.setFromTriplets(position.begin(), position.end());
    directorMass_.setFromTriplets(director.begin(), director.end());

    massless_.assign(dofs_.nEquations(), true);
    for (int i = 0; i < dofs_.nFull(); ++i)
    {
        const bool thickness =
            i%dofsPerNode == static_cast<int>(Component::a);
        const int equation = dofs_.equation(i);
        if (equation >= 0 && !thickness) massless_[equation] = false;
    }
}

Vector ShellModel::massTimes(const Vector& v) const
{
    Vector f = Vector::Zero(dofs_.nFull());
    addMassTimes(1, v, f);
    return f;
}

void ShellModel::addMassTimes(double factor, const Vector& v, Vector& f) const
{
    // Both matrices have the same pattern: one pass
    const int* start = positionMass_.outerIndexPtr();
    const int* inner = positionMass_.innerIndexPtr();
    const double* mass = positionMass_.valuePtr();
    const double* rotary = directorMass_.valuePtr();
    for (int j = 0; j < mesh_.nNodes(); ++j)
    {
        const Vec3 rate = factor*v.segment<3>(dofsPerNode*j);
        const Vec3 spin =
            factor*v.segment<3>(dofsPerNode*j + directorOffset);
        for (int k = start[j]; k < start[j + 1]; ++k)
        {
            double* node = f.data() + dofsPerNode*inner[k];
            for (int c = 0; c < 3; ++c)
            {
                node[c] += mass[k]*rate[c];
                node[directorOffset + c] += rotary[k]*spin[c];
            }
        }
    }
}

void ShellModel::addMass(double factor, SystemMatrix& K) const
{
    K.addScaled(factor, mass_);
}

SparseMatrix ShellModel::massMatrix() const
{
    return mass_.matrix();
}

double ShellModel::totalMass() const
{
    return positionMass_.sum();
}

double ShellModel::kineticEnergy(const Vector& v) const
{
    return 0.5*v.dot(massTimes(v));
}

Vec3 ShellModel::linearMomentum(const Vector& v) const
{
    Vec3 sum = Vec3::Zero();
    forEach
    (
        positionMass_,
        [&](int, int j, double m) { sum += m*v.segment<3>(dofsPerNode*j); }
    );
    return sum;
}

Vec3 ShellModel::angularMomentum(const Vector& q, const Vector& v) const
{
    return momentOf(positionMass_, positionOffset, q, v)
        + momentOf(directorMass_, directorOffset, q, v);
}

Vec3 ShellModel::centreOfMass(const Vector& q) const
{
    return linearMomentum(q)/totalMass();
}

double ShellModel::area(const Vector& q) const
{
    double sum = 0;
    for (const Triangle& triangle : mesh_.triangles())
    {
        for (const TrianglePoint& p : triangleRuleOfDegree(10))
        {
            const auto dN = CubicTriangle::gradients(p.xi1, p.xi2);
            sum += p.weight*areaVector(triangle, q, dN).norm();
        }
    }
    return sum;
}

SystemMatrix ShellModel::makeMatrix() const
{
    return SystemMatrix(sparsity_);
}

} // namespace positionalShell
