#!/bin/sh
# The theorems of docs/proofs, checked by Coq's kernel. Coq 8.16 with Coquelicot and Interval is installed where that may be
# done (a Debian-like system, as root or with sudo that asks no password); without it nothing is checked, and that is said.
set -eu
cd "$(dirname "$0")/.."

packages="coq libcoq-coquelicot libcoq-interval"

# Are Coq and the two libraries there?
have() {
    command -v coqc >/dev/null || return 1
    folder=$(mktemp -d)
    echo "From Coquelicot Require Coquelicot. From Interval Require Tactic." >"$folder/probe.v"
    status=0
    coqc "$folder/probe.v" >/dev/null 2>&1 || status=1
    rm -r "$folder"
    return $status
}

if ! have; then
    sudo=
    [ "$(id -u)" -eq 0 ] || sudo="sudo -n"
    if command -v apt-get >/dev/null && $sudo true 2>/dev/null; then
        echo "proofs: apt-get install $packages" >&2
        $sudo apt-get update -qq >/dev/null 2>&1 || true
        # shellcheck disable=SC2086 # a list of packages
        $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $packages >/dev/null 2>&1 || true
    fi
    if ! have; then
        echo "skipped: Coq with Coquelicot and Interval is not there; on Debian 12, as root, type:
    apt-get install --no-install-recommends $packages"
        exit 0
    fi
fi
if ! command -v python3 >/dev/null; then
    echo "skipped: there is no python3"
    exit 0
fi
exec python3 scripts/check_proofs.py
