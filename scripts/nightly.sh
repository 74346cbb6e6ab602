#!/usr/bin/env sh
# What takes too long for every change, for a machine that is idle at night: the cross-check over its full grid, at the seed of
# the day, and the random properties of all crates with thirty times their cases. Both run to their ends; exit status 1 if one of
# them fails. The seed is printed: `sh scripts/nightly.sh SEED` repeats the first part, and proptest prints the seed of a failure
# for a file below proptest-regressions/ of its crate.
set -u
cd "$(dirname "$0")/.."

seed=${1:-$(date +%Y%m%d)}
failed=0

echo "== the cross-check, full, seed $seed"
cargo run --locked --bin mdr -- verify --full --seed "$seed" || failed=1

# Every property takes its cases as a share of proptest's default of 256.
echo "== the random properties, thirty times their cases"
PROPTEST_CASES=7680 QUICKCHECK_TESTS=3000 QUICKCHECK_MAX_TESTS=300000 cargo test --locked --no-fail-fast --tests \
    --package mdr-core --package mdr-analytic --package mdr-numeric --package mdr-symbolic --package mdr-reference || failed=1

exit $failed
