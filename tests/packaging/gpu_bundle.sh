# SPDX-License-Identifier: MIT
# The bundle for another machine: packed, it runs in a folder of its own with an empty environment, and its report holds
# what was measured. In the short mode: one test, one benchmark, one image.
set -eu
. "$BOLAN_SOURCE_DIR/tests/packaging/common"
[ -x "$BOLAN_BUILD_DIR/bolan" ] && [ -x "$BOLAN_BUILD_DIR/bolan_bench" ] && [ -x "$BOLAN_BUILD_DIR/tests/test_gl_layer" ] || {
    echo 'skipped: the program, the benchmarks or the tests that draw are not built'
    exit 77
}
if grep -q '^BOLAN_SANITIZE:STRING=.\|^BUILD_SHARED_LIBS:BOOL=ON' "$BOLAN_BUILD_DIR/CMakeCache.txt"; then
    echo 'skipped: the build is shared or has a sanitizer'
    exit 77
fi
sh "$BOLAN_SOURCE_DIR/tools/gpu_bundle.sh" --quick "$BOLAN_BUILD_DIR" "$PWD/bundle"
find bundle/lib -name 'lib[cm].so*' -o -name 'libGL*' -o -name 'libEGL*' | grep . && fail 'the C library or OpenGL is packed'
env -i PATH=/usr/bin:/bin "$PWD/bundle/run.sh" --quick "$PWD/report" > run.log 2>&1 || fail "$(cat run.log)"
for word in '"date"' '"info"' '"renderer"' '"frame_160x96"' '"yardstick_ms"' '"test_gl_layer", "result": "passed"' \
    '"pictures": \["pictures/open-sea.png"\]' '"failures": 0'; do
    grep -q -- "$word" report/report.json || fail "report.json has no $word"
done
if command -v python3 > /dev/null; then python3 -m json.tool report/report.json > /dev/null || fail 'report.json is no JSON'; fi
grep -q 'src=pictures/open-sea.png' report/report.html || fail 'report.html shows no image'
[ -s report/pictures/open-sea.png ] || fail 'there is no image'
