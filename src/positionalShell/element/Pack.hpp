// SPDX-License-Identifier: GPL-3.0-or-later
//
// Four doubles that are computed on together: the element kernel runs on four
// elements at once, one per lane. Uses the vector extension of GCC and Clang, with
// registers as wide as those of the instruction set in force.
//
// Included by the batch kernels only, each time within a namespace of its own
// (SHELL_KERNEL_NAMESPACE): the same names then stand for different machine code.
// SHELL_REGISTER_DOUBLES says how many doubles a register holds.

#if !defined(SHELL_KERNEL_NAMESPACE) || !defined(SHELL_REGISTER_DOUBLES)
    #error "Pack.hpp belongs to the batch kernels"
#endif

// Inlined always: a call would cost more than what it computes
#define SHELL_INLINE inline __attribute__((always_inline))

#include "ElementBatch.hpp"

namespace positionalShell
{

namespace SHELL_KERNEL_NAMESPACE
{

// The alignment is given because GCC, for a vector wider than the baseline
// instruction set knows, takes that of the baseline
struct alignas(SHELL_REGISTER_DOUBLES*sizeof(double)) Pack
{
    static constexpr int width = SHELL_REGISTER_DOUBLES;
    static constexpr int parts = lanes/width;

    typedef double Register __attribute__((vector_size(width*sizeof(double))));

    Register v[parts];

    Pack() = default;

    SHELL_INLINE Pack(double x)
    {
        for (int i = 0; i < parts; ++i) v[i] = x - Register{};
    }

    SHELL_INLINE Pack(const LaneValues& x)
    {
        for (int i = 0; i < parts; ++i)
        {
            __builtin_memcpy(&v[i], x.lane + i*width, sizeof(Register));
        }
    }

    SHELL_INLINE void store(LaneValues& x) const
    {
        for (int i = 0; i < parts; ++i)
        {
            __builtin_memcpy(x.lane + i*width, &v[i], sizeof(Register));
        }
    }

    SHELL_INLINE Pack& operator+=(const Pack& b)
    {
        for (int i = 0; i < parts; ++i) v[i] += b.v[i];
        return *this;
    }
};

SHELL_INLINE Pack operator+(const Pack& a, const Pack& b)
{
    Pack c;
    for (int i = 0; i < Pack::parts; ++i) c.v[i] = a.v[i] + b.v[i];
    return c;
}

SHELL_INLINE Pack operator-(const Pack& a, const Pack& b)
{
    Pack c;
    for (int i = 0; i < Pack::parts; ++i) c.v[i] = a.v[i] - b.v[i];
    return c;
}

SHELL_INLINE Pack operator*(const Pack& a, const Pack& b)
{
    Pack c;
    for (int i = 0; i < Pack::parts; ++i) c.v[i] = a.v[i]*b.v[i];
    return c;
}

SHELL_INLINE Pack operator*(double a, const Pack& b)
{
    return Pack(a)*b;
}

} // namespace SHELL_KERNEL_NAMESPACE

} // namespace positionalShell
