/*---------------------------------------------------------------------------*\
  shockShellFoam: shock waves on thin structures, an extension of OpenFOAM
  License: GPL-3.0-or-later, see COPYING
\*---------------------------------------------------------------------------*/
#include "couplingIndicators.H"

Foam::couplingIndicators::couplingIndicators
(
    const taylorGalerkinGas& gas,
    const interfaceNodes& nodes,
    const scalar shellMass,
    const scalar tolerance
)
:
    gas_(gas),
    nodes_(nodes),
    shellMass_(shellMass),
    startPressure_(0),
    massRatio_(GREAT),
    leastMassRatio_(GREAT),
    dampingExponent_(0),
    motion_(0),
    largestMotion_(0),
    largestLoad_(0),
    largestShellSpeed_(0),
    largestGasSpeed_(0),
    tolerance_(tolerance)
{
    const scalarField areas(mag(nodes_.areas(gas_)));
    forAll(areas, i)
    {
        startPressure_ += areas[i]*gas_.acoustics(nodes_.nodes()[i]).p;
    }
    reduce(startPressure_, sumOp<scalar>());
    startPressure_ /= gSum(areas);
}


void Foam::couplingIndicators::update
(
    const vectorField& velocity,
    const scalar duration
)
{
    const vectorField areas(nodes_.areas(gas_));
    scalar area = 0, impedance = 0, motion = 0, load = 0;
    forAll(areas, i)
    {
        const gasAcoustics g(gas_.acoustics(nodes_.nodes()[i]));
        const scalar A = mag(areas[i]);
        area += A;
        impedance += g.impedance*A;
        motion += sqr(g.impedance*(velocity[i] & areas[i]))/max(A, VSMALL);
        load += sqr(g.p - startPressure_)*A;
    }
    for (scalar* sum : {&area, &impedance, &motion, &load})
    {
        reduce(*sum, sumOp<scalar>());
    }
    motion_ = Foam::sqrt(motion/area);
    largestMotion_ = max(largestMotion_, motion_);
    largestLoad_ = max(largestLoad_, Foam::sqrt(load/area));

    massRatio_ = shellMass_/(impedance*duration);
    leastMassRatio_ = min(leastMassRatio_, massRatio_);
    dampingExponent_ += 0.5/massRatio_;

    largestShellSpeed_ = max(largestShellSpeed_, gMax(mag(velocity)));
}


void Foam::couplingIndicators::report(const bool moves) const
{
    Info<< "Coupling: mass ratio of shell to gas moved in the step "
        << massRatio_ << "; rho c v_n " << motion_
        << (moves ? " Pa, of the largest load " : " Pa neglected, of the"
            " largest load ")
        << ratio(motion_, largestLoad_) << nl;
}


void Foam::couplingIndicators::reportEnd
(
    const bool moves,
    const scalar leastRatio,
    const scalar iterations
) const
{
    const scalar load = 100*motionInLoad();
    const scalar damped = 100*dampedShare();
    Info<< "Coupling: least mass ratio of shell to gas moved in a step "
        << leastMassRatio_ << nl
        << "    velocity of the shell over that of the gas "
        << velocityRatio() << nl
        << (moves ? "    the motion changed the load by about "
            : "    error indicator: the motion would change the load by about ")
        << load << " % of its peak (rho c v_n)" << nl
        << (moves ? "    free vibrations of the shell lost "
            : "    error indicator: free vibrations of the shell would lose ")
        << damped << " % of their amplitude to the gas" << nl
        << "couplingAdvice: ";

    if (max(load, damped) <= 100*tolerance_)
    {
        Info<< "oneWay is enough, both are below " << 100*tolerance_
            << " % (adviceTolerance)" << nl;
    }
    else
    {
        Info<< "the scene needs the motion of the shell in the gas: the "
            << (load > damped ? "load" : "free vibration")
            << " changes by more than " << 100*tolerance_
            << " % (adviceTolerance)" << nl;
    }
    if (leastRatio > 0 && leastMassRatio_ < leastRatio)
    {
        Info<< "couplingAdvice: the mass ratio fell below " << leastRatio
            << ", which this scheme needs: choose iterated, or a smaller "
            << "coupling step" << nl;
    }
    else if (iterations > 0 && leastMassRatio_ > 10)
    {
        Info<< "couplingAdvice: the shell is heavy; predictedMotion gives the "
            << "same order for 1/" << iterations << " of the gas steps" << nl;
    }
}
