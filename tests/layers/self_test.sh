#!/bin/sh
# SPDX-License-Identifier: MIT
# Shows that check.sh can fail: a small clean tree passes, and each breach put into it is found.
set -eu
check=$(cd "$(dirname "$0")" && pwd)/check.sh
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT

clean() {
    rm -rf "$tree/src" "$tree/include" "$tree/apps" "$tree/examples" "$tree/shaders"
    mkdir -p "$tree/include/bolan" "$tree/src/base" "$tree/src/math" "$tree/src/waves" "$tree/src/io" \
        "$tree/src/render/gl" "$tree/src/odd" "$tree/apps/bolan" "$tree/apps/viewer" "$tree/examples" "$tree/shaders/shared"
    printf '#include <stdint.h>\n' >"$tree/include/bolan/base.h"
    printf '#include "bolan/base.h"\n' >"$tree/include/bolan/waves.h"
    printf '#include "bolan/base.h"\n' >"$tree/include/bolan/render.h"
    printf '#include "bolan/waves.h"\n' >"$tree/include/bolan/bolan.h"
    printf '#include "bolan/base.h"\n#include <pthread.h>\n' >"$tree/src/base/a.c"
    printf 'int a;\n' >"$tree/src/waves/field.h"
    printf '#include "field.h"\n#include "bolan/base.h"\n#include "shared/real.glsl"\nint b; // glClear in words\n' >"$tree/src/waves/a.c"
    printf '#include <math.h>\n' >"$tree/shaders/shared/real.glsl"
    printf '#include <gdal/gdal.h>\n' >"$tree/src/io/a.c"
    printf '#include "gl/gl.h"\nint BOLAN_GL_CORE = GL_OURS;\n' >"$tree/src/render/frame.c"
    printf 'enum { GL_OURS };\n' >"$tree/src/render/gl/gl.h"
    printf '#include <epoxy/gl.h>\nGLuint name;\n' >"$tree/src/render/gl/buffer.c"
    printf '#include "bolan/bolan.h"\n#include <stdio.h>\n' >"$tree/apps/bolan/main.c"
    printf '#include <SDL.h>\n#include "bolan/render.h"\n' >"$tree/apps/viewer/window.c"
    printf '#include "bolan/bolan.h"\n' >"$tree/examples/01.c"
}

failures=0
# breaks WHAT FILE LINE: the tree with that line added must be refused, naming the file.
breaks() {
    clean
    printf '%s\n' "$3" >>"$tree/$2"
    if sh "$check" "$tree" >"$tree/log" || ! grep -q "^$2:" "$tree/log"; then
        echo "not found: $1"
        failures=$((failures + 1))
    fi
}

clean
if ! sh "$check" "$tree" >"$tree/log"; then
    echo 'the clean tree is refused:'
    cat "$tree/log"
    failures=1
fi
breaks 'a shared source that is not there' src/waves/a.c '#include "shared/nothing.glsl"'
breaks 'a shared source in a program' apps/bolan/main.c '#include "shared/real.glsl"'
breaks 'a shared source that includes C' shaders/shared/real.glsl '#include "waves/field.h"'
breaks 'an include of a higher tier' src/base/a.c '#include "bolan/waves.h"'
breaks 'a private include of a higher tier' src/math/a.c '#include "waves/field.h"'
breaks 'a relative include of a higher tier' src/math/a.c '#include "../waves/field.h"'
breaks 'render including io' src/render/frame.c '#include "io/a.c"'
breaks 'io including render' src/io/a.c '#include "bolan/render.h"'
breaks 'GL in the umbrella' include/bolan/bolan.h '#include "bolan/render.h"'
breaks 'the umbrella in the library' src/waves/a.c '#include "bolan/bolan.h"'
breaks 'a third-party header in the core' src/waves/a.c '#include <fftw3.h>'
breaks 'a third-party header in a public header' include/bolan/render.h '#include <epoxy/gl.h>'
breaks 'a private header in a public header' include/bolan/waves.h '#include "waves/field.h"'
breaks 'a GL type outside its folder' src/render/frame.c 'static GLuint texture;'
breaks 'a GL call outside its folder' src/render/frame.c 'void f(void) { glClear(0); }'
breaks 'GL in the interface of its folder' src/render/gl/gl.h '#include <epoxy/gl.h>'
breaks 'an EGL name outside its folder' apps/bolan/main.c 'EGLDisplay display;'
breaks 'GL after a comment' src/waves/a.c '/* not */ int x = GL_RGBA;'
breaks 'a private header in an application' apps/bolan/main.c '#include "waves/field.h"'
breaks 'a private header in an example' examples/01.c '#include "../src/waves/field.h"'
breaks 'SDL outside the viewer' apps/bolan/main.c '#include <SDL.h>'
breaks 'an include that leads nowhere' src/waves/a.c '#include "nothing.h"'
breaks 'a public header that does not exist' src/waves/a.c '#include "bolan/nothing.h"'

breaks 'a module without a place' src/odd/a.c 'int x;'
[ "$failures" = 0 ] && echo 'every breach was found'
