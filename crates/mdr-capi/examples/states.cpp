// The same from C++: handles that free themselves, errors as exceptions, and one contact shared by two threads.
//
//     c++ -std=c++17 states.cpp -I../include -L../../../target/capi/lib -lmdr -pthread -o states && ./states
#include "mdr.h"

#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace {

struct Free {
    void operator()(mdr_scene *scene) const { mdr_scene_free(scene); }
    void operator()(mdr_contact *contact) const { mdr_contact_free(contact); }
    void operator()(char *text) const { mdr_text_free(text); }
};

template <class T>
std::unique_ptr<T, Free> owned(T *handle)
{
    if (!handle)
        throw std::runtime_error(mdr_error());
    return std::unique_ptr<T, Free>(handle);
}

struct States {
    std::vector<double> contact_radius, indentation, force;
    std::vector<int> status;
};

class Contact {
public:
    explicit Contact(const std::string &scene) : handle(owned(mdr_contact_new(owned(mdr_scene_read(scene.c_str())).get()))) {}

    States states(mdr_control control, const std::vector<double> &values, double stiffness = 0) const
    {
        const auto n = values.size();
        States found{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n), std::vector<int>(n)};
        if (mdr_states(handle.get(), control, stiffness, MDR_LARGEST, values.data(), n, found.contact_radius.data(),
                       found.indentation.data(), found.force.data(), found.status.data()) != 0)
            throw std::runtime_error(mdr_error());
        return found;
    }

private:
    std::unique_ptr<mdr_contact, Free> handle;
};

} // namespace

int main()
{
    const Contact contact("{\"profile\": {\"kind\": \"paraboloid\", \"radius\": \"1e-5\"},"
                          " \"material\": {\"e_star\": \"1.3e6\", \"work_of_adhesion\": \"0.05\"},"
                          " \"control\": {\"kind\": \"force\"}, \"output\": {\"want\": [\"folds\"]}}");
    const double pi = 3.14159265358979323846, pull_off = -1.5 * pi * 0.05 * 1e-5;
    const std::vector<double> forces{1e-6, 0.99 * pull_off, 1.01 * pull_off};
    States found[2];
    std::thread threads[2];
    for (int i = 0; i < 2; i++)
        threads[i] = std::thread([&contact, &forces, &found, i] { found[i] = contact.states(MDR_FORCE, forces); });
    for (auto &thread : threads)
        thread.join();
    const bool agree = found[0].contact_radius[0] == found[1].contact_radius[0];
    const bool breaks = found[0].status == std::vector<int>{MDR_OK, MDR_OK, MDR_NO_EQUILIBRIUM};
    std::string refused;
    try {
        Contact("[profile]\nkind = \"spher\"\n");
    } catch (const std::runtime_error &error) {
        refused = error.what();
    }
    std::printf("a = %.10g m; breaks at the pull-off force of JKR: %s\n%s\n", found[0].contact_radius[0], breaks ? "yes" : "no",
                refused.c_str());
    return agree && breaks && std::isnan(found[0].contact_radius[2]) && refused.find("sphere") != std::string::npos ? 0 : 1;
}
