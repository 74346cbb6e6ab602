#!/bin/sh
# The explorer: target/book/explorer.html, one file with the library as WebAssembly in it, that works from file:// and asks
# nobody for anything. Where no compiler for wasm32 is found nothing is built, and what is missing is said.
set -eu
cd "$(dirname "$0")/.."
PATH=$PATH:$HOME/.cargo/bin
export PATH
target=wasm32-unknown-unknown
CARGO_TARGET_DIR=$PWD/target/web
export CARGO_TARGET_DIR

skip() {
    echo "skipped: the explorer needs a compiler for WebAssembly: $1"
    exit 0
}

# Cargo for wasm32, by the first way that works: the target is installed, rustup installs it, or Debian's compiler builds the
# standard library from its source.
has_target() { [ -d "$(rustc --print sysroot)/lib/rustlib/$target/lib" ]; }
# The library for WebAssembly alone: together with one for Rust, whole programs are not optimized, and it is 15 % larger.
only="--lib --crate-type cdylib"
command -v cargo >/dev/null || skip "there is no cargo, see https://rustup.rs"
cd web
if has_target || { command -v rustup >/dev/null && rustup target add $target >/dev/null 2>&1 && has_target; }; then
    cargo rustc --locked --release --target $target $only
elif [ -d "$(/usr/bin/rustc --print sysroot 2>/dev/null)/lib/rustlib/src/rust" ] && command -v wasm-ld >/dev/null; then
    # Unstable features are allowed for the standard library alone: the crates use none.
    RUSTFLAGS="-C linker=wasm-ld" RUSTC=/usr/bin/rustc RUSTC_BOOTSTRAP=1 /usr/bin/cargo rustc --release \
        --target $target -Zbuild-std=std,panic_abort $only
else
    skip "rustup target add $target, or on Debian: apt-get install rustc-web cargo-web rust-web-src lld"
fi
cd ..

# One page: the style, the engine (gzipped, in base64) and the scripts stand where the page has their marks.
parts=target/web/parts
page=target/book/explorer.html
scripts="engine medium scene parameters model past address plot pictures hysteresis body own tasks controls hands kept words page"
mkdir -p $parts target/book
# Pictures that are saved carry the sheet of the figures.
{
    echo '<style id="page">'
    for sheet in palette page controls screens lecture; do cat web/explorer/$sheet.css; done
    printf '</style>\n<style id="figures">\n'
    cat web/explorer/figures.css
    echo '</style>'
} >$parts/style
{
    printf '<script>window.MDR_ENGINE="'
    gzip -9 -n -c $CARGO_TARGET_DIR/$target/release/mdr_wasm.wasm | base64 | tr -d '\n'
    printf '";</script>\n<script>\n"use strict";\n'
    # Without its comments and indentation.
    for part in $scripts; do cat web/explorer/$part.js; done |
        sed -e 's/^[[:space:]]*//' -e '/^\/\//d' -e '/^\/\*\*.*\*\/$/d' -e '/^\/\*\*/,/\*\/$/d'
    echo '</script>'
} >$parts/script
sed -e "/^<!-- style -->$/{r $parts/style" -e 'd;}' -e "/^<!-- script -->$/{r $parts/script" -e 'd;}' \
    web/explorer/index.html >$page
# The pages of the book lead to it, whichever of both was made first.
echo 'window.EXPLORER=true;' >target/book/explorer-here.js
echo "$page: $(wc -c <$page) bytes, $(gzip -9 -c $page | wc -c) compressed"
