/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "iterated.H"
#include "addToRunTimeSelectionTable.H"
#include "boundBox.H"
#include "dictionaryCheck.H"

namespace Foam
{
    defineTypeNameAndDebug(iterated, 0);
    addToRunTimeSelectionTable(shellCoupling, iterated, dictionary);
}


static Foam::fixedPoint::method readMethod(const Foam::dictionary& coeffs)
{
    using namespace Foam;

    checkKeywords
    (
        coeffs, {"acceleration", "relaxation", "tolerance", "maxIterations"}
    );
    return
        coeffs.found("acceleration")
      ? fixedPoint::method
        (
            selectEntry(coeffs, "acceleration", fixedPoint::names())
        )
      : fixedPoint::Aitken;
}


Foam::iterated::iterated
(
    Time& time,
    polyMesh& mesh,
    taylorGalerkinGas& gas,
    autoPtr<shellSide>&& shell,
    const dictionary& dict
)
:
    predictedMotion(time, mesh, gas, std::move(shell), dict),
    fixedPoint_(readMethod(coeffsDict(dict, typeName))),
    relaxation_
    (
        coeffsDict(dict, typeName).getOrDefault<scalar>("relaxation", 0)
    ),
    tolerance_
    (
        coeffsDict(dict, typeName).getOrDefault<scalar>("tolerance", 1e-6)
    ),
    maxIterations_
    (
        coeffsDict(dict, typeName).getOrDefault<label>("maxIterations", 20)
    ),
    converged_(true),
    nIterations_(0),
    residual_(0),
    nSteps_(0),
    nConverged_(0),
    nAll_(0),
    nMost_(0),
    rounding_(10*SMALL*boundBox(gas.mesh().nodes()).mag())
{
    const dictionary coeffs(coeffsDict(dict, typeName));
    if (tolerance_ <= 0 || maxIterations_ < 1 || relaxation_ < 0)
    {
        FatalIOErrorInFunction(coeffs)
            << "tolerance " << tolerance_ << ", maxIterations "
            << maxIterations_ << ", relaxation " << relaxation_ << nl
            << "    tolerance and relaxation must be positive, maxIterations "
            << "at least 1" << exit(FatalIOError);
    }
}


positionalShell::Vector Foam::iterated::stacked
(
    const interfaceMotion& m,
    const scalar duration
)
{
    // Displacements and displacements by the velocities of this process, then
    // those of all, so that all take the same steps of the iteration
    List<vectorField> all(Pstream::nProcs());
    vectorField& own = all[Pstream::myProcNo()];
    own = m.displacement;
    own.append(vectorField(duration*m.velocity));
    Pstream::gatherList(all);
    Pstream::scatterList(all);

    label n = 0;
    for (const vectorField& u : all)
    {
        n += u.size();
    }
    positionalShell::Vector stack(3*n);
    label at = 0;
    for (const vectorField& u : all)
    {
        for (const vector& x : u)
        {
            for (direction d = 0; d < 3; ++d)
            {
                stack[at++] = x[d];
            }
        }
    }
    return stack;
}


Foam::iterated::interfaceMotion Foam::iterated::unstacked
(
    const positionalShell::Vector& u,
    const scalar duration
) const
{
    labelList sizes(Pstream::nProcs());
    sizes[Pstream::myProcNo()] = nodes_.size();
    Pstream::gatherList(sizes);
    Pstream::scatterList(sizes);

    label at = 0;
    for (label proci = 0; proci < Pstream::myProcNo(); ++proci)
    {
        at += 6*sizes[proci];
    }
    interfaceMotion m
    {
        vectorField(nodes_.size()), vectorField(nodes_.size())
    };
    for (vectorField* field : {&m.displacement, &m.velocity})
    {
        for (vector& x : *field)
        {
            for (direction d = 0; d < 3; ++d)
            {
                x[d] = u[at++];
            }
        }
    }
    m.velocity /= duration;
    return m;
}


void Foam::iterated::iterate
(
    const scalar duration,
    const positionalShell::Vector& startLoad,
    const interfaceMotion& start
)
{
    gas_.storeOldState();
    shell_->storeOldState();
    interfaceMotion still(start);
    still.velocity = Zero;
    const positionalShell::Vector origin = stacked(still, duration);

    // (C19)
    fixedPoint_.begin
    (
        relaxation_ > 0 ? relaxation_
      : 1/(1 + 0.25/indicators_.massRatio())
    );
    expected_ = predict(duration);
    converged_ = false;

    for (nIterations_ = 1; ; ++nIterations_)
    {
        pass(duration, startLoad, nIterations_ > 1);

        const positionalShell::Vector guess = stacked(expected_, duration);
        const positionalShell::Vector result =
            stacked(shellMotion(), duration);
        const scalar size = (result - origin).lpNorm<Eigen::Infinity>();
        const scalar error = (result - guess).lpNorm<Eigen::Infinity>();
        residual_ = error/max(size, VSMALL);
        converged_ = error <= tolerance_*size + rounding_;
        if (converged_ || nIterations_ == maxIterations_)
        {
            return;
        }

        expected_ = unstacked(fixedPoint_.next(guess, result), duration);
        gas_.restoreOldState();
        shell_->restoreOldState();
        balance_.begin();
    }
}


void Foam::iterated::advance()
{
    const scalar duration = time_.deltaTValue();
    const positionalShell::Vector startLoad = openStep(duration);
    const interfaceMotion start(shellMotion());

    iterate(duration, startLoad, start);
    closeStep(duration, start.velocity);

    ++nSteps_;
    nConverged_ += converged_;
    nAll_ += nIterations_;
    nMost_ = max(nMost_, nIterations_);
}


void Foam::iterated::report()
{
    Info<< "Iteration: "
        << (converged_ ? "converged" : "iteration limit reached")
        << " after " << nIterations_ << " passes, residual " << residual_
        << ", relaxation " << fixedPoint_.omega() << nl;
    if (!converged_)
    {
        WarningInFunction
            << "The coupling did not converge in maxIterations "
            << maxIterations_ << ": residual " << residual_
            << ", tolerance " << tolerance_ << nl
            << "    Use a smaller coupling step, acceleration quasiNewton, or "
            << "more iterations" << endl;
    }
    predictedMotion::report();
}


void Foam::iterated::reportEnd()
{
    predictedMotion::reportEnd();
    Info<< "Iterations: " << nSteps_ << " steps, " << meanIterations()
        << " passes in the mean, " << nMost_ << " at most; converged in "
        << nConverged_ << ", iteration limit reached in "
        << nSteps_ - nConverged_ << endl;
}
