/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "nodalPlaces.H"

Foam::nodalPlaces::nodalPlaces(const pointField& places)
:
    places_(places),
    simplices_(places.size(), -1),
    weights_(places.size()),
    holder_(places.size(), -1)
{}


void Foam::nodalPlaces::locate(const feMesh& mesh)
{
    // Most often a place is where it was
    boolList isThere(size(), false);
    forAll(places_, i)
    {
        isThere[i] =
            holder_[i] == Pstream::myProcNo()
         && mesh.inSimplex(simplices_[i], places_[i], weights_[i]);
    }
    Pstream::listCombineGather(isThere, orEqOp<bool>());
    Pstream::listCombineScatter(isThere);
    if (!isThere.found(false))
    {
        return;
    }

    labelList holder(size(), labelMax);
    forAll(places_, i)
    {
        if (!isThere[i])
        {
            simplices_[i] = mesh.findSimplex(places_[i], weights_[i]);
            holder[i] = simplices_[i] >= 0 ? Pstream::myProcNo() : labelMax;
        }
    }
    Pstream::listCombineGather(holder, minEqOp<label>());
    Pstream::listCombineScatter(holder);
    forAll(places_, i)
    {
        if (!isThere[i])
        {
            holder_[i] = holder[i] == labelMax ? -1 : holder[i];
        }
    }
}


void Foam::nodalPlaces::checkFields
(
    const wordList& names,
    const polyMesh& mesh,
    const dictionary& dict
)
{
    wordList valid(mesh.sortedNames<pointScalarField>());
    valid.append(mesh.sortedNames<pointVectorField>());
    for (const word& name : names)
    {
        if (!valid.found(name))
        {
            FatalIOErrorInFunction(dict)
                << "There is no point field " << name << nl
                << "    Point fields are " << flatOutput(valid)
                << exit(FatalIOError);
        }
    }
}
