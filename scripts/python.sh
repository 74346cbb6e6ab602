#!/bin/sh
# The Python packages as a user gets them: built by pip, installed into an environment below target/, their tests, every example of
# their documentation, the notebooks, and the types. Where python3, pip or their packages cannot be had nothing is checked, and that is said.
set -eu
cd "$(dirname "$0")/.."

skip() {
    echo "skipped: $1"
    exit 0
}

command -v python3 >/dev/null || skip "there is no python3"
python3 -c 'import sys; sys.exit(sys.version_info < (3, 10))' || skip "python3 is older than 3.10"
environment=target/python-package
python=$environment/bin/python
[ -x "$python" ] || python3 -m venv "$environment" 2>/dev/null || skip "python3 has no venv: apt-get install python3-venv"
packages="maturin>=1.14,<2 numpy pytest mypy matplotlib"
# shellcheck disable=SC2086 # a list of packages
"$python" -m pip install --quiet --disable-pip-version-check $packages ||
    skip "pip cannot install $packages; there may be no network"

package=crates/mdr-python
wheels=target/wheels
rm -f "$wheels"/mdr_contact-*.whl "$package"/python/mdr/_core.*.so
# maturin is that of the environment, and the target folder that of the workspace: what is compiled already stays so.
PATH=$PWD/$environment/bin:$PATH:$HOME/.cargo/bin
export PATH
"$python" -m pip wheel --quiet --no-deps --no-build-isolation --wheel-dir "$wheels" "./$package"
"$python" -m pip install --quiet --force-reinstall --no-deps "$wheels"/mdr_contact-*.whl ./python/mdr-vectors
rm -rf python/mdr-vectors/build python/mdr-vectors/src/*.egg-info

pytest="$python -m pytest --config-file $package/pyproject.toml --quiet"
$pytest "$package/tests" "$package/README.md" README.md docs/python.md
$pytest python/mdr-vectors/tests python/mdr-vectors/README.md examples/oracle/pytest
$pytest --doctest-modules --pyargs mdr mdr_vectors
"$python" scripts/notebooks.py
(cd "$package" && "../../$python" -m mypy --strict python/mdr tests/typing)
(cd "$package" && MYPYPATH=python "../../$python" -m mypy.stubtest mdr._core)
