# For scripts that are skipped where Python cannot be had: `skip WHY`, and `python_environment FOLDER PACKAGE…`, which sets python to
# that of an environment below target/ with these packages.

skip() {
    echo "skipped: $1"
    exit 0
}

python_environment() {
    environment=target/$1
    shift
    command -v python3 >/dev/null || skip "there is no python3"
    python3 -c 'import sys; sys.exit(sys.version_info < (3, 10))' || skip "python3 is older than 3.10"
    python=$environment/bin/python
    [ -x "$python" ] || python3 -m venv "$environment" 2>/dev/null || skip "python3 has no venv: apt-get install python3-venv"
    "$python" -m pip install --quiet --no-compile --disable-pip-version-check "$@" ||
        skip "pip cannot install $*; there may be no network"
}
