#!/bin/sh
# jkr.h against certified values, in C and C++, with and without fused operations; with two mistakes that the test must find; its
# snippets; Fortran where gfortran is; its largest errors by MPFR where gmpy2 can be had. What cannot be had is skipped, and that is
# said. The certified values are made anew where the program is built.
set -eu
cd "$(dirname "$0")/.."
work=${CARGO_TARGET_DIR:-$PWD/target}/jkr
mkdir -p "$work"

fails() { # a test that cannot fail is none
    if "$@" >"$work/log" 2>&1; then
        echo "error: passes in spite of a mistake: $*"
        exit 1
    fi
}

program=${CARGO_TARGET_DIR:-target}/debug/mdr
[ -x "$program" ] || program=${CARGO_TARGET_DIR:-target}/release/mdr
if [ -x "$program" ] && command -v python3 >/dev/null; then
    echo "The certified values are those of the program"
    python3 scripts/jkr_values.py "$program" | cmp - c/jkr/certified.h
else
    echo "skipped: making the certified values anew; the program is not built, or there is no python3"
fi

if ! command -v cc >/dev/null || ! command -v c++ >/dev/null; then
    echo "skipped: jkr.h; there is no cc and c++"
    exit 0
fi
strict="-O2 -Wall -Wextra -Wshadow -pedantic -Werror"

echo "jkr.h in C99"
cc -std=c99 $strict c/jkr/test_jkr.c -lm -o "$work/test" && "$work/test"
echo "jkr.h in C++11"
c++ -std=c++11 $strict -x c++ c/jkr/test_jkr.c -lm -o "$work/test++" && "$work/test++" | tail -1
if grep -qw fma /proc/cpuinfo 2>/dev/null && cc -mfma -c -x c /dev/null -o "$work/empty.o" 2>/dev/null; then
    echo "jkr.h with fused operations, optimised"
    cc -std=gnu99 -O3 -mfma c/jkr/test_jkr.c -lm -o "$work/test-fma" && "$work/test-fma" | tail -1
fi
for mistake in 's/jkr_times(c->e, 8)/jkr_times(c->e, 8.000000000000002)/' 's/delta - 2 \* u/delta - 2.00000000000001 * u/'; do
    rm -rf "$work/mistaken" && cp -r c/jkr "$work/mistaken"
    sed -i "$mistake" "$work/mistaken/jkr.h"
    if cmp -s c/jkr/jkr.h "$work/mistaken/jkr.h"; then
        echo "error: there is no place for the mistake $mistake"
        exit 1
    fi
    cc -std=c99 -O2 "$work/mistaken/test_jkr.c" -lm -o "$work/mistaken/test"
    fails "$work/mistaken/test"
done

echo "Snippets in the styles of LAMMPS and Lethe"
c++ -std=c++11 $strict -Ic/jkr examples/oracle/jkr/test_snippets.cpp -o "$work/snippets" && "$work/snippets"

echo "Times, one round"
cc -std=c99 $strict c/jkr/bench.c -lm -o "$work/bench" && "$work/bench" 1 >"$work/bench.txt" && head -4 "$work/bench.txt"

cc -std=c99 $strict -c c/jkr/jkr_fortran.c -o "$work/jkr_fortran.o"
if command -v gfortran >/dev/null; then
    gfortran -std=f2008 -O2 -Wall -Wextra -pedantic -Werror -J"$work" c/jkr/jkr.f90 c/jkr/test_jkr.f90 "$work/jkr_fortran.o" -o "$work/test-fortran"
    "$work/test-fortran"
else
    echo "skipped: Fortran; there is no gfortran (scripts/fortran.sh)"
fi

environment=$work/python
python=$environment/bin/python
if { [ -x "$python" ] || python3 -m venv "$environment" 2>/dev/null; } &&
    "$python" -m pip install --quiet --no-compile --disable-pip-version-check gmpy2 2>/dev/null; then
    echo "Largest errors in units in the last place, by MPFR"
    cc -std=c99 $strict c/jkr/accuracy.c -lm -o "$work/accuracy"
    "$work/accuracy" 20000 "${SEED:-1}" | "$python" c/jkr/accuracy.py
else
    echo "skipped: errors by MPFR; pip cannot install gmpy2"
fi
