# Every task by name. Needed beforehand: Python 3.11+, a Rust toolchain, gcc and make; everything
# else goes to .venv, at the versions of requirements/*.lock.

SHELL := bash
.SHELLFLAGS := -eu -o pipefail -c
.DEFAULT_GOAL := help
.DELETE_ON_ERROR:
.NOTPARALLEL:

export PATH := $(PATH):$(or $(CARGO_HOME),$(HOME)/.cargo)/bin
export VIRTUAL_ENV := $(CURDIR)/.venv
export PIP_DISABLE_PIP_VERSION_CHECK := 1
export RUSTDOCFLAGS := -D warnings

bin := .venv/bin
pip_install := $(bin)/python -m pip install --quiet --no-input --require-hashes
sources := Cargo.toml Cargo.lock pyproject.toml $(shell find crates -name Cargo.toml -o -path '*/src/*.rs')

wasm := crates/archerfish-wasm/js/archerfish.wasm

# The explorer: its page goes into the package. Its unit tests run where there is a Node.js for them.
explorer := python/archerfish/explorer/index.html
explorer_sources := $(shell find web -name node_modules -prune -o -type f -print) \
	crates/archerfish-wasm/js/kernels.js
node := $(shell node -p 'process.versions.node.split(".")[0] >= 20 ? "node" : ""' 2> /dev/null)
# Rust need not have come by rustup; then there is no WebAssembly to test.
rustup := $(shell PATH="$(PATH)" command -v rustup)

.PHONY: help demo explore test test-large test-model test-web check lint docs wasm wheel miri fuzz bench bench-web screens figures accuracy locks clean

help: ## Show this list
	@sed -nE 's/^([a-z-]+):[^#]*## (.*)/  make \1\t\2/p' Makefile | expand -t 18

demo: .venv/package ## Compute the locus of the README, its table, CSV and Figure 1, under out/
	@mkdir -p out
	@$(bin)/archerfish locus --speed 10 --epsilon 0.1 \
		--output out/locus.csv --figure out/figure1.svg --figure out/figure1.png

explore: $(explorer) .venv/package ## Build the explorer's page, serve it on this machine, open a browser
	@$(bin)/archerfish explore

wheel: $(explorer) .venv/dev ## Build the wheel, the explorer's page in it, under dist/
	@PATH="$(CURDIR)/$(bin):$$PATH" $(bin)/maturin build --release --locked --out dist

test: .venv/test .venv/package $(if $(and $(shell command -v node),$(rustup)),$(wasm)) ## Run the Rust tests, then the Python tests
	cargo test --workspace --locked --quiet
	$(if $(and $(node),$(rustup),$(shell command -v npm)),@$(MAKE) --no-print-directory test-model)
	$(bin)/python -m pytest --quiet

test-model: $(wasm) web/node_modules/.package-lock.json ## Run the explorer's unit tests
	npm --prefix web run --silent test

test-web: $(explorer) .venv/package ## Check the explorer's types; try its page in Chromium
	npm --prefix web run --silent check
	npm --prefix web run --silent e2e

test-large: .venv/test .venv/package ## Run what needs 5 GB of memory: arrays of 10⁸ elements
	$(bin)/python -m pytest --quiet python/tests/boundary/large.py

check: ## Run the linters, the documentation's examples and the tests, as CI does
	@$(MAKE) --no-print-directory lint
	@$(MAKE) --no-print-directory docs
	@$(MAKE) --no-print-directory test-web
	@$(MAKE) --no-print-directory test

lint: .venv/dev .venv/package ## Check format, clippy, ruff, and mypy --strict, on the package and on user code
	cargo fmt --all --check
	cargo clippy --workspace --all-targets --locked --quiet -- -D warnings
	$(bin)/ruff check --quiet
	$(bin)/ruff format --check --quiet
	$(bin)/mypy
	$(bin)/mypy python/tests/boundary/typing_cases.py

