#!/bin/sh
# What must be clean: the layout, lints of everything and of every choice of features, the documentation, and the build without GMP.
# The latter comes first: it needs nothing that takes long.
set -eu
cd "$(dirname "$0")/.."

step() { printf '\n== %s\n' "$1"; }

step "format"
cargo fmt --all --check

step "without mp: no GMP, f64 only"
light="--locked --package mdr-core --package mdr-analytic --package mdr-numeric --package mdr-contact --package mdr-capi
    --package mdr-fit --no-default-features --features mdr-contact/serde,mdr-contact/toml,mdr-fit/serde,mdr-fit/toml"
# shellcheck disable=SC2086
tree=$(cargo tree --edges normal $light)
if echo "$tree" | grep -qE 'gmp-mpfr-sys|clap|indicatif|plotters|comfy-table'; then
    echo "error: a crate without its feature mp depends on GMP, or a library on a terminal:" >&2
    echo "$tree" >&2
    exit 1
fi
# shellcheck disable=SC2086
cargo clippy $light --all-targets -- -D warnings
# Only mdr has code for this build; the tests of the other three are among all tests.
cargo test --locked --package mdr-contact --no-default-features --features serde,toml

step "every choice of features"
sh scripts/features.sh

step "lints, benchmarks included"
cargo clippy --locked --workspace --all-targets -- -D warnings

step "documentation"
RUSTDOCFLAGS="-D warnings" cargo doc --locked --workspace --no-deps
