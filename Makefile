# SPDX-License-Identifier: MIT
# A thin front for CMake. Everything lands in build*/ and out/, which git ignores.
.POSIX:
.PHONY: help build run web test bench install deb docs figures views films format mutate setup

PREFIX = /usr/local

help:
	@echo 'make run      build, then show the default scene: in a window, or without a display as out/island.png and .mp4'
	@echo 'make build    build the library and the program build/bolan'
	@echo 'make web      the sea as a web page: build/web, a static folder; installs emscripten and Chromium'
	@echo 'make test     build and run every test; the last line counts them'
	@echo 'make bench    build and run the benchmarks'
	@echo 'make install  install the program, libraries and headers under PREFIX (default /usr/local)'
	@echo 'make deb      Debian packages of the program, the libraries and the Python module: build-deb/*.deb'
	@echo 'make docs     the manual, the reference and the gallery as a site: build/docs/html/index.html'
	@echo 'make figures  the figures of the four papers again: docs/images/techniques/'
	@echo 'make views    24 views of open water in every weather, to be looked at: out/views/index.html'
	@echo 'make films    short films above, at and under the surface, to be looked at: out/films'
	@echo 'make mutate   try whether the tests can fail: hours (tools/mutate.sh --only REGEX for some)'
	@echo 'make format   clang-format every C, C++ and header file'
	@echo 'Each installs missing Debian or Ubuntu packages first (tools/setup.sh).'

setup:
	@tools/setup.sh

build:
	@tools/setup.sh build
	@tools/build.sh

run: build
	@tools/run.sh

web:
	@tools/setup.sh build web
	@tools/web.sh && echo 'The page is at build/web: python3 -m http.server -d build/web -b 127.0.0.1'

test: setup
	@tools/test.sh

bench: build
	@tools/bench.sh

install: build
	cmake --install build --prefix '$(PREFIX)'

deb:
	@tools/setup.sh build deb
	@tools/deb.sh

docs: build
	@tools/setup.sh docs
	@tools/docs.sh . build/docs build/bolan && echo 'The site is at build/docs/html/index.html'

figures: build
	@tools/figures.sh

views: build
	@tools/views.sh

films: build
	@tools/films.sh

mutate: setup
	@tools/mutate.sh

format: setup
	@tools/format.sh
