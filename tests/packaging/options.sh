# SPDX-License-Identifier: MIT
# Flags and options as users and other projects set them. Nothing is built here but one file for 32 bits.
set -eu
. "$BOLAN_SOURCE_DIR/tests/packaging/common"
core='-DBOLAN_IO=OFF -DBOLAN_RENDER=OFF -DBOLAN_APPS=OFF -DBOLAN_BENCH=OFF -DBOLAN_EXAMPLES=OFF -DBOLAN_TESTS=OFF'

# flags FOLDER: how the folder compiles one file of the core.
flags() {
    ninja -C "$1" -t commands libbolan.a | grep 'src/waves/sea\.c$' || fail "$1 does not compile src/waves/sea.c"
}
# compiles FOLDER WITH|WITHOUT FLAG
compiles() {
    case "$2 $(flags "$1") " in
    WITH\ *" $3 "*) ;;
    WITH\ *) fail "$1: no $3 in $(flags "$1")" ;;
    *" $3 "*) fail "$1: $3 in $(flags "$1")" ;;
    esac
}
# plain FOLDER OPTIONS...: a release of the core with no flags but those given.
plain() {
    folder=$1
    shift
    # shellcheck disable=SC2086 # words
    cmake -S "$BOLAN_SOURCE_DIR" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release $core "$@" > "$folder.log" 2>&1 ||
        fail "cmake $*"
}

plain default
compiles default WITH -O2
compiles default WITH -g1
compiles default WITH -DNDEBUG
plain release -DCMAKE_C_FLAGS_RELEASE='-O3 -DMINE'
compiles release WITH -O3
compiles release WITH -DMINE
compiles release WITHOUT -O2
compiles release WITHOUT -g1
(
    export CFLAGS='-Os -g3'
    plain environment
)
compiles environment WITH -Os
compiles environment WITH -g3
compiles environment WITHOUT -O2
compiles environment WITHOUT -g1
plain variable -DCMAKE_C_FLAGS=-O1
compiles variable WITH -O1
compiles variable WITHOUT -O2
compiles variable WITH -g1

# In another project: its flags, and nothing of Bolan in its installation unless it asks.
mkdir parent
cat > parent/CMakeLists.txt << END
cmake_minimum_required(VERSION 3.22)
project(parent LANGUAGES C)
set(BOLAN_IO OFF)
set(BOLAN_RENDER OFF)
set(CMAKE_C_FLAGS_RELEASE "-O1 -DPARENT")
add_subdirectory($BOLAN_SOURCE_DIR bolan)
install(FILES CMakeLists.txt DESTINATION share/parent)
END
cmake -S parent -B parent.build -G Ninja -DCMAKE_BUILD_TYPE=Release > parent.log 2>&1 || fail 'as a part of another project'
ninja -C parent.build -t commands bolan/libbolan.a | grep 'src/waves/sea\.c$' | grep -q -- '-O1 -DPARENT' ||
    fail 'the flags of the parent project do not reach Bolan'
cmake --install parent.build --prefix "$PWD/prefix" > install.log 2>&1 || fail 'the installation of the parent project'
[ "$(find prefix -type f)" = prefix/share/parent/CMakeLists.txt ] || fail "installed: $(find prefix -type f)"

# 32-bit x86: the x87 would round otherwise, so SSE2 it is, in so many words.
case $(uname -m) in
x86_64 | i?86)
    if echo 'int main(void) { return 0; }' | ${CC:-cc} -m32 -xc -include stdio.h - -o thirty_two 2> /dev/null; then
        plain thirty_two_bits -DCMAKE_C_FLAGS=-m32
        grep -q '32-bit x86: compiling with -msse2 -mfpmath=sse' thirty_two_bits.log || fail 'no word of SSE2'
        compiles thirty_two_bits WITH -mfpmath=sse
        cmake --build thirty_two_bits -j "${BOLAN_TEST_JOBS:-2}" --target CMakeFiles/bolan.dir/src/ground/detail.c.o \
            > build32.log 2>&1 || fail "$(cat build32.log)"
    fi
    ;;
esac
