/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// A step of the gas takes no memory from the system once buffers have their
// size. Replaces operator new of this whole test program by one that counts.

#include "gasCase.H"

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

namespace
{

long nAllocations = 0;

void* counted(std::size_t size)
{
    ++nAllocations;
    void* p = std::malloc(size ? size : 1);
    if (!p)
    {
        throw std::bad_alloc();
    }
    return p;
}

} // End namespace

void* operator new(std::size_t size) { return counted(size); }
void* operator new[](std::size_t size) { return counted(size); }
void operator delete(void* p) noexcept { std::free(p); }
void operator delete[](void* p) noexcept { std::free(p); }
void operator delete(void* p, std::size_t) noexcept { std::free(p); }
void operator delete[](void* p, std::size_t) noexcept { std::free(p); }

using namespace Foam;

namespace
{

//- Allocations in ten steps with the stable step's search
long allocations(const boxMesh& box, const std::string& schemes)
{
    gasSettings s;
    s.box = box;
    s.schemes = schemes;
    s.allPatches("wall");
    s.boundary["left"] = "farField";
    s.start = [](const point& x)
    {
        const bool inside = x.x() < 0.3;
        return testGas::state(inside ? 4e5 : 1e5, Zero, inside ? 3 : 1.2);
    };
    gasCase gas(s);
    auto step = [&]
    {
        gas.gas().advance(0.4*gas.gas().stable().deltaT);
    };
    for (label i = 0; i < 5; ++i)
    {
        step();
    }
    const long before = nAllocations;
    for (label i = 0; i < 10; ++i)
    {
        step();
    }
    return nAllocations - before;
}

} // End namespace


TEST(Allocations, stepsOnAMeshAtRestTakeNone)
{
    const boxMesh boxes[] =
    {
        boxMesh::lines(40), boxMesh::plane(12, 8), boxMesh::space(8, 5, 4)
    };
    for (const boxMesh& box : boxes)
    {
        for
        (
            const std::string capturing
          : {"fluxCorrected", "pressureSwitch", "pressureLaplacian", "none"}
        )
        {
            EXPECT_EQ
            (
                allocations
                (
                    box, "timeScheme twoStep; shockCapturing " + capturing + ";"
                ),
                0
            )   << capturing;
        }
    }
}


TEST(Allocations, areCounted)
{
    const long before = nAllocations;
    const std::vector<double> some(100, 1.0);
    EXPECT_EQ(nAllocations - before, long(some[0]));
}
