# SPDX-License-Identifier: MIT
# The core with examples and benchmarks asked for, but without files, OpenGL, C++: what lacks its library is left out
# with a sentence, the rest builds, and its installation serves a C program, also after it was moved.
set -eu
. "$BOLAN_SOURCE_DIR/tests/packaging/common"
write_programs

export CXX=/there/is/no/compiler
configure core -DBOLAN_IO=OFF -DBOLAN_RENDER=OFF
grep -q 'The program is not built: it needs bolan_io and bolan_render' core.log || fail 'no word of the program'
grep -q 'The example 03_first_frame is not built: it needs bolan_io and bolan_render' core.log || fail 'no word of example 03'
build_and_install core "$PWD/first"
for program in core/examples/01_hello_sea core/examples/02_query; do
    [ -x $program ] || fail "$program is not built"
done
[ ! -e core/examples/03_first_frame ] || fail 'example 03 is built'
[ -z "$(find first -name 'bolan_io.pc' -o -name 'bolan_render.pc')" ] || fail 'a .pc file of a library that is not there'
no_paths first "$BOLAN_SOURCE_DIR" "$PWD/core"

mv first moved
use_pkg_config "$PWD/moved" bolan bolan_content
use_find_package "$PWD/moved" bolan bolan_content
# The core links without the generated content.
! nm -C --undefined-only "$(find moved -name libbolan.a)" | grep 'bolan_content_\|bolan_pond_\|bolan_island_' ||
    fail 'the core needs bolan_content'

# A component that is not installed is missed by name.
sed -i 's/COMPONENTS.*)/COMPONENTS render)/' found/CMakeLists.txt
rm -rf found.build
! cmake -S found -B found.build -G Ninja "-DCMAKE_PREFIX_PATH=$PWD/moved" > found.log 2>&1 || fail 'a component too many'
grep -q 'bolan_render is not part of this installation' found.log || fail 'the missing component is not named'

# Drawing without files: no example or benchmark that reads files, and no program.
configure no_files -DBOLAN_IO=OFF
grep -q 'The benchmarks are not built: they need bolan_io' no_files.log || grep -q 'FFTW' no_files.log ||
    fail 'no word of the benchmarks'
grep -q 'The example 03_first_frame is not built: it needs bolan_io$' no_files.log || fail 'no word of example 03'
configure no_gl -DBOLAN_RENDER=OFF
grep -q 'The program is not built: it needs bolan_render$' no_gl.log || fail 'no word of the program without OpenGL'
