#!/bin/sh
# The explorer and the book in a browser, without a window: what a reader sees and does, the numbers of the explorer against
# `mdr solve --f64`, frames and sizes; axe on both. playwright-core and axe-core are installed below target/, Chromium by the
# system's packages where that may be done. Where one of them cannot be had nothing is checked, and that is said. CHROMIUM and
# MDR name other programs. With --install the tools are fetched and nothing is checked; with --untimed all is checked but what is
# timed, with --timed that alone.
set -eu
cd "$(dirname "$0")/.."

skip() {
    echo "skipped: $1"
    exit 0
}

part=${1:-}
[ "$part" = --install ] || [ -f target/book/explorer.html ] || skip "there is no target/book/explorer.html: make site"
command -v node >/dev/null || skip "there is no node"
node -e 'process.exit(Number.parseInt(process.versions.node) < 20 ? 1 : 0)' || skip "node is older than 20"

modules=target/browser
if [ ! -d $modules/node_modules/axe-core ] || [ ! -d $modules/node_modules/playwright-core ]; then
    command -v npm >/dev/null || skip "there is no npm"
    npm install --silent --no-fund --no-audit --prefix $modules playwright-core@1 axe-core@4 ||
        skip "npm cannot install playwright-core and axe-core; there may be no network"
fi

# Chromium without its windows is preferred: pages open with a third of the work.
find_browser() {
    for name in ${CHROMIUM:+"$CHROMIUM"} chromium-headless-shell chromium chromium-browser google-chrome google-chrome-stable chrome; do
        command -v "$name" && return 0
    done
    [ -x /Applications/Google\ Chrome.app/Contents/MacOS/Google\ Chrome ] &&
        echo /Applications/Google\ Chrome.app/Contents/MacOS/Google\ Chrome
}
if ! CHROMIUM=$(find_browser); then
    sudo=
    [ "$(id -u)" -eq 0 ] || sudo="sudo -n"
    if command -v apt-get >/dev/null && $sudo true 2>/dev/null; then
        $sudo apt-get update -qq >/dev/null 2>&1 || true
        for package in chromium-headless-shell chromium; do
            echo "site-test: apt-get install $package" >&2
            $sudo env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $package >/dev/null 2>&1 && break
        done
    fi
    CHROMIUM=$(find_browser) || skip "there is no Chromium; on Debian, as root: apt-get install chromium"
fi
[ "$part" = --install ] && exit 0

for program in "${MDR:-}" target/release/mdr target/debug/mdr; do
    [ -n "$program" ] && [ -x "$program" ] && break
done
if [ ! -x "$program" ]; then
    cargo build --locked --package mdr-cli
    program=target/debug/mdr
fi

MDR=$(cd "$(dirname "$program")" && pwd)/$(basename "$program")
export CHROMIUM MDR
# Three files at a time: their pages mostly wait. Alone what is timed.
[ "$part" = --timed ] ||
    node --test --test-concurrency=3 --test-reporter=spec web/tests/physics.test.mjs web/tests/book.test.mjs \
        web/tests/page.test.mjs web/tests/failures.test.mjs web/tests/screens.test.mjs
[ "$part" = --untimed ] || exec node --test --test-reporter=spec web/tests/speed.test.mjs
