#!/bin/sh
# SPDX-License-Identifier: MIT
# Configures and builds the release preset: build/bolan.
set -eu
cd "$(dirname "$0")/.."
if ! log=$(cmake --preset release 2>&1); then
    printf '%s\n' "$log" >&2
    exit 1
fi
exec cmake --build --preset release
