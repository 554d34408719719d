/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellFile.H"
#include "OSspecific.H"

bool Foam::shellFileExists
(
    const Time& runTime,
    const fileName& folder,
    const word& name
)
{
    return isFile(runTime.globalPath()/folder/name);
}
