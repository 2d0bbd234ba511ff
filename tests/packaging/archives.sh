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
