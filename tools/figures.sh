#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes the figures of the four papers again: runs every tools/figures/<technique>.sh PROGRAM FOLDER.
set -eu
cd "$(dirname "$0")/.."
folder=docs/images/techniques
mkdir -p "$folder"
for script in tools/figures/*.sh; do
    echo "$script"
    sh "$script" build/bolan "$folder"
done
echo "The figures are in $folder"
