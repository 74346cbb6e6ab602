#!/bin/sh
# libmdr with its header in target/capi: capi.sh [--no-default-features]. A program in C is linked with it and run.
set -eu
cd "$(dirname "$0")/.."
target=${CARGO_TARGET_DIR:-target}
cargo build --locked --release --package mdr-capi "$@"
mkdir -p "$target/capi/include" "$target/capi/lib"
cp crates/mdr-capi/include/mdr.h "$target/capi/include/"
cp "$target/release/libmdr_c.a" "$target/capi/lib/libmdr.a"
for library in "$target"/release/libmdr_c.so "$target"/release/libmdr_c.dylib; do
    [ -f "$library" ] && cp "$library" "$target/capi/lib/libmdr.${library##*.}"
done
cc -std=c99 crates/mdr-capi/tests/border.c -I"$target/capi/include" -L"$target/capi/lib" -Wl,-rpath,"$PWD/$target/capi/lib" -lmdr -lm \
    -o "$target/capi/border"
"$target/capi/border"
echo "$target/capi: include/mdr.h, lib/libmdr"
