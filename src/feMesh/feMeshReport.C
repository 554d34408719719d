/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// What the mesh is, for the log

#include "feMesh.H"
#include "Tuple2.H"

namespace
{

using namespace Foam;

using valueAt = Tuple2<scalar, point>;

//- The greatest value of all processors and where it is
valueAt greatest(const valueAt& own)
{
    List<valueAt> all(Pstream::nProcs());
    all[Pstream::myProcNo()] = own;
    Pstream::gatherList(all);
    Pstream::scatterList(all);
    valueAt result(all[0]);
    for (const valueAt& other : all)
    {
        if (other.first() > result.first())
        {
            result = other;
        }
    }
    return result;
}


//- Longest edge over least height of a simplex
template<int dim>
scalar aspectRatio(const feMesh& mesh, const label s)
{
    simplexVec<dim> x[dim + 1];
    for (int a = 0; a <= dim; ++a)
    {
        x[a] = mesh.components<dim>
        (
            mesh.corners()[mesh.simplexCorners()[(dim + 1)*s + a]]
        );
    }
    scalar longest = 0;
    for (int a = 0; a <= dim; ++a)
    {
        for (int b = 0; b < a; ++b)
        {
            longest = max(longest, (x[a] - x[b]).norm());
        }
    }

    // Height over node a = 1/|grad N_a|, and B = V grad N
    const Eigen::Matrix<double, dim, dim> e = simplex::edges<dim>(x);
    const Eigen::Matrix<double, dim, dim> rest =
        Eigen::Matrix<double, dim, dim>::Zero();
    const scalar steepest =
        std::sqrt(simplex::areas(e, rest).colwise().squaredNorm().maxCoeff());
    return longest*steepest/simplex::volume<dim>(e);
}

} // End namespace


Foam::scalar Foam::feMesh::aspectRatio(const label s) const
{
    switch (dim_)
    {
        case 1: return 1;
        case 2: return ::aspectRatio<2>(*this, s);
        default: return ::aspectRatio<3>(*this, s);
    }
}


namespace
{

//- Smallest and largest volume and worst aspect ratio of all processors
struct extremeSimplices
{
    valueAt least = valueAt(-GREAT, Zero);
    valueAt largest = least;
    valueAt worst = least;

    explicit extremeSimplices(const feMesh& mesh)
    {
        for (label s = 0; s < mesh.nSimplices(); ++s)
        {
            auto take = [&](valueAt& extreme, const scalar value)
            {
                if (value > extreme.first())
                {
                    extreme = valueAt(value, centre(mesh, s));
                }
            };
            take(least, -mesh.simplexVolume(s));
            take(largest, mesh.simplexVolume(s));
            take(worst, mesh.aspectRatio(s));
        }
        least = greatest(least);
        least.first() *= -1;
        largest = greatest(largest);
        worst = greatest(worst);
    }

    static point centre(const feMesh& mesh, const label s)
    {
        const label stride = mesh.dim() + 1;
        point sum(Zero);
        for (label a = 0; a < stride; ++a)
        {
            sum += mesh.corners()[mesh.simplexCorners()[stride*s + a]];
        }
        return sum/stride;
    }
};


Ostream& print(Ostream& os, const char* what, const valueAt& v)
{
    return os << what << v.first() << " at " << v.second();
}


label total(const label own)
{
    return returnReduce(own, sumOp<label>());
}

} // End namespace


void Foam::feMesh::report(Ostream& os) const
{
    const extremeSimplices extremes(*this);
    List<label> counts(splitCounts_);
    Pstream::listCombineGather(counts, plusEqOp<label>());
    Pstream::listCombineScatter(counts);

    os  << "Finite element mesh" << nl << "    dimensions   : " << dim_;
    if (curvature_)
    {
        os  << (curvature_ == 2 ? ", spherical"
              : dim_ == 1 ? ", cylindrical" : ", axisymmetric")
            << ", r in " << vector::componentNames[radialComponent_];
    }
    os  << nl
        << "    nodes        : " << total(exchange_.nOwned()) << nl
        << "    simplices    : " << total(nSimplices()) << nl
        << "    edges        : " << total(edgeExchange_.nOwned()) << nl
        << "    cells        : " << counts[untouched] << " as they are, "
        << counts[fiveTetrahedra] << " in five tetrahedra, "
        << counts[cone] << " from their first point," << nl
        << "                   " << counts[otherCone] << " in another way, "
        << counts[searched] << " by search" << nl;
    print(os, "    volume [m3]  : least ", extremes.least) << nl;
    print(os, "                   largest ", extremes.largest) << nl;
    if (dim_ > 1)
    {
        print(os, "    aspect ratio : worst ", extremes.worst)
            << " (longest edge over least height)" << nl;
    }
    os  << endl;
}
