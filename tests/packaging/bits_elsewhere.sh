# SPDX-License-Identifier: MIT
# The bits of the set generic4 as NEON and as WebAssembly SIMD are those of tests/determinism/golden_hashes.h. Skipped
# where there is neither a cross compiler for aarch64 with qemu-user, nor emscripten with node.
set -eu
. "$BOLAN_SOURCE_DIR/tests/packaging/common"
"$BOLAN_SOURCE_DIR/tools/check_bits.sh" --once 'aarch64-linux-gnu-gcc -O2' 'emcc -O1' > bits.log || fail "$(cat bits.log)"
cat bits.log
grep -q '^passed' bits.log || exit 77
