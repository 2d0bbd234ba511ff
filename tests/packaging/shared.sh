# SPDX-License-Identifier: MIT
# Shared libraries, installed to a prefix that the loader does not know: they are versioned, the program starts, and C programs
# build and run through pkg-config and find_package. The program is built without the viewer where there is no C++.
set -eu
. "$BOLAN_SOURCE_DIR/tests/packaging/common"
write_programs

export CXX=/there/is/no/compiler
# Options as tools/deb.sh has them: packaging/deb makes its packages of this build.
configure shared -DBUILD_SHARED_LIBS=ON -DBOLAN_WERROR=OFF -DBOLAN_BENCH=OFF -DBOLAN_EXAMPLES=OFF
grep -q 'The program is built without the viewer: it needs a C++ compiler' shared.log || fail 'no word of the viewer'
build_and_install shared "$PWD/first"
mv first prefix

minor=$(version)
minor=${minor%.*}
for library in bolan bolan_content bolan_io bolan_render; do
    file=$(find prefix -name "lib$library.so")
    [ -n "$file" ] || fail "lib$library.so is not installed"
    readelf -d "$file" | grep -q "SONAME.*\[lib$library\.so\.$minor\]" || fail "the SONAME of $library is not $minor"
    [ -e "$file.$minor" ] && [ -e "$file.$(version)" ] || fail "$file has no file of its version beside it"
    readelf -d "$file" | grep -q 'RUNPATH.*\[\$ORIGIN\]' || fail "the RUNPATH of $library is not its own folder"
done
said=$(env -u LD_LIBRARY_PATH prefix/bin/bolan --version) || fail 'the installed program does not start'
[ "$said" = "bolan $(version)" ] || fail "the installed program said '$said'"
status=0
prefix/bin/bolan view > view.log 2>&1 || status=$?
[ $status = 2 ] && grep -q 'unknown command view' view.log || fail "bolan view without a viewer: $status, $(cat view.log)"
no_paths prefix "$BOLAN_SOURCE_DIR" "$PWD/shared"

# the GLSL for the host's programs, where pkg-config and the CMake package say
shaders=$(PKG_CONFIG_PATH=$(dirname "$(find "$PWD/prefix" -name bolan_render.pc)") pkg-config --variable=shaderdir bolan_render)
grep -q 'bolan_fields bolan_fields_at(' "$shaders/bolan_fields.glsl" || fail "no bolan_fields.glsl in '$shaders'"
grep -q 'bolan_SHADER_DIR.*share/bolan/shaders' "$(find prefix -name bolanConfig.cmake)" || fail 'no bolan_SHADER_DIR'

use_pkg_config "$PWD/prefix" bolan bolan_content bolan_io bolan_render
use_find_package "$PWD/prefix" bolan bolan_content bolan_io bolan_render

# The components of the installation are the whole of it, each file in one of them.
(cd prefix && find . ! -type d | sort) > whole
for component in program libraries development; do
    cmake --install shared --prefix "$PWD/$component" --component $component > component.log || fail "$(cat component.log)"
    (cd $component && find . ! -type d)
done | sort > parts
cmp whole parts || fail "the components are not the whole: $(diff whole parts)"
! find libraries ! -type d ! -name 'lib*.so.*' | grep . || fail 'libraries holds more than libraries'
for file in man/man1/bolan.1 bash-completion/completions/bolan zsh/site-functions/_bolan \
    fish/vendor_completions.d/bolan.fish; do
    [ -s program/share/$file ] || fail "program lacks $file"
done

# A shared library exports the names that the public headers declare, and no other.
cat "$BOLAN_SOURCE_DIR"/include/bolan/*.h | grep -ow 'bolan_[a-z0-9_]*' | sort -u > public
# libbolan_all, for Python, holds nothing here: it needs the others.
all=$(find prefix -name 'libbolan_all.so')
for library in bolan bolan_content bolan_io bolan_render; do
    readelf -d "$all" | grep -q "NEEDED.*\[lib$library\.so\.$minor\]" || fail "libbolan_all does not need lib$library"
done
for library in $(find prefix -name 'libbolan*.so' ! -name 'libbolan_all.so'); do
    nm -D --defined-only "$library" | awk '{ print $3 }' | grep -v '^_\(_bss_start\|edata\|end\|init\|fini\)$' | sort -u > exported
    [ -s exported ] || fail "$library exports nothing"
    strange=$(comm -23 exported public | tr '\n' ' ')
    [ -z "$strange" ] || fail "$library exports what no header declares: $strange"
done
