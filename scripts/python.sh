#!/bin/sh
# The Python packages as a user gets them: built by pip, installed into an environment below target/, their tests, every example of
# their documentation, the notebooks, and the types. Where python3, pip or their packages cannot be had nothing is checked, and that is said.
set -eu
cd "$(dirname "$0")/.."

. scripts/python_environment.sh
python_environment python-package 'maturin>=1.14,<2' numpy pytest mypy matplotlib

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
