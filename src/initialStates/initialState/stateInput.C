/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "stateInput.H"

Foam::scalar Foam::positive(const dictionary& dict, const word& keyword)
{
    const scalar value = dict.get<scalar>(keyword);
    if (!(value > 0) || !std::isfinite(value))
    {
        FatalIOErrorInFunction(dict)
            << keyword << " is " << value << ", but must be greater than 0"
            << exit(FatalIOError);
    }
    return value;
}


Foam::vector Foam::sceneVector
(
    const feMesh& mesh,
    const dictionary& dict,
    const word& keyword
)
{
    const vector v(dict.get<vector>(keyword));
    vector inScene(Zero);
    for (const direction d : mesh.axes())
    {
        inScene[d] = v[d];
    }
    if (!(mag(v - inScene) <= 1e-9*mag(v)))
    {
        FatalIOErrorInFunction(dict)
            << keyword << " is " << v << ", but the scene is "
            << mesh.dim() << "-dimensional: only " << inScene
            << " of it lies between the empty sides" << exit(FatalIOError);
    }
    if (mesh.curvature() && inScene[mesh.axes()[mesh.radial()]] != 0)
    {
        FatalIOErrorInFunction(dict)
            << keyword << " is " << v << ", but in a scene with wedge patches "
            << "it can only be along the axis, not along r in "
            << vector::componentNames[mesh.axes()[mesh.radial()]]
            << exit(FatalIOError);
    }
    return inScene;
}


Foam::vector Foam::sceneDirection
(
    const feMesh& mesh,
    const dictionary& dict,
    const word& keyword
)
{
    const vector v(sceneVector(mesh, dict, keyword));
    if (!(mag(v) > VSMALL))
    {
        FatalIOErrorInFunction(dict)
            << keyword << " is " << v << ", which has no direction"
            << exit(FatalIOError);
    }
    return v/mag(v);
}


Foam::gasInput::gasInput(const feMesh& mesh, const dictionary& dict)
:
    p(positive(dict, "p")),
    T(positive(dict, "T")),
    U(dict.found("U") ? sceneVector(mesh, dict, "U") : vector::zero)
{}
