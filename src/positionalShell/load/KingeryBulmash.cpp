// SPDX-License-Identifier: GPL-3.0-or-later

#include "KingeryBulmash.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace positionalShell
{

namespace
{

// Sea level, for which the fits hold
constexpr double seaPressure = 101325;
constexpr double seaTemperature = 288.15;

//- Impulse over peak and duration of Friedlander's history with decay b, (L4)
double impulsePart(double b)
{
    // The fraction loses all digits at b = 0
    if (std::abs(b) < 1e-2) return 0.5 - b/6 + b*b/24 - b*b*b/120;
    return (b - 1 + std::exp(-b))/(b*b);
}

struct Friedlander
{
    double peak;
    double duration;
    double decay;

    Friedlander(double peak, double impulse, double duration)
    :
        peak(peak), duration(duration), decay(friedlanderDecay(impulse/(peak*duration)))
    {}

    double value(double since) const
    {
        if (since < 0 || since > duration) return 0;
        const double phase = since/duration;
        return peak*(1 - phase)*std::exp(-decay*phase);
    }
};

} // namespace

double friedlanderDecay(double part)
{
    if (!(part > 0) || !std::isfinite(part))
    {
        throw std::invalid_argument
        (
            "Friedlander: impulse/(peak*duration) is " + std::to_string(part)
          + ", but must be positive"
        );
    }
    // impulsePart falls from infinity to 0, and is 1/2 at b = 0
    double low = -1;
    while (impulsePart(low) < part) low *= 2;
    double high = 1;
    while (impulsePart(high) > part) high *= 2;
    for (int i = 0; i < 200 && high - low > 1e-14*(1 + std::abs(low)); ++i)
    {
        const double middle = 0.5*(low + high);
        (impulsePart(middle) > part ? low : high) = middle;
    }
    return 0.5*(low + high);
}

void KingeryBulmash::check() const
{
    const auto positive = [](const char* name, double value)
    {
        if (value > 0) return;
        throw std::invalid_argument
        (
            std::string("Kingery-Bulmash: ") + name + ' ' + std::to_string(value)
          + " is not positive"
        );
    };
    positive("mass", mass);
    positive("pressure", pressure);
    positive("temperature", temperature);
}

double KingeryBulmash::scaledDistance(const Vec3& X) const
{
    return (X - position).norm()*std::cbrt(pressure/seaPressure/mass);
}

PressureHistory KingeryBulmash::at(const Vec3& X, const Vec3& normal) const
{
    using Quantity = BlastTable::Quantity;

    // Sachs's rules, (L6)
    const double p = pressure/seaPressure;
    const double time =
        std::cbrt(mass/p)*std::sqrt(seaTemperature/temperature);
    const double Z = scaledDistance(X);
    const BlastTable table(burst);
    const auto get = [&](Quantity q, double scale) { return scale*table.value(q, Z); };

    const double arrival = get(Quantity::arrival, time);
    const double duration = get(Quantity::duration, time);
    const Friedlander incident
    (
        get(Quantity::incidentPeak, p), get(Quantity::incidentImpulse, p*time), duration
    );
    const Friedlander reflected
    (
        get(Quantity::reflectedPeak, p), get(Quantity::reflectedImpulse, p*time), duration
    );

    // (L5); a face turned away from the charge has the incident pressure
    const double c = std::max(0.0, side*normal.dot((position - X).normalized()));
    const double ofReflected = c*c;
    const double ofIncident = 1 + c - 2*c*c;
    const double sign = side;
    return [=](double t)
    {
        const double since = t - arrival;
        return sign*
            (ofIncident*incident.value(since) + ofReflected*reflected.value(since));
    };
}

} // namespace positionalShell
