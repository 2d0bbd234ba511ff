# SPDX-License-Identifier: MIT
# The bits of an unoptimised build, and of the other compiler at its highest level where it is installed, are those of
# tests/determinism/golden_hashes.h. tools/check_bits.sh without arguments has more builds.
set -eu
. "$BOLAN_SOURCE_DIR/tests/packaging/common"
exec "$BOLAN_SOURCE_DIR/tools/check_bits.sh" --once "${CC:-cc} -O0" 'clang -O3'
