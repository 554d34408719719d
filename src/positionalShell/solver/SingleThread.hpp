// SPDX-License-Identifier: GPL-3.0-or-later
//
// While an object of this class lives, OpenMP loops that this thread enters run on it alone.
//
// CHOLMOD asks for four threads whatever the machine and OMP_NUM_THREADS say. For matrices of
// shells they only wait for one another, at full load: the factorisation of 2,400 equations takes
// twice the processor time, and processors that other processes of a parallel run need.

#ifndef positionalShell_SingleThread_hpp
#define positionalShell_SingleThread_hpp

#include <omp.h>

namespace positionalShell
{

class SingleThread
{
public:

    //- No nesting level of loops may be active, not even the outermost
    SingleThread() : before_(omp_get_max_active_levels()) { omp_set_max_active_levels(0); }
    ~SingleThread() { omp_set_max_active_levels(before_); }
    SingleThread(const SingleThread&) = delete;
    SingleThread& operator=(const SingleThread&) = delete;

private:

    int before_;
};

} // namespace positionalShell

#endif
