// SPDX-License-Identifier: GPL-3.0-or-later

#include "BlastWave.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace positionalShell
{

void BlastWave::check() const
{
    const auto positive = [](const char* name, double value)
    {
        if (value > 0) return;
        throw std::invalid_argument
        (
            std::string("blast wave: ") + name + ' ' + std::to_string(value)
          + " is not positive"
        );
    };
    positive("referenceDistance", referenceDistance);
    positive("speed", speed);
    positive("duration", duration);
    if (decay < 0 || peakExponent < 0)
    {
        throw std::invalid_argument
        (
            "blast wave: decay and peakExponent must not be negative"
        );
    }
}

double BlastWave::value(const Vec3& X, double time) const
{
    const double r = (X - centre).norm();
    const double since = time - arrival - (r - referenceDistance)/speed;
    if (since < 0) return 0;
    const double phase = since/duration;
    const double front =
        peak*std::pow(r/referenceDistance, -peakExponent);
    return front*(1 - phase)*std::exp(-decay*phase);
}

PressureHistory BlastWave::at(const Vec3& X, const Vec3&) const
{
    const BlastWave wave(*this);
    return [wave, X](double time) { return wave.value(X, time); };
}

} // namespace positionalShell
