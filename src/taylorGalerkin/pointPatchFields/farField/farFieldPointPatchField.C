/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "farFieldPointPatchField.H"
#include "pointPatchFieldMapper.H"

template<class Type>
Foam::farFieldPointPatchField<Type>::farFieldPointPatchField
(
    const pointPatch& p,
    const DimensionedField<Type, pointMesh>& iF
)
:
    pointPatchField<Type>(p, iF),
    outer_(p.size(), Zero)
{}


template<class Type>
Foam::farFieldPointPatchField<Type>::farFieldPointPatchField
(
    const pointPatch& p,
    const DimensionedField<Type, pointMesh>& iF,
    const dictionary& dict
)
:
    pointPatchField<Type>(p, iF, dict),
    outer_("value", dict, p.size())
{}


template<class Type>
Foam::farFieldPointPatchField<Type>::farFieldPointPatchField
(
    const farFieldPointPatchField<Type>& ptf,
    const pointPatch& p,
    const DimensionedField<Type, pointMesh>& iF,
    const pointPatchFieldMapper& mapper
)
:
    pointPatchField<Type>(ptf, p, iF, mapper),
    outer_(ptf.outer_, mapper)
{}


template<class Type>
Foam::farFieldPointPatchField<Type>::farFieldPointPatchField
(
    const farFieldPointPatchField<Type>& ptf,
    const DimensionedField<Type, pointMesh>& iF
)
:
    pointPatchField<Type>(ptf, iF),
    outer_(ptf.outer_)
{}


template<class Type>
void Foam::farFieldPointPatchField<Type>::autoMap
(
    const pointPatchFieldMapper& mapper
)
{
    outer_.autoMap(mapper);
}


template<class Type>
void Foam::farFieldPointPatchField<Type>::rmap
(
    const pointPatchField<Type>& ptf,
    const labelList& addr
)
{
    outer_.rmap
    (
        refCast<const farFieldPointPatchField<Type>>(ptf).outer_,
        addr
    );
}


template<class Type>
void Foam::farFieldPointPatchField<Type>::write(Ostream& os) const
{
    pointPatchField<Type>::write(os);
    outer_.writeEntry("value", os);
}
