#!/bin/sh
# The certified records once more, in Arb. Python's package python-flint is installed below target/ if it is not there and
# can be had; without it nothing is confirmed, and that is said.
set -eu
cd "$(dirname "$0")/.."

python=python3
if ! command -v "$python" >/dev/null; then
    echo "skipped: there is no python3"
    exit 0
fi
if ! "$python" -c 'import flint' 2>/dev/null; then
    python=target/python/bin/python
    if ! "$python" -c 'import flint' 2>/dev/null; then
        python3 -m venv target/python 2>/dev/null && "$python" -m pip install --quiet python-flint 2>/dev/null ||
            python=python3
    fi
fi

status=0
"$python" tests/confirm_records.py || status=$?
# 77: python-flint could not be installed; the script has said so.
[ "$status" -eq 77 ] || exit "$status"
