#!/bin/sh
# SPDX-License-Identifier: MIT
# Without a display `bolan view` says so in one sentence and exits 1; nothing is drawn into nowhere, no file is left.
set -eu
expect_refusal() {
    status=0
    "$@" "$BOLAN" view open-sea --frames 2 --screenshot never.png >out.txt 2>err.txt || status=$?
    cat err.txt
    test "$status" -eq 1
    test "$(wc -l <err.txt)" -eq 1
    grep -q 'no display' err.txt
    test ! -s out.txt
    test ! -e never.png
}
expect_refusal env -u DISPLAY -u WAYLAND_DISPLAY -u XDG_RUNTIME_DIR
expect_refusal env -u DISPLAY -u WAYLAND_DISPLAY SDL_VIDEODRIVER=offscreen
expect_refusal env -u DISPLAY -u WAYLAND_DISPLAY SDL_VIDEODRIVER=dummy
expect_refusal env -u WAYLAND_DISPLAY -u XDG_RUNTIME_DIR DISPLAY=:4711
