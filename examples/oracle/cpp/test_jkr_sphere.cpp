// The certified table jkr-sphere against example::Jkr, as tests of Catch2 (2 or 3) or GoogleTest; without either the checks are
// counted by a main of their own.
//
//     c++ -std=c++17 test_jkr_sphere.cpp && ./a.out                                   # whichever is found
//     c++ -std=c++17 -DUSE_GTEST test_jkr_sphere.cpp -lgtest -lgtest_main -pthread    # GoogleTest
#include "jkr-sphere.h" // the data: mdr reference --table jkr-sphere --export jkr-sphere.h
#include "jkr.hpp"      // the code to be tested

#include <cmath>
#include <cstring>

#if defined(USE_GTEST)
#include <gtest/gtest.h>
#define CASE(name, tag) TEST(jkr_sphere, name)
#define HOLDS(condition, row) EXPECT_TRUE(condition) << (row).id << ": " << (row).note
#elif __has_include(<catch2/catch_test_macros.hpp>)
#include <catch2/catch_test_macros.hpp>
#define CASE(name, tag) TEST_CASE(#name, tag)
#elif __has_include(<catch2/catch.hpp>)
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
#define CASE(name, tag) TEST_CASE(#name, tag)
#else
#include <cstdio>
static int checked, failed;
#define CASE(name, tag) static void name()
#define HOLDS(condition, row) \
    (++checked, (condition) ? (void)0 : (void)(++failed, std::printf("%s fails: %s\n", (row).id, (row).note)))
#define OWN_MAIN
#endif
#ifndef HOLDS
#define HOLDS(condition, row) do { INFO((row).id << ": " << (row).note); CHECK(condition); } while (false)
#endif

// The tolerance of a row is four roundings times its condition; a code with some more operations gets some more of them.
static constexpr double ROUNDINGS = 4;

static bool is(const char *text, const char *word) { return std::strcmp(text, word) == 0; }

static bool near(double found, double certified, double tolerance)
{
    return std::fabs(found - certified) <= ROUNDINGS * tolerance * std::fabs(certified);
}

static bool near(const example::State &found, const mdr_jkr_sphere &row)
{
    return near(found.radius, row.contact_radius, row.tolerance) && near(found.force, row.force, row.tolerance) &&
           near(found.indentation, row.indentation, row.tolerance);
}

CASE(pull_off, "[jkr]")
{
    for (const auto &row : mdr_jkr_sphere_rows) {
        const example::Jkr contact(row.radius, row.e_star, row.work_of_adhesion);
        if (is(row.question, "fold"))
            HOLDS(near(is(row.control, "force") ? contact.pull_off_by_force() : contact.pull_off_by_indentation(), row), row);
    }
}

CASE(equilibria, "[jkr]")
{
    for (const auto &row : mdr_jkr_sphere_rows) {
        const example::Jkr contact(row.radius, row.e_star, row.work_of_adhesion);
        if (!is(row.question, "equilibrium") || is(row.branch, "unstable"))
            continue;
        const bool by_force = is(row.control, "force");
        const auto found = by_force ? contact.at_force(row.force) : contact.at_indentation(row.indentation);
        if (is(row.status, "ok"))
            HOLDS(near(found, row), row);
        else // past the fold there is nothing to find, and a number would be wrong
            HOLDS(std::isnan(found.radius), row);
    }
}

#ifdef OWN_MAIN
int main()
{
    pull_off();
    equilibria();
    std::printf("%d checks, %d failed\n", checked, failed);
    return failed != 0;
}
#endif
