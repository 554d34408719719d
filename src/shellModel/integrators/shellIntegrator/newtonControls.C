/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "newtonControls.H"
#include "dictionaryCheck.H"

using positionalShell::LineSearch;
using positionalShell::NewtonOptions;
using positionalShell::TangentUpdate;

static void checkPositive
(
    const Foam::dictionary& dict,
    const Foam::word& keyword,
    const Foam::scalar value
)
{
    using namespace Foam;

    if (!(value > 0))
    {
        FatalIOErrorInFunction(dict)
            << keyword << " must be positive, not " << value << nl
            << exit(FatalIOError);
    }
}


positionalShell::NewtonOptions Foam::readNewtonControls
(
    const dictionary& shellProperties,
    positionalShell::NewtonOptions options
)
{
    if (!shellProperties.found("newton"))
    {
        return options;
    }

    const dictionary& dict = shellProperties.subDict("newton");
    checkKeywords
    (
        dict,
        {
            "maxIterations", "residualTolerance", "incrementTolerance",
            "tangentUpdate", "keptIterations", "lineSearch", "maxCuts"
        }
    );

    dict.readIfPresent("maxIterations", options.maxIterations);
    dict.readIfPresent("residualTolerance", options.residualTolerance);
    dict.readIfPresent("incrementTolerance", options.incrementTolerance);
    dict.readIfPresent("keptIterations", options.keptIterations);
    checkPositive(dict, "maxIterations", options.maxIterations);
    checkPositive(dict, "residualTolerance", options.residualTolerance);
    checkPositive(dict, "incrementTolerance", options.incrementTolerance);
    checkPositive(dict, "keptIterations", options.keptIterations);

    if (dict.found("tangentUpdate"))
    {
        const label choice =
            selectEntry(dict, "tangentUpdate", {"everyIteration", "whenSlow"});
        options.tangentUpdate =
            choice == 0
          ? TangentUpdate::everyIteration
          : TangentUpdate::whenSlow;
    }
    if (dict.found("lineSearch"))
    {
        const label choice =
            selectEntry(dict, "lineSearch", {"off", "whenNeeded", "always"});
        options.lineSearch = static_cast<LineSearch>(choice);
    }
    return options;
}


Foam::label Foam::readMaxCuts(const dictionary& shellProperties)
{
    const dictionary dict(shellProperties.subOrEmptyDict("newton"));
    const label maxCuts = dict.lookupOrDefault<label>("maxCuts", 10);
    if (maxCuts < 0)
    {
        FatalIOErrorInFunction(dict)
            << "maxCuts must not be negative, not " << maxCuts << nl
            << exit(FatalIOError);
    }
    return maxCuts;
}
