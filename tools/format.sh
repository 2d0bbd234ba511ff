#!/bin/sh
# SPDX-License-Identifier: MIT
# Formats every C, C++ and header file that git knows, after .clang-format.
set -eu
cd "$(dirname "$0")/.."
if ! command -v clang-format >/dev/null; then
    echo 'clang-format is missing: install the package clang-format' >&2
    exit 1
fi
git ls-files -z '*.c' '*.h' '*.cpp' | xargs -0 clang-format -i
