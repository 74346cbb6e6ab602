#!/bin/sh
# What of the Python package needs others: models for nanite, files of afmformats, sweeps with Dask. In an environment of its own, since
# these bring a hundred packages; after `make python`, whose wheel is tested. Where they cannot be had nothing is checked, and that is said.
set -eu
cd "$(dirname "$0")/.."

. scripts/python_environment.sh
python_environment python-nanite nanite==4.2.3 afmformats distributed pytest
[ "${1:-}" = --install ] && exit 0

wheel=$(ls target/wheels/mdr_contact-*.whl 2>/dev/null) || skip "there is no wheel: make python"
"$python" -m pip install --quiet --no-compile --disable-pip-version-check --force-reinstall --no-deps "$wheel"
"$python" -m pytest --quiet -p no:cacheprovider examples/nanite examples/sweeps
