// A small code that takes the place of Lethe here: it reads the same parameter file, lets one sphere come to rest on a wall under
// the JKR force of ../cpp/jkr.hpp, and prints the particle as Lethe does.
//
//     c++ -std=c++17 example_app.cpp -o app && ./app rest_on_wall.prm | diff - rest_on_wall.output
#include "../cpp/jkr.hpp"

#include <cstdio>
#include <fstream>
#include <map>
#include <string>

// The values of all lines `set name = value`.
static std::map<std::string, double> read(const char *file)
{
    std::map<std::string, double> values;
    std::ifstream input(file);
    for (std::string line; std::getline(input, line);) {
        const auto set = line.find("set "), equals = line.find('=');
        if (set == std::string::npos || equals == std::string::npos || line.find('#') < set)
            continue;
        const auto name = line.substr(set + 4, equals - set - 4);
        try {
            values[name.substr(0, name.find_last_not_of(' ') + 1)] = std::stod(line.substr(equals + 1));
        } catch (const std::invalid_argument &) { // a word
        }
    }
    return values;
}

int main(int count, char **arguments)
{
    if (count != 2)
        return 2;
    auto value = read(arguments[1]);
    const double radius = value.at("diameter") / 2;
    const auto compliance = [&](const std::string &body) {
        const double ratio = value.at("poisson ratio " + body);
        return (1 - ratio * ratio) / value.at("young modulus " + body);
    };
    const double modulus = 1 / (compliance("particles") + compliance("wall"));
    // Like materials have no interfacial energy, and the work of adhesion is the sum of both surface energies.
    const example::Jkr contact(radius, modulus, value.at("surface energy particles") + value.at("surface energy wall"));

    const double mass = value.at("density particles") * 4.0 / 3 * 3.14159265358979323846 * radius * radius * radius;
    const double damping = std::sqrt(mass * modulus * radius), step = value.at("time step");
    double x = value.at("list x"), velocity = value.at("list velocity x");
    for (double time = 0; time < value.at("time end"); time += step) {
        velocity += step / mass * (contact.at_indentation(radius - x).force - damping * velocity);
        x += step * velocity;
    }
    std::printf("id, type, dp, x, y, z \n0 0 %.5f %.4f %.4f %.4f \n", 2 * radius, x, value.at("list y"), value.at("list z"));
}
