/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "farFieldPointPatchField.H"
#include "pointPatchFieldMapper.H"
#include "Time.H"

template<class Type>
Foam::autoPtr<Foam::Function1<Type>>
Foam::farFieldPointPatchField<Type>::copied
(
    const farFieldPointPatchField<Type>& ptf
)
{
    return
        ptf.varies()
      ? autoPtr<Function1<Type>>(ptf.uniformValue_->clone().ptr())
      : autoPtr<Function1<Type>>();
}


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
    outer_(p.size(), Zero),
    curved_(dict, p.size(), pTraits<Type>::rank == 0)
{
    if (dict.found("uniformValue"))
    {
        uniformValue_ = Function1<Type>::New("uniformValue", dict);
        setTime(this->db().time().value());
    }
    else
    {
        outer_ = Field<Type>("value", dict, p.size());
    }
}


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
    outer_(ptf.outer_, mapper),
    uniformValue_(copied(ptf)),
    curved_(ptf.curved_, mapper)
{}


template<class Type>
Foam::farFieldPointPatchField<Type>::farFieldPointPatchField
(
    const farFieldPointPatchField<Type>& ptf,
    const DimensionedField<Type, pointMesh>& iF
)
:
    pointPatchField<Type>(ptf, iF),
    outer_(ptf.outer_),
    uniformValue_(copied(ptf)),
    curved_(ptf.curved_)
{}


template<class Type>
void Foam::farFieldPointPatchField<Type>::setTime(const scalar time)
{
    if (varies())
    {
        outer_ = uniformValue_->value(this->db().time().timeToUserTime(time));
    }
}


template<class Type>
void Foam::farFieldPointPatchField<Type>::autoMap
(
    const pointPatchFieldMapper& mapper
)
{
    outer_.autoMap(mapper);
    curved_.autoMap(mapper);
}


template<class Type>
void Foam::farFieldPointPatchField<Type>::rmap
(
    const pointPatchField<Type>& ptf,
    const labelList& addr
)
{
    const auto& other = refCast<const farFieldPointPatchField<Type>>(ptf);
    outer_.rmap(other.outer_, addr);
    curved_.rmap(other.curved_, addr);
}


template<class Type>
void Foam::farFieldPointPatchField<Type>::write(Ostream& os) const
{
    pointPatchField<Type>::write(os);
    if (varies())
    {
        uniformValue_->writeData(os);
    }
    curved_.write(os);
    outer_.writeEntry("value", os);
}
