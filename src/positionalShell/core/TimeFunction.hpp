// SPDX-License-Identifier: GPL-3.0-or-later
//
// Scalar function of time with its first two derivatives: factor of a load, or a
// prescribed displacement. Loads use the value only; prescribed motion in
// dynamics uses all three, because the inertia of the driven nodes acts on the
// free ones.

#ifndef positionalShell_TimeFunction_hpp
#define positionalShell_TimeFunction_hpp

#include <functional>
#include <memory>
#include <vector>

namespace positionalShell
{

class TimeFunction
{
public:
    virtual ~TimeFunction() = default;
    virtual double value(double t) const = 0;
    virtual double firstDerivative(double t) const = 0;
    virtual double secondDerivative(double t) const = 0;
};

using TimeFunctionPtr = std::shared_ptr<const TimeFunction>;

TimeFunctionPtr constant(double value);

//- start + slope*t
TimeFunctionPtr linearInTime(double start, double slope);

//- amplitude*sin(2 pi frequency t + phase), frequency [Hz], phase [rad]
TimeFunctionPtr sine(double amplitude, double frequency, double phase = 0);

//- 0 before t0, 1 after t0 + duration, quintic between: value, rate and second
//  rate are continuous
TimeFunctionPtr smoothStep(double t0, double duration, double height = 1);

//- Piecewise linear, constant outside. The derivative is that of the piece, the
//  second derivative zero: meant for loads. Throws std::invalid_argument when
//  times do not increase or sizes differ.
TimeFunctionPtr table(std::vector<double> times, std::vector<double> values);

//- Any callables. Without derivatives it may scale loads, but asking it for one
//  throws std::invalid_argument.
TimeFunctionPtr timeFunction
(
    std::function<double(double)> value,
    std::function<double(double)> firstDerivative = nullptr,
    std::function<double(double)> secondDerivative = nullptr
);

} // namespace positionalShell

#endif
