#!/usr/bin/env bash
# scripts/same.sh OLD NEW: whether two programs `mdr` give the same answers, byte for byte.
#
# The corpus: every example scene at its own digits, at 20 digits and in f64, each as JSON, CSV and table; the messages of
# every bad scene; `mdr critical` over exponents, controls and scales; `mdr verify --quick` at three seeds; the derivations;
# the data of the figures; the records. Prints each difference, and ends with status 1 if there is one.
set -euo pipefail
[ $# -eq 2 ] || { echo "usage: scripts/same.sh OLD NEW (two programs mdr)" >&2; exit 2; }
old=$(realpath "$1") new=$(realpath "$2")
cd "$(dirname "$0")/.."
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
asked=0 different=0

# Asks both the same question and compares output, messages and exit status.
same() {
    local program
    for program in old new; do
        local status=0
        NO_COLOR=1 "${!program}" "$@" >"$work/$program" 2>"$work/$program.messages" </dev/null || status=$?
        { cat "$work/$program.messages"; echo "exit status $status"; } >>"$work/$program"
    done
    asked=$((asked + 1))
    if ! cmp -s "$work/old" "$work/new"; then
        different=$((different + 1))
        echo "== mdr $*"
        diff "$work/old" "$work/new" | cut -c 1-400 | head -n 20 || true
    fi
}

for scene in examples/scenes/*.toml; do
    for format in json csv table; do
        same solve "$scene" --format "$format"
        same solve "$scene" --format "$format" --digits 20
        same solve "$scene" --format "$format" --f64
    done
done
for scene in tests/command_line/bad_scenes/*.toml; do
    same solve "$scene"
done
for n in 0.1 0.25 0.49999999 0.5 1/2 0.6 1 1.5 2 7.3 150; do
    for control in "indentation" "force" "machine --stiffness 1" "machine --stiffness 1e-30"; do
        for scale in "--c 2.4829 --e-star 1 --work 1" "--c 1e-40 --e-star 1e9 --work 0.05"; do
            # shellcheck disable=SC2086 # words are flags
            for arithmetic in "--digits 30" "--f64"; do
                same critical --n $n $scale --control $control $arithmetic --format json
            done
        done
    done
done
for seed in 0 1 2; do
    same verify --quick --seed "$seed" --format json
done
same derive
same derive --format markdown
same derive --format latex
same reference --format json
for program in old new; do
    mkdir "$work/figures-$program"
    "${!program}" figures --out "$work/figures-$program" >/dev/null 2>&1
    (cd "$work/figures-$program" && cat -- *.csv) >"$work/csv-$program"
done
asked=$((asked + 1))
cmp -s "$work/csv-old" "$work/csv-new" || { different=$((different + 1)); echo "== mdr figures: the data differ"; }

echo "$asked questions, $different answered differently"
[ "$different" -eq 0 ]
