# make verify   the theory against the independent computation (arguments: make verify ARGS="--quick")
# make test     all tests
# make nightly  both with many more cases
# make lints    layout, lints of every choice of features, documentation, and the build without GMP
# The first build compiles GMP and MPFR from source and takes some minutes.

# Where rustup puts cargo, and where Homebrew hides m4, when the shell does not look there.
export PATH := $(PATH):$(HOME)/.cargo/bin:/opt/homebrew/opt/m4/bin:/usr/local/opt/m4/bin

ARGS ?=

.PHONY: verify test lints nightly build deps bench doc confirm proofs dist peers peers-fit peers-states python nanite oracle jkr capi book site site-test site-test-untimed site-test-timed site-tools nanite-tools

# In the profile of the tests, with which it shares what is compiled: nearly all of its time is MPFR's, so a release is no faster.
verify: deps
	cargo run --locked --bin mdr -- verify $(ARGS)

test: deps
	cargo test --locked

# What must be clean before a commit.
lints: deps
	@sh scripts/lints.sh

# The full cross-check at the seed of the day, and the random properties with thirty times their cases: an hour or two.
nightly: deps
	@sh scripts/nightly.sh

build: deps
	cargo build --locked --release --package mdr-cli

bench: deps
	cargo bench --locked --workspace

doc: deps
	cargo doc --locked --workspace --no-deps

# The theory as a static site, target/book/index.html: checked without a browser, and written.
book: deps
	cargo test --locked --test book
	$${CARGO_TARGET_DIR:-target}/debug/mdr-book

# The certified values once more, by Arb, and their certificates: installs python-flint below target/ if it can.
confirm: deps
	@sh scripts/confirm.sh

# The theorems of docs/proofs, by Coq: installs Debian's packages if it may.
proofs:
	@sh scripts/proofs.sh

# The Python package: a wheel in target/wheels, installed below target/ and tested; skipped where pip cannot be had.
python:
	@sh scripts/python.sh

# Models for nanite, files of afmformats, and sweeps with Dask, with the wheel of `make python`; skipped where they cannot be had.
nanite:
	@sh scripts/nanite.sh

# What nanite needs, where it can be had.
nanite-tools:
	@sh scripts/nanite.sh --install

# The explorer, target/book/explorer.html: the library as WebAssembly in one page; says what is missing where it cannot be built.
site:
	@sh scripts/site.sh

# The explorer and the book in a browser without a window, the numbers of the explorer against those of the program; skipped where
# there is no browser.
site-test:
	@sh scripts/site_test.sh

# site-test in two parts: what is timed needs a processor to itself.
site-test-untimed:
	@sh scripts/site_test.sh --untimed

site-test-timed:
	@sh scripts/site_test.sh --timed

# What site-test needs, where it can be had.
site-tools:
	@sh scripts/site_test.sh --install

# The ready tests of examples/oracle in C++, for Lethe and for LAMMPS, against small codes and against LAMMPS itself.
oracle:
	@sh scripts/oracle.sh

# jkr.h against certified values, its snippets and its Fortran module.
jkr:
	@sh scripts/jkr.sh

# libmdr and mdr.h in target/capi, for C and what speaks C (without GMP: make capi ARGS=--no-default-features).
capi: deps
	@sh scripts/capi.sh $(ARGS)

# Times of Arb, scipy and mpmath beside those of this workspace; installs them below target/.
peers: build
	python3 -m venv target/python
	target/python/bin/python -m pip install --quiet python-flint scipy mpmath
	target/python/bin/python scripts/peers.py

# A fit beside scipy.
peers-fit: python
	target/python-package/bin/python -m pip install --quiet scipy
	target/python-package/bin/python scripts/peers_fit.py

# States in arrays beside numpy.
peers-states: python
	target/python-package/bin/python scripts/peers_states.py

deps:
	@sh scripts/deps.sh

# The program, compiled to be small, and the licences of what it links, in target/dist.
dist: deps
	cargo build --locked --profile small --package mdr-cli
	mkdir -p target/dist
	cp $${CARGO_TARGET_DIR:-target}/small/mdr target/dist/mdr
	cp LICENSE-MIT LICENSE-APACHE docs/dependencies.md target/dist/
