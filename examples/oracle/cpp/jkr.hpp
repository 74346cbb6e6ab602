// A small code to be tested: the JKR contact of a sphere of radius R, effective modulus E and work of adhesion w. Put yours in
// its place. With a0 = (2 pi w R^2 / E)^(1/3) and x = a/a0 the equilibria are d = (x^2 - sqrt(x)) a0^2/R and
// F = (4/3 x^3 - 2 x^(3/2)) E a0^3/R.
#ifndef EXAMPLE_JKR_HPP
#define EXAMPLE_JKR_HPP

#include <cmath>
#include <limits>

namespace example {

struct State {
    double radius, indentation, force;
};

class Jkr {
public:
    Jkr(double radius, double modulus, double work)
        : length(std::cbrt(2 * pi * work / modulus * radius * radius)),
          depth(length * (length / radius)), load(2 * pi * work * radius) {}

    State at(double x) const
    {
        return {length * x, depth * (x * x - std::sqrt(x)), load * (4.0 / 3 * x * x * x - 2 * x * std::sqrt(x))};
    }

    // Where the contact breaks: -(3/2) pi w R under a dead load, -(5/6) pi w R at fixed grips.
    State pull_off_by_force() const { return at(std::cbrt(9.0 / 16)); }
    State pull_off_by_indentation() const { return at(std::cbrt(1.0 / 16)); }

    // The stable state under a dead load; NaN where there is none.
    State at_force(double force) const
    {
        return at(std::pow(0.75 * (1 + std::sqrt(1 + 4.0 / 3 * force / load)), 2.0 / 3));
    }

    // The stable state at fixed grips, by Newton's method from the right, where x^2 - sqrt(x) is convex.
    State at_indentation(double indentation) const
    {
        const double wanted = indentation / depth, lowest = -0.75 * std::cbrt(0.25);
        if (!(wanted >= lowest))
            return at(std::numeric_limits<double>::quiet_NaN());
        double x = 1 + std::sqrt(std::fabs(wanted));
        for (double last = 2 * x; x < last;) {
            last = x;
            x -= (x * x - std::sqrt(x) - wanted) / (2 * x - 0.5 / std::sqrt(x));
        }
        return at(x);
    }

private:
    static constexpr double pi = 3.14159265358979323846;
    double length, depth, load;
};

} // namespace example

#endif
