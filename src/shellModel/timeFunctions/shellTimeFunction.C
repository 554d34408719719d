/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "shellTimeFunction.H"
#include "smoothStep.H"
#include "Tuple2.H"
#include "mathematicalConstants.H"

using positionalShell::TimeFunctionPtr;

namespace Foam
{

typedef std::shared_ptr<const Function1<scalar>> scalarFunction;


static scalarFunction readFunction
(
    const word& entryName,
    const dictionary& dict
)
{
    return scalarFunction(Function1<scalar>::New(entryName, dict).ptr());
}


static std::function<double(double)> valueOf(const scalarFunction& f)
{
    return [f](double t) { return f->value(t); };
}


//- sum c t^e, with derivatives; the coefficients follow the type's name
static TimeFunctionPtr polynomialMotion
(
    const word& entryName,
    const dictionary& dict
)
{
    ITstream& is = dict.lookup(entryName);
    const word type(is);
    const List<Tuple2<scalar, scalar>> terms(is);

    const auto derivative = [terms](const label order)
    {
        return [terms, order](double t)
        {
            scalar sum = 0;
            for (const auto& term : terms)
            {
                scalar factor = term.first();
                for (label i = 0; i < order; ++i)
                {
                    factor *= term.second() - i;
                }
                if (factor != 0)
                {
                    sum += factor*std::pow(t, term.second() - order);
                }
            }
            return sum;
        };
    };

    return positionalShell::timeFunction
    (
        derivative(0), derivative(1), derivative(2)
    );
}


//- level + scale amplitude sin(2 pi frequency (t - t0)), with derivatives
static TimeFunctionPtr sineMotion
(
    const scalarFunction& f,
    const word& entryName,
    const dictionary& dict
)
{
    const dictionary& coeffs =
        dict.isDict(entryName)
      ? dict.subDict(entryName)
      : dict.optionalSubDict(entryName + "Coeffs");

    const auto constantEntry = [&](const word& keyword)
    {
        const scalarFunction c(readFunction(keyword, coeffs));
        if (c->type() != "constant")
        {
            FatalIOErrorInFunction(coeffs)
                << keyword << " of a sine that moves the shell in dynamics"
                << " must be a constant, not " << c->type() << nl
                << exit(FatalIOError);
        }
        return c->value(0);
    };

    const scalar omega =
        constant::mathematical::twoPi*constantEntry("frequency");
    const scalar amplitude =
        constantEntry("amplitude")*constantEntry("scale");
    constantEntry("level");
    const scalar t0 = coeffs.lookupOrDefault<scalar>("t0", 0);

    return positionalShell::timeFunction
    (
        valueOf(f),
        [=](double t) { return omega*amplitude*std::cos(omega*(t - t0)); },
        [=](double t)
        {
            return -sqr(omega)*amplitude*std::sin(omega*(t - t0));
        }
    );
}

} // End namespace Foam


positionalShell::TimeFunctionPtr Foam::readLoadFactor
(
    const word& entryName,
    const dictionary& dict
)
{
    if (!dict.found(entryName, keyType::LITERAL))
    {
        return positionalShell::constant(1);
    }
    return positionalShell::timeFunction
    (
        valueOf(readFunction(entryName, dict))
    );
}


positionalShell::TimeFunctionPtr Foam::readMotion
(
    const word& entryName,
    const dictionary& dict,
    const bool withDerivatives
)
{
    const scalarFunction f(readFunction(entryName, dict));

    if (!withDerivatives)
    {
        // Statics: time is the load parameter, nothing has a rate
        const auto none = [](double) { return 0.0; };
        return positionalShell::timeFunction(valueOf(f), none, none);
    }

    const word& type = f->type();

    if (type == "constant" || type == "zero" || type == "one")
    {
        return positionalShell::constant(f->value(0));
    }
    if (type == "polynomial")
    {
        return polynomialMotion(entryName, dict);
    }
    if (type == "sine")
    {
        return sineMotion(f, entryName, dict);
    }
    if (isA<Function1Types::smoothStep>(*f))
    {
        return refCast<const Function1Types::smoothStep>(*f).function();
    }

    FatalIOErrorInFunction(dict)
        << "The motion " << entryName << " is of type " << type
        << ", whose derivatives are not known; dynamics needs them" << nl
        << "    Valid types are "
        << flatOutput
           (
               wordList
               ({"constant", "one", "polynomial", "sine", "smoothStep", "zero"})
           )
        << nl << exit(FatalIOError);

    return nullptr;
}
