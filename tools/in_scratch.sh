#!/bin/sh
# SPDX-License-Identifier: MIT
# in_scratch.sh FOLDER COMMAND...: runs a command in a folder made empty for it.
set -eu
folder=$1
shift
rm -rf "$folder"
mkdir -p "$folder"
cd "$folder"
exec "$@"
