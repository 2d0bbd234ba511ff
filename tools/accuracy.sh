#!/bin/sh
# SPDX-License-Identifier: MIT
# Makes the plots of docs/accuracy.md again, with their numbers as build/accuracy.csv: some minutes. Then the table of
# buoys there, from the long run of a test: half an hour. With `plots` as its argument it leaves the table as it is.
set -eu
cd "$(dirname "$0")/.."
cmake --build build --target bolan_accuracy test_sea_buoys
mkdir -p docs/images
build/bolan_accuracy docs/images tests/data/spectra/swan_maari_lonlat_24f36d.spec > build/accuracy.csv
echo 'The plots are docs/images/accuracy-*.png'
[ "${1-}" = plots ] && exit 0

echo 'Listening to buoys for about half an hour: build/buoys.txt'
BOLAN_LONG=1 build/tests/test_sea_buoys > build/buoys.txt || {
    echo 'accuracy.sh: a bound of tests/physics/test_sea_buoys.c does not hold; the table is as it was' >&2
    exit 1
}
awk '
    # wind 10 m/s, N 256: waves off the request by -0.010 at 0.314 Hz, variance 0.9992
    # wind 10 m/s, N 256: buoys off the waves by +0.012 +- 0.004 at 0.157 Hz; off the request ...; variance 1.003 +- 0.001
    FNR == NR && /, N .* off the / {
        sea = $0; sub(/, N .*/, "", sea)
        side = $0; sub(/.*, N /, "", side); side += 0
        off = $0; sub(/.*: (waves|buoys) off the (request|waves) by /, "", off); split(off, part, " ")
    }
    FNR == NR && /: waves off the request by / { waves[sea, side] = part[1]; next }
    FNR == NR && /: buoys off the waves by / {
        cell[sea, side] = sprintf("%+.1f %%; %+.1f ± %.1f %%; %.3f", 100 * waves[sea, side], 100 * part[1],
                                  100 * part[3], $(NF - 2))
        if (!(sea in known)) { known[sea] = 1; seas[++rows] = sea }
        next
    }
    FNR == NR { next }
    /^<!-- end of buoys/ {
        print "| sea | 64 samples a side | 128 | 256 | 512 | 1024 |"
        print "|---|---|---|---|---|---|"
        for (i = 1; i <= rows; i++) {
            line = "| " seas[i]
            for (side = 64; side <= 1024; side *= 2) line = line " | " ((seas[i], side) in cell ? cell[seas[i], side] : "-")
            print line " |"
        }
        print ""
        inside = 0
    }
    !inside { print }
    /^<!-- buoys/ { inside = 1; print "" }
' build/buoys.txt docs/accuracy.md > build/accuracy.md
mv build/accuracy.md docs/accuracy.md
echo 'The table stands in docs/accuracy.md'
