/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "gasGeometry.H"
#include "Time.H"

template<int dim>
Foam::gasGeometry<dim>::gasGeometry(feMesh& mesh)
:
    mesh_(mesh),
    moving_(false),
    hasMoved_(false),
    areas_(mesh.nSimplices()),
    volume_(mesh.nSimplices()),
    inverseHeight_(mesh.nSimplices()),
    nodeVolume_(mesh.nNodes()),
    w_(mesh.nNodes(), Vec::Zero())
{
    compute(mesh_.nodes(), nodeVolume_);
}


template<int dim>
void Foam::gasGeometry<dim>::compute
(
    const pointField& nodePositions,
    std::vector<double>& nodeVolume
)
{
    nodeVolume.assign(nNodes(), 0.0);
    const double depth = mesh_.depth();

    for (label s = 0; s < nSimplices(); ++s)
    {
        Vec x[dim + 1];
        for (int a = 0; a <= dim; ++a)
        {
            x[a] = mesh_.components<dim>(nodePositions[nodes(s)[a]]);
        }
        const Eigen::Matrix<double, dim, dim> e = simplex::edges<dim>(x);
        volume_[s] = depth*simplex::volume<dim>(e);
        if (!(volume_[s] > 0))
        {
            const label celli = mesh_.cellOfSimplex()[s];
            FatalErrorInFunction
                << "The mesh motion has inverted a simplex of cell " << celli
                << " at " << nodePositions[nodes(s)[0]]
                << ": its volume is " << volume_[s] << " m3" << nl
                << "    at time "
                << mesh_.poly().time().timeName() << nl
                << "    Use a finer write interval to see the mesh before, "
                << "and change the motion solver's coefficients or the mesh"
                << exit(FatalError);
        }
        Eigen::Matrix<double, dim, dim> rest =
            Eigen::Matrix<double, dim, dim>::Zero();
        areas_[s] = depth*simplex::areas(e, rest);
        inverseHeight_[s] =
            std::sqrt(areas_[s].colwise().squaredNorm().maxCoeff())
           /volume_[s];
        for (int a = 0; a <= dim; ++a)
        {
            nodeVolume[nodes(s)[a]] += volume_[s]/(dim + 1);
        }
    }
}


template<int dim>
void Foam::gasGeometry<dim>::begin()
{
    moving_ = false;
    if (hasMoved_)
    {
        std::fill(w_.begin(), w_.end(), Vec::Zero());
        hasMoved_ = false;
    }
}


template<int dim>
void Foam::gasGeometry<dim>::begin
(
    const double dt,
    const pointField& newNodes
)
{
    moving_ = true;
    hasMoved_ = true;
    newNodes_ = newNodes;
    stepAreas_.resize(nSimplices());
    newVolume_.resize(nSimplices());
    newNodeVolume_.assign(nNodes(), 0.0);
    const double depth = mesh_.depth();

    for (label a = 0; a < nNodes(); ++a)
    {
        w_[a] = mesh_.components<dim>(newNodes[a] - mesh_.nodes()[a])/dt;
    }

    for (label s = 0; s < nSimplices(); ++s)
    {
        Vec x0[dim + 1], x1[dim + 1];
        for (int a = 0; a <= dim; ++a)
        {
            x0[a] = position(nodes(s)[a]);
            x1[a] = mesh_.components<dim>(newNodes[nodes(s)[a]]);
        }
        const Eigen::Matrix<double, dim, dim> e0 = simplex::edges<dim>(x0);
        const Eigen::Matrix<double, dim, dim> e1 = simplex::edges<dim>(x1);
        const Eigen::Matrix<double, dim, dim> mid = 0.5*(e0 + e1);
        const Eigen::Matrix<double, dim, dim> delta = e1 - e0;
        stepAreas_[s] = depth*simplex::areas(mid, delta);
        newVolume_[s] = depth*simplex::volume<dim>(e1);
        const double share = newVolume_[s]/(dim + 1);
        for (int a = 0; a <= dim; ++a)
        {
            newNodeVolume_[nodes(s)[a]] += share;
        }
    }
}


template<int dim>
void Foam::gasGeometry<dim>::end()
{
    if (moving_)
    {
        mesh_.moveNodes(newNodes_);
        compute(newNodes_, nodeVolume_);
        moving_ = false;
    }
}


template class Foam::gasGeometry<1>;
template class Foam::gasGeometry<2>;
template class Foam::gasGeometry<3>;
