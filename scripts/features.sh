#!/bin/sh
# Every choice of features that a user of the libraries can make compiles without a warning. A line of the list: package, features.
# (cargo hack clippy --feature-powerset does the same where cargo-hack can be had.) The default features of all packages, and the
# libraries with serde and toml but without mp, are checked with their tests by lints.sh: they are no lines here. Those without GMP
# come first.
set -eu
cd "$(dirname "$0")/.."

while read -r package features; do
    echo "== $package: ${features:-no features}"
    cargo clippy --locked --quiet --lib --package "$package" --no-default-features --features "$features" -- -D warnings
done <<'LIST'
mdr-analytic small
mdr-contact
mdr-contact small,toml
mdr-contact serde
mdr-fit
mdr-fit toml
mdr-provenance
mdr-contact mp
mdr-contact mp,toml
mdr-contact mp,serde
mdr-fit mp
mdr-plot
mdr-plot fit
LIST
