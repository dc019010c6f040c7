# SPDX-License-Identifier: BSD-3-Clause
# vtkInk's two commands are `make demo` and `make test`; `make help` lists the rest.
# The work is done by the scripts in Utilities/, this file only says what follows what.

.DEFAULT_GOAL := help
.NOTPARALLEL:
.PHONY: help demo test setup setup-headless setup-paraview setup-aarch64 build build-ink build-headless \
  build-paraview build-benchmarks build-asan build-tsan build-aarch64 test-headless test-paraview test-aarch64 bench tradeoff pictures \
  window-pictures sanitize fuzz format tidy install clean

help: ## List the targets
	@sed -n 's/^\([a-z0-9-]*\):.*## \(.*\)/  make \1|\2/p' $(MAKEFILE_LIST) | awk -F'|' '{ printf "%-22s %s\n", $$1, $$2 }'

# Faster from nothing.
demo test: export INK_UNITY_BUILD := ON

demo: setup-headless build-ink ## Set up, build, and draw a CT scan of an engine to pictures
	@Utilities/demo.sh

# What setup has installed has to be there.
test: export CI := true
test: setup build test-headless test-paraview ## Set up, build both VTK builds, run every test

setup: setup-headless setup-paraview ## Install what both builds need (Debian packages, VTK from PyPI)

build: build-headless build-paraview ## Build with VTK 9.7 (headless) and with ParaView 5.11's VTK

setup-headless: ## Install what the build with VTK 9.7 needs
	@Utilities/setup.sh headless

setup-paraview: ## Install what the build with ParaView needs
	@Utilities/setup.sh paraview

build-ink: ## Build with VTK 9.7 no more than the command-line program
	@Utilities/build.sh headless --target ink

build-headless: ## Build with VTK 9.7
	@Utilities/build.sh headless

build-paraview: ## Build with ParaView 5.11's VTK, the plugin included
	@Utilities/build.sh paraview

build-benchmarks: ## Build with VTK 9.7, the benchmarks included, which no test needs
	@Utilities/build.sh headless -DVTKINK_BUILD_BENCHMARKS=ON

build-asan: ## Build with the address and undefined-behavior sanitizers
	@Utilities/build.sh asan

build-tsan: ## Build with the thread sanitizer
	@Utilities/build.sh tsan

setup-aarch64: ## Install what Common's build for 64-bit ARM needs
	@Utilities/setup.sh aarch64

build-aarch64: ## Build Common and its tests for 64-bit ARM
	@Utilities/build.sh aarch64

test-headless: ## Run the tests of the headless build
	@Utilities/test.sh headless

test-paraview: ## Run the tests of the ParaView build
	@Utilities/test.sh paraview

test-aarch64: setup-aarch64 build-aarch64 ## Run Common's tests as programs of 64-bit ARM, under QEMU
	@ctest --preset aarch64 --parallel "$$(Utilities/jobs.sh)"

bench: setup-headless build-benchmarks ## Measure vtkInk against VTK's own, and the temporal coherence of marks
	@Utilities/bench.sh

tradeoff: setup-headless build-benchmarks ## Measure error against time, write Documentation/accuracy-and-speed.md
	@Utilities/setup.sh tradeoff
	@Utilities/tradeoff.sh

pictures: setup-headless build-headless ## Draw the pictures of the pages on styles and of picture-quality.md (of one: Utilities/pictures.sh PAGE)
	@Utilities/pictures.sh

window-pictures: setup-paraview build-paraview ## Draw the pictures of ParaView's window (of one: Utilities/window-pictures.sh REPRESENTATION)
	@Utilities/setup.sh window-pictures
	@Utilities/window-pictures.sh

sanitize: setup-headless build-asan ## Run the tests under the address and undefined-behavior sanitizers
	@Utilities/test.sh asan

fuzz: setup-headless ## Fuzz what ink reads, each FORMAT (all, or as ply) for SECONDS (60)
	@Utilities/setup.sh fuzz
	@Utilities/fuzz.sh $(or $(SECONDS),60) $(FORMAT)

format: ## Format the C++ files (clang-format)
	@git ls-files '*.h' '*.cxx' '*.cpp' | xargs clang-format -i

tidy: setup-headless build-ink ## Check the sources of libraries and programs, or FILES (clang-tidy)
	@Utilities/setup.sh tidy
	@Utilities/tidy.sh $(FILES)

install: build-headless ## Install the headless build into PREFIX (default build/install/headless)
	@cmake --install build/headless $(if $(PREFIX),--prefix "$(PREFIX)")

clean: ## Remove the build trees (what setup fetched stays)
	@rm -rf build/headless build/paraview build/asan build/tsan build/aarch64 build/fuzz build/tidy build/demo build/install build/ccache build/*.log
