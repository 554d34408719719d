// SPDX-License-Identifier: GPL-3.0-or-later
//
// The triangle rules are those of Dunavant (1985, Int. J. Numer. Meth. Engng 21,
// 1129-1148). The digits were recomputed to 18 places by Newton's method on the
// moment equations.

#include "Quadrature.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

namespace positionalShell
{

namespace
{

//- Points that a rule gains from one set of area coordinates by symmetry; the
//  weights of a rule sum to one here
class RuleBuilder
{
public:

    RuleBuilder& centroid(double w)
    {
        add(w, 1.0/3, 1.0/3);
        return *this;
    }

    RuleBuilder& three(double w, double a)
    {
        const double b = 1 - 2*a;
        add(w, a, a);
        add(w, a, b);
        add(w, b, a);
        return *this;
    }

    RuleBuilder& six(double w, double a, double b)
    {
        const double c = 1 - a - b;
        add(w, a, b);
        add(w, b, a);
        add(w, b, c);
        add(w, c, b);
        add(w, c, a);
        add(w, a, c);
        return *this;
    }

    const std::vector<TrianglePoint>& points() const { return points_; }

private:

    std::vector<TrianglePoint> points_;

    void add(double w, double xi1, double xi2)
    {
        points_.push_back({xi1, xi2, 0.5*w});
    }
};

struct Rule
{
    int degree;
    std::vector<TrianglePoint> points;
};

const std::vector<Rule>& rules()
{
    static const std::vector<Rule> all
    {
        {
            4,
            RuleBuilder()
                .three(0.223381589678011466, 0.445948490915964886)
                .three(0.109951743655321868, 0.091576213509770743)
                .points()
        },
        {
            5,
            RuleBuilder()
                .centroid(0.225)
                .three(0.132394152788506181, 0.470142064105115090)
                .three(0.125939180544827153, 0.101286507323456339)
                .points()
        },
        {
            6,
            RuleBuilder()
                .three(0.116786275726379372, 0.249286745170910418)
                .three(0.050844906370206818, 0.063089014491502229)
                .six
                (
                    0.082851075618373572,
                    0.053145049844816945, 0.310352451033784408
                )
                .points()
        },
        {
            8,
            RuleBuilder()
                .centroid(0.144315607677787183)
                .three(0.095091634267284616, 0.459292588292723164)
                .three(0.103217370534718249, 0.170569307751760215)
                .three(0.032458497623198079, 0.050547228317030975)
                .six
                (
                    0.027230314174434998,
                    0.008394777409957617, 0.263112829634638090
                )
                .points()
        },
        {
            10,
            RuleBuilder()
                .centroid(0.090817990382755896)
                .three(0.036725957756465797, 0.485577633383658042)
                .three(0.045321059435527690, 0.109481575485036536)
                .six
                (
                    0.072757916845420965,
                    0.141707219414877956, 0.307939838764121241
                )
                .six
                (
                    0.028327242531056954,
                    0.025003534762685788, 0.246672560639901220
                )
                .six
                (
                    0.009421666963732688,
                    0.009540815400299525, 0.066803251012199616
                )
                .points()
        }
    };
    return all;
}

//- Roots of the Legendre polynomial of degree n by Newton's method
std::vector<LinePoint> gaussLegendre(int n)
{
    std::vector<LinePoint> points(n);
    for (int i = 0; i < n; ++i)
    {
        double x = -std::cos(std::acos(-1.0)*(i + 0.75)/(n + 0.5));
        double slope = 1;
        for (int iteration = 0; iteration < 20; ++iteration)
        {
            double previous = 1;
            double value = x;
            for (int k = 2; k <= n; ++k)
            {
                const double next =
                    ((2*k - 1)*x*value - (k - 1)*previous)/k;
                previous = value;
                value = next;
            }
            slope = n*(x*value - previous)/(x*x - 1);
            x -= value/slope;
        }
        points[i] = {x, 2/((1 - x*x)*slope*slope)};
    }
    return points;
}

} // namespace

const std::vector<TrianglePoint>& triangleRule(int nPoints)
{
    std::string valid;
    for (const Rule& rule : rules())
    {
        if (static_cast<int>(rule.points.size()) == nPoints)
        {
            return rule.points;
        }
        valid += " " + std::to_string(rule.points.size());
    }
    throw std::invalid_argument
    (
        "no triangle rule with " + std::to_string(nPoints)
      + " points; valid numbers:" + valid
    );
}

const std::vector<TrianglePoint>& triangleRuleOfDegree(int degree)
{
    for (const Rule& rule : rules())
    {
        if (rule.degree >= degree) return rule.points;
    }
    throw std::invalid_argument
    (
        "no triangle rule of degree " + std::to_string(degree)
      + "; the highest is " + std::to_string(rules().back().degree)
    );
}

const std::vector<LinePoint>& gaussRule(int nPoints)
{
    constexpr int most = 10;
    if (nPoints < 1 || nPoints > most)
    {
        throw std::invalid_argument
        (
            "no Gauss rule with " + std::to_string(nPoints)
          + " points; valid numbers: 1 to " + std::to_string(most)
        );
    }
    static const std::array<std::vector<LinePoint>, most> all = []
    {
        std::array<std::vector<LinePoint>, most> made;
        made[0] = {{0, 2}};
        for (int n = 2; n <= most; ++n)
        {
            made[n - 1] = gaussLegendre(n);
        }
        return made;
    }();
    return all[nPoints - 1];
}

} // namespace positionalShell
