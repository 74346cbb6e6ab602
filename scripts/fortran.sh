#!/bin/sh
# gfortran, with which what is written for Fortran is compiled and run in tests: the module over jkr.h, the table of records, the example
# of libmdr. It is installed where that may be done (a Debian-like system, as root or with sudo that asks no password).
set -eu
command -v gfortran >/dev/null && exit 0
sudo=
[ "$(id -u)" -eq 0 ] || sudo="sudo -n"
if command -v apt-get >/dev/null && $sudo true 2>/dev/null; then
    echo "fortran: apt-get install gfortran" >&2
    $sudo apt-get update -qq >/dev/null 2>&1 || true
    $sudo env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=120 install -y -qq --no-install-recommends gfortran >/dev/null 2>&1 || true
fi
command -v gfortran >/dev/null || echo "skipped: Fortran; on Debian, as root: apt-get install gfortran"
