# The newcomer's commands. Each does all the set-up that it needs.
#   make demo    install what is missing, build, run the bundled case from image to permeability
#   make check   install what is missing, build, run tests and fuzzers (this is what CI runs)
#   make install install the program below PREFIX (/usr/local)
#   make bench   speed: kernels against the memory bandwidth of this machine
BUILD := build/release
export CCACHE_BASEDIR := $(CURDIR)

.PHONY: all setup build install demo check bench compare-openfoam compare-liggghts compare-coupled cross-check validate lint format fuzz clean

all: build

setup:
	@tools/install_packages.sh

build: setup
	@cmake --preset release -Wno-dev > build-configure.log 2>&1 || { cat build-configure.log; exit 1; }
	@rm -f build-configure.log
	@cmake --build --preset release

PREFIX ?= /usr/local
install: build
	@cmake --install $(BUILD) --prefix $(PREFIX)

demo: build
	@tools/demo.sh

check: build
	@tools/check.sh

bench: build
	@cmake --build --preset release --target porefines_bench
	@$(BUILD)/bench/porefines_bench

compare-openfoam: build
	@bench/openfoam/compare.sh

compare-liggghts: build
	@cmake --build --preset release --target dem_speed
	@bench/liggghts/compare.sh

cross-check: build
	@bash -c '. bench/need_packages.sh; need_packages openfoam liggghts'
	@ctest --preset engines

compare-coupled: build
	@bench/coupled/compare.sh

validate: build
	@ctest --preset validate

lint: build
	@tools/lint.sh

fuzz: setup
	@tools/fuzz.sh

format:
	@git ls-files '*.cpp' '*.hpp' | xargs clang-format -i

clean:
	@rm -rf build