docs: .venv/test .venv/package ## Build the Rust pages without a warning; run every example in the prose
	cargo doc --workspace --no-deps --locked --quiet
	$(bin)/python -m pytest --quiet --doctest-glob='*.md' README.md docs

wasm: $(wasm) ## Build the kernels for browsers and node

miri: ## Watch every memory access of the core and of the boundary's block loop (nightly Rust)
	rustup toolchain install nightly --profile minimal --component miri,rust-src
	MIRIFLAGS=-Zmiri-permissive-provenance cargo +nightly miri test --locked --lib \
		--package archerfish --package archerfish-python

fuzz_seconds := 600
fuzz: ## Search for arguments that break a kernel's laws, ten minutes a family (nightly Rust)
	rustup toolchain install nightly --profile minimal
	cargo install cargo-fuzz --locked --quiet
	for family in real lambert motion flight; do \
		cargo +nightly fuzz run $$family -- -max_len=512 -max_total_time=$(fuzz_seconds); done

bench: .venv/test .venv/package ## Time and compare with other libraries; renew the record and COMPARE.md
	$(bin)/python -m bench.compare --record

figures: .venv/package ## Draw every figure into out/figures
	$(bin)/python -m archerfish.figures out/figures

accuracy: .venv/test .venv/package ## Measure the worst errors and hold them against the record
	$(bin)/python -m reference.accuracy

locks: .venv/dev ## Choose the versions in requirements/*.lock anew
	tools/lock

bench-web: $(explorer) ## Time the explorer's frames, and weigh it
	npm --prefix web run --silent bench

screens: $(explorer) ## Take pictures of the explorer in each layout, under out/screenshots
	npm --prefix web run --silent screenshots -- "$(CURDIR)/out/screenshots"

clean: ## Remove what these tasks made
	rm -rf .venv target out web/node_modules python/archerfish/explorer

# The environment. A file in it stands for each finished step, so that a second run is quick.

# The Python to use; where a tool is missing, make stops with the one line that tools/need says.
find_tools = $(eval python := $(shell PATH="$(PATH)" PYTHON="$(PYTHON)" tools/need 2>&1))$\
             $(if $(findstring archerfish needs,$(python)),$(error $(python)))

.venv/made: tools/need
	$(find_tools)@rm -rf .venv && "$(python)" -m venv .venv
	@touch $@

.venv/demo .venv/test .venv/dev: .venv/%: requirements/%.lock requirements/build.lock | .venv/made
	@echo "Installing the packages of $< into .venv"
	@$(pip_install) -r requirements/build.lock -r $<
	@touch $@

.venv/package: $(sources) | .venv/demo
	$(find_tools)@echo "Compiling the kernels (about a minute the first time)"
	@PATH="$(CURDIR)/$(bin):$$PATH" $(bin)/python -m pip install --quiet --no-input \
		--no-index --no-deps --no-build-isolation --editable .
	@touch $@

$(wasm): $(sources)
	@tools/need > /dev/null
	@rustup target add wasm32-unknown-unknown 2> /dev/null || { echo "make wasm needs rustup," \
		"which fetches Rust's library for WebAssembly: install it (https://rustup.rs)" >&2; exit 1; }
	@echo "Compiling the kernels to WebAssembly"
	@RUSTFLAGS="-C target-feature=+simd128 -C link-arg=--compress-relocations" cargo build --quiet \
		--locked --package archerfish-wasm --profile wasm --target wasm32-unknown-unknown --target-dir target
	@cp target/wasm32-unknown-unknown/wasm/archerfish.wasm $@

web/node_modules/.package-lock.json: web/package.json web/package-lock.json
	$(if $(node),,$(error make needs Node.js 20.19 or newer for the explorer: install it (https://nodejs.org), then run this again))
	@echo "Installing the packages of the explorer"
	@npm --prefix web ci --silent --no-audit --no-fund
	@touch $@

$(explorer): $(wasm) web/node_modules/.package-lock.json $(explorer_sources)
	@npm --prefix web run --silent build
