# SPDX-License-Identifier: MIT
# The archives of the build under test, installed: C programs build and run through pkg-config and find_package, and no archive
# holds a path of the build.
set -eu
. "$BOLAN_SOURCE_DIR/tests/packaging/common"
if grep -q '^BOLAN_SANITIZE:STRING=.\|^BUILD_SHARED_LIBS:BOOL=ON\|^CMAKE_BUILD_TYPE:STRING=Debug' "$BOLAN_BUILD_DIR/CMakeCache.txt"; then
    echo 'skipped: the build is shared, for debugging, or has a sanitizer'
    exit 77
fi
write_programs
cmake --install "$BOLAN_BUILD_DIR" --prefix "$PWD/first" > install.log || fail 'the installation'
mv first prefix
libraries=$(find prefix -name 'libbolan*.a' | sed 's|.*/lib||; s|\.a$||' | sort | tr '\n' ' ')
case $libraries in bolan*) ;; *) fail "installed: $libraries" ;; esac
no_paths prefix "$BOLAN_SOURCE_DIR" "$BOLAN_BUILD_DIR"

# shellcheck disable=SC2086 # words
use_pkg_config "$PWD/prefix" $libraries
# shellcheck disable=SC2086
use_find_package "$PWD/prefix" $libraries

# A host has functions of its own: no archive defines a name without the prefix, so none collides, whatever is linked.
for archive in $(find prefix -name 'libbolan*.a'); do
    strange=$(nm --defined-only "$archive" 2> /dev/null | awk 'NF == 3 && $2 ~ /[A-TV-Z]/ && $3 !~ /^bolan_/ { print $3 }')
    [ -z "$strange" ] || fail "$archive defines $strange"
done
cat > host.c << 'END'
#include <stdio.h>
int gl_save(void);
int file_read(void);
int gl_finish(void);
int schema_read(void);
const char *bolan_version(void);
int gl_save(void) { return 1; }
int file_read(void) { return 2; }
int gl_finish(void) { return 3; }
int schema_read(void) { return 4; }
int main(void) { return printf("%s %d\n", bolan_version(), gl_save() + file_read() + gl_finish() + schema_read()) < 0; }
END
pc=$(dirname "$(find prefix -name bolan.pc)")
# shellcheck disable=SC2046,SC2086 # words
${CC:-cc} host.c -o host -Wl,--whole-archive $(find prefix -name 'libbolan*.a') -Wl,--no-whole-archive \
    $(PKG_CONFIG_PATH="$pc" pkg-config --libs $libraries) || fail 'a host with functions of its own does not link'
[ "$(./host)" = "$(version) 10" ] || fail "the host said $(./host)"
