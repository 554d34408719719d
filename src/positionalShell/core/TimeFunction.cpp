// SPDX-License-Identifier: GPL-3.0-or-later

#include "TimeFunction.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace positionalShell
{

namespace
{

class LinearInTime : public TimeFunction
{
public:
    LinearInTime(double start, double slope) : start_(start), slope_(slope) {}
    double value(double t) const override { return start_ + slope_*t; }
    double firstDerivative(double) const override { return slope_; }
    double secondDerivative(double) const override { return 0; }

private:
    double start_;
    double slope_;
};

class Sine : public TimeFunction
{
public:
    Sine(double amplitude, double frequency, double phase)
    :
        amplitude_(amplitude),
        omega_(2*std::acos(-1.0)*frequency),
        phase_(phase)
    {}
    double value(double t) const override
    {
        return amplitude_*std::sin(omega_*t + phase_);
    }
    double firstDerivative(double t) const override
    {
        return amplitude_*omega_*std::cos(omega_*t + phase_);
    }
    double secondDerivative(double t) const override
    {
        return -omega_*omega_*value(t);
    }

private:
    double amplitude_;
    double omega_;
    double phase_;
};

class SmoothStep : public TimeFunction
{
public:
    SmoothStep(double t0, double duration, double height)
    :
        t0_(t0), duration_(duration), height_(height)
    {
        if (!(duration > 0))
        {
            throw std::invalid_argument
            (
                "smoothStep: duration must be positive, not "
              + std::to_string(duration)
            );
        }
    }
    double value(double t) const override
    {
        const double s = scaled(t);
        return height_*s*s*s*(10 + s*(6*s - 15));
    }
    double firstDerivative(double t) const override
    {
        const double s = scaled(t);
        return height_*30*s*s*(1 - s)*(1 - s)/duration_;
    }
    double secondDerivative(double t) const override
    {
        const double s = scaled(t);
        return height_*60*s*(1 - s)*(1 - 2*s)/(duration_*duration_);
    }

private:
    double t0_;
    double duration_;
    double height_;

    double scaled(double t) const
    {
        return std::clamp((t - t0_)/duration_, 0.0, 1.0);
    }
};

class Table : public TimeFunction
{
public:
    Table(std::vector<double> times, std::vector<double> values)
    :
        times_(std::move(times)), values_(std::move(values))
    {
        if (times_.empty() || times_.size() != values_.size())
        {
            throw std::invalid_argument
            (
                "table of time: " + std::to_string(times_.size())
              + " times and " + std::to_string(values_.size())
              + " values; the same number, at least one, is needed"
            );
        }
        for (std::size_t i = 1; i < times_.size(); ++i)
        {
            if (!(times_[i] > times_[i - 1]))
            {
                throw std::invalid_argument
                (
                    "table of time: entry " + std::to_string(i)
                  + " is not later than the one before"
                );
            }
        }
    }
    double value(double t) const override
    {
        if (t <= times_.front()) return values_.front();
        if (t >= times_.back()) return values_.back();
        const std::size_t i = piece(t);
        return values_[i] + slope(i)*(t - times_[i]);
    }
    double firstDerivative(double t) const override
    {
        if (t < times_.front() || t >= times_.back()) return 0;
        return slope(piece(t));
    }
    double secondDerivative(double) const override { return 0; }

private:
    std::vector<double> times_;
    std::vector<double> values_;

    std::size_t piece(double t) const
    {
        return std::upper_bound(times_.begin(), times_.end(), t)
            - times_.begin() - 1;
    }
    double slope(std::size_t i) const
    {
        return (values_[i + 1] - values_[i])/(times_[i + 1] - times_[i]);
    }
};

class Callable : public TimeFunction
{
public:
    using Function = std::function<double(double)>;
    Callable(Function f, Function f1, Function f2)
    :
        f_(std::move(f)), f1_(std::move(f1)), f2_(std::move(f2))
    {
        if (!f_)
        {
            throw std::invalid_argument("timeFunction: no function given");
        }
    }
    double value(double t) const override { return f_(t); }
    double firstDerivative(double t) const override { return checked(f1_)(t); }
    double secondDerivative(double t) const override { return checked(f2_)(t); }

private:
    Function f_;
    Function f1_;
    Function f2_;

    static const Function& checked(const Function& f)
    {
        if (!f)
        {
            throw std::invalid_argument
            (
                "timeFunction: a motion in dynamics needs the first and the "
                "second derivative as well"
            );
        }
        return f;
    }
};

} // namespace

TimeFunctionPtr constant(double value)
{
    return std::make_shared<LinearInTime>(value, 0);
}

TimeFunctionPtr linearInTime(double start, double slope)
{
    return std::make_shared<LinearInTime>(start, slope);
}

TimeFunctionPtr sine(double amplitude, double frequency, double phase)
{
    return std::make_shared<Sine>(amplitude, frequency, phase);
}

TimeFunctionPtr smoothStep(double t0, double duration, double height)
{
    return std::make_shared<SmoothStep>(t0, duration, height);
}

TimeFunctionPtr table(std::vector<double> times, std::vector<double> values)
{
    return std::make_shared<Table>(std::move(times), std::move(values));
}

TimeFunctionPtr timeFunction
(
    std::function<double(double)> value,
    std::function<double(double)> firstDerivative,
    std::function<double(double)> secondDerivative
)
{
    return std::make_shared<Callable>
    (
        std::move(value), std::move(firstDerivative), std::move(secondDerivative)
    );
}

} // namespace positionalShell
