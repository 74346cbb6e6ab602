#!/bin/sh
# What of the Python package needs others: models for nanite, files of afmformats, sweeps with Dask. In an environment of its own, since
# these bring a hundred packages; after `make python`, whose wheel is tested. Where they cannot be had nothing is checked, and that is said.
set -eu
cd "$(dirname "$0")/.."

skip() {
    echo "skipped: $1"
    exit 0
}

command -v python3 >/dev/null || skip "there is no python3"
python3 -c 'import sys; sys.exit(sys.version_info < (3, 10))' || skip "python3 is older than 3.10"
environment=target/python-nanite
python=$environment/bin/python
[ -x "$python" ] || python3 -m venv "$environment" 2>/dev/null || skip "python3 has no venv: apt-get install python3-venv"
packages="nanite==4.2.3 afmformats distributed pytest"
# shellcheck disable=SC2086 # a list of packages
"$python" -m pip install --quiet --disable-pip-version-check $packages ||
    skip "pip cannot install $packages; there may be no network"
[ "${1:-}" = --install ] && exit 0

wheel=$(ls target/wheels/mdr_contact-*.whl 2>/dev/null) || skip "there is no wheel: make python"
"$python" -m pip install --quiet --disable-pip-version-check --force-reinstall --no-deps "$wheel"
"$python" -m pytest --quiet -p no:cacheprovider examples/nanite examples/sweeps
