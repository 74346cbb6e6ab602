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
        python3 -m venv target/python 2>/dev/null && "$python" -m pip install --quiet --no-compile python-flint 2>/dev/null ||
            python=python3
    fi
fi

status=0
"$python" tests/confirm_records.py || status=$?
if [ "$status" -eq 0 ]; then
    "$python" tests/confirm_fits.py || [ $? -eq 77 ]
    # Certificates: those of the tests, each with every fault that has to be refused; and those of the records, which mdr writes.
    "$python" tests/certificates/refuse.py
    "$python" scripts/check_certificates.py tests/certificates/*.json
    if command -v cargo >/dev/null; then
        mkdir -p target
        cargo run --locked --quiet --bin mdr -- reference --certificates target/certificates.jsonl
        "$python" scripts/check_certificates.py target/certificates.jsonl --records crates/mdr-reference/data/*.jsonl
    else
        echo "skipped: the certificates of the records, which Cargo would build mdr to write"
    fi
fi
# 77: python-flint could not be installed; the script has said so.
[ "$status" -eq 77 ] || exit "$status"
