/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
// Without arguments of its own the program runs the tests. They start it again
// under mpirun, as  feMeshCases -dump -case <case> [-parallel], to write
// what each processor holds to <case>/dump.<number of processors>.<processor>.

#include "argList.H"
#include "feMesh.H"
#include "meshDump.H"
#include "Time.H"

#include <gtest/gtest.h>

namespace
{

int dump(int argc, char* argv[])
{
    using namespace Foam;
    argList::addBoolOption("dump", "Write what this processor holds");
    argList::noBanner();
    argList args(argc, argv);
    Time time(Time::controlDictName, args);
    const polyMesh poly
    (
        IOobject
        (
            polyMesh::defaultRegion, time.timeName(), time, IOobject::MUST_READ
        )
    );
    const feMesh mesh(poly);
    dumpOf(mesh).write
    (
        args.rootPath()/args.globalCaseName()/"dump."
      + Foam::name(Pstream::parRun() ? Pstream::nProcs() : 1) + "."
      + Foam::name(Pstream::myProcNo())
    );
    return 0;
}

} // End namespace


int main(int argc, char* argv[])
{
    if (argc > 1 && std::string(argv[1]) == "-dump")
    {
        return dump(argc, argv);
    }
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
