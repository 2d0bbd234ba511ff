#!/bin/sh
# SPDX-License-Identifier: MIT
# Compiles the web page and tries it in a headless Chromium. Skipped without emscripten or Chromium, unless
# BOLAN_REQUIRE_WEB is set. BOLAN_PYTHON3 has numpy and cffi.
set -eu
skip() {
    [ -z "${BOLAN_REQUIRE_WEB:-}" ] || { echo "$1"; exit 1; }
    echo "skipped: $1"
    exit 77
}
command -v emcc > /dev/null || skip 'the web page needs emscripten (apt-get install emscripten, or make web)'
"$BOLAN_PYTHON3" -c 'import numpy, cffi, matplotlib' 2> /dev/null ||
    skip 'the test of the web page needs python3-numpy, python3-cffi and python3-matplotlib'
cd "$BOLAN_SOURCE_DIR/tests/web"
"$BOLAN_PYTHON3" -c 'import browser, sys; sys.exit(browser.find() is None)' ||
    skip 'the test of the web page needs Chromium (apt-get install chromium, or make web)'
"$BOLAN_SOURCE_DIR/tools/web.sh"
exec "$BOLAN_PYTHON3" page.py "$BOLAN_SOURCE_DIR/build/web"
