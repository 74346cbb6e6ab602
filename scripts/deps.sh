#!/bin/sh
# Finds what the first build needs beside a Rust toolchain: a C compiler, and m4 and diff for the configure step of GMP.
# Missing m4 or diff are installed with the system's package manager where that is allowed; otherwise the command to
# type is printed and the exit status is 1.
set -eu

have() { command -v "$1" >/dev/null 2>&1; }

stop() {
    printf 'deps: %s\n' "$*" >&2
    exit 1
}

# The command that installs the packages "$@", by the first package manager found; empty when none is known.
install_command() {
    if have apt-get; then echo "apt-get install -y $*"
    elif have dnf; then echo "dnf install -y $*"
    elif have pacman; then echo "pacman -Sy --noconfirm --needed $*"
    elif have zypper; then echo "zypper --non-interactive install $*"
    elif have apk; then echo "apk add --no-cache $*"
    elif have brew; then echo "brew install $*"
    fi
}

# "sudo" when it is needed and asks for no password, nothing for root or Homebrew; fails when neither is possible.
privilege() {
    case $1 in brew*) return 0 ;; esac
    [ "$(id -u)" -eq 0 ] && return 0
    have sudo && sudo -n true 2>/dev/null && echo sudo
}

# A C compiler: the one named by CC, else cc.
compiler=${CC:-cc}
have "${compiler%% *}" || stop "no C compiler ($compiler): install one, for example with
    $(install_command gcc)"
have cargo || stop "no cargo: install a Rust toolchain first, see https://rustup.rs"

missing=
have "${M4:-m4}" || missing="$missing m4"
have diff || missing="$missing diffutils"
missing=${missing# }
[ -n "$missing" ] || exit 0

# shellcheck disable=SC2086 # a list of packages
command=$(install_command $missing)
[ -n "$command" ] || stop "missing: $missing, and no known package manager: install with the one of your system"
sudo=$(privilege "$command") || stop "missing: $missing (GMP is built from source). Type, then try again:
    sudo $command"

typed="$sudo${sudo:+ }$command"
echo "deps: $typed" >&2
case $command in apt-get*)
    # The lists of a fresh image are empty or stale; an unreachable extra source must not stop us.
    $sudo apt-get update -q >&2 || true
    command="env DEBIAN_FRONTEND=noninteractive $command -o DPkg::Lock::Timeout=120" ;;
esac
$sudo $command >&2 || stop "could not install: $missing. Type, then try again:
    $typed"

# Homebrew keeps m4 out of PATH; the Makefile adds its directory.
case $command in brew*) PATH="$PATH:$(brew --prefix m4)/bin" ;; esac
have "${M4:-m4}" || stop "m4 was installed but is not in PATH"
