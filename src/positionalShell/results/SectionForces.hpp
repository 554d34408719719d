// SPDX-License-Identifier: GPL-3.0-or-later
//
// Forces and moments in a shell, per initial length of the mid-surface, and the frame
// that they are resolved in, (R5)-(R8).
//
//     N[a][b]  membrane force on the section normal to initial axis a, along present
//              axis b [N/m]; N12 and N21 differ by the strain only
//     M[a][b]  moment of the same forces b with the height as lever [N]; positive
//              when the upper face is in tension
//     Q[a]     transverse shear force, along the director [N/m]
//
// Initial axes: 3 along the director; 1 the material's where the section has one, else
// the projection of a given direction onto the shell, or, where the shell is within 6
// degrees of normal to that, of the first of x, y, z that it is not normal to. Present
// axes: 3 along the present director, 1 and 2 the pair nearest to the images of the
// initial ones.

#ifndef positionalShell_SectionForces_hpp
#define positionalShell_SectionForces_hpp

#include "BodyGeometry.hpp"

namespace positionalShell
{

struct SectionForces
{
    Eigen::Matrix2d N = Eigen::Matrix2d::Zero();
    Eigen::Matrix2d M = Eigen::Matrix2d::Zero();
    Eigen::Vector2d Q = Eigen::Vector2d::Zero();
};

//- Initial axes as columns; direction: not zero
Mat3 sectionAxes(const Mat3& G, const Section& section, const Vec3& direction);

//- Present axes as columns, from the base vectors of the mid-surface before and now
Mat3 presentAxes(const Mat3& G, const Mat3& now, const Mat3& axes);

//- Sums over the thickness at a point of the mid-surface
class SectionSums
{
public:

    //- Add what a height contributes: stress S (contravariant, (S9)) times dzeta and
    //  the initial volume det G; now: present base vectors there; lever: p of (S6)
    void add
    (
        const Stress& S,
        double weight,
        const Mat3& now,
        double lever
    );

    //- G: initial base vectors of the mid-surface; stretch: length of the director
    SectionForces forces
    (
        const Mat3& G, const Mat3& axes, const Mat3& present, double stretch
    ) const;

private:

    //- By coordinate surface alpha, as columns
    Eigen::Matrix<double, 3, 2> force_ = Eigen::Matrix<double, 3, 2>::Zero();
    Eigen::Matrix<double, 3, 2> couple_ = Eigen::Matrix<double, 3, 2>::Zero();
};

} // namespace positionalShell

#endif
