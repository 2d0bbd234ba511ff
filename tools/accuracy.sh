#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes the plots of docs/accuracy.md again, and their numbers as build/accuracy.csv: some minutes.
set -eu
cd "$(dirname "$0")/.."
cmake --build build --target bolan_accuracy
mkdir -p docs/images
build/bolan_accuracy docs/images tests/data/spectra/swan_maari_lonlat_24f36d.spec > build/accuracy.csv
echo 'The plots are docs/images/accuracy-*.png'
