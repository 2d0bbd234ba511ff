# SPDX-License-Identifier: MIT
# bolan measure: every key of the contract, the energy of measured spectra, bad spectrum files, and the same sea on every
# number of threads and instruction set.
set -eu
. "$BOLAN_SOURCE_DIR/tests/cli/common"

run measure open-sea --json
for key in hs tp tm02 te direction_from spread mss mss_up mss_cross skewness kurtosis mean_level jacobian_min jacobian_mean \
    whitecap_fraction m0_spectrum m0_field cascades record_time hash; do
    grep -q "\"$key\":" out || fail "no $key"
done
for key in n length k_min k_max variance; do
    [ "$(grep -o "\"$key\":" out | wc -l)" -eq 4 ] || fail "not every cascade has $key"
done
if command -v python3 > /dev/null; then python3 -m json.tool out > /dev/null || fail 'not JSON'; fi
hash=$(value hash)
echo "$hash" | grep -Eq '^[0-9a-f]{16}$' || fail "hash $hash"
run measure open-sea
grep -q 'significant wave height' out || fail 'no table without --json'

# Reproducible.
for how in '--threads 1' '--threads 2' '--threads 7' '--cpu scalar' '--cpu generic4'; do
    # shellcheck disable=SC2086 # split on purpose
    run measure open-sea --json $how
    [ "$(value hash)" = "$hash" ] || fail "another sea with $how"
done
run measure open-sea --time 21 --json
[ "$(value hash)" != "$hash" ] || fail 'the sea stands still'

# A buoy: its record, whose 4 standard deviations are the Hm0 that is printed, and its spectrum.
run measure open-sea --buoy 40,-30 --duration 300 --rate 2 -o buoy.csv --json
[ "$(head -1 buoy.csv)" = 'time,heave,east,north,slope_x,slope_y' ] || fail 'another header of a buoy'
[ "$(wc -l < buoy.csv)" -eq 601 ] || fail 'not two samples a second'
[ "$(sed -n 3p buoy.csv | cut -d, -f1)" = 20.5 ] || fail "the record does not begin at the scene's time"
near "$(value hm0)" "$(awk -F, 'NR > 1 { s += $2; q += $2 * $2; n++ } END { print 4 * sqrt(q / n - (s / n) ^ 2) }' buoy.csv)" 1e-4
for key in waves h_third h_tenth h_max tz skewness kurtosis exceedance spectrum; do
    grep -q "\"$key\":" out || fail "no $key of a buoy"
done
if command -v python3 > /dev/null; then python3 -m json.tool out > /dev/null || fail 'the record of a buoy is not JSON'; fi
"$BOLAN" measure island --buoy 0,0 --duration 60 > out 2> err || fail "$(cat err)"
grep -q 'the buoy rides on the open sea' err || fail 'a buoy on an island says nothing'
mv buoy.csv first.csv
run measure open-sea --buoy 40,-30 --duration 300 --rate 2 -o buoy.csv --threads 3
cmp first.csv buoy.csv || fail 'threads change the record of a buoy'
grep -q 'H1/10' out || fail 'no table of a buoy without --json'
refuse 2 '--rate needs --buoy X,Y' measure --rate 3
refuse 2 '--output needs --buoy X,Y' measure -o x.csv
refuse 2 '--buoy is 1; expected X,Y' measure --buoy 1
refuse 2 'a record of 2 s at 2 a second has too few samples; expected 64' measure --buoy 1,2 --duration 2
refuse 1 'no/x.csv: cannot be written' measure open-sea --buoy 1,2 --duration 60 -o no/x.csv

# Options that a sea has no use for are refused, not ignored; every bit of a seed counts.
refuse 2 '--terrain does not go with bolan measure' measure --terrain missing.tif
refuse 2 '--at does not go with bolan measure' measure --at 1,2
refuse 2 '--surface does not go with bolan measure' measure --surface quad
refuse 2 '--optics does not go with bolan measure' measure --optics lit
refuse 2 '--surface does not go with bolan query' query --surface quad
refuse 2 '--seed is 18446744073709551616; expected a whole number from 0 to 18446744073709551615' \
    measure --seed 18446744073709551616
run measure open-sea --seed 9007199254740992 --json
even=$(value hash)
run measure open-sea --seed 9007199254740993 --json
[ "$(value hash)" != "$even" ] || fail 'two seeds beyond 2^53 make one sea'
printf 'sea: {seed: 9007199254740993}\n' > odd.yaml
run measure odd.yaml --seed 9007199254740993 --json
odd=$(value hash)
run measure odd.yaml --json
[ "$(value hash)" = "$odd" ] || fail 'the seed of a scene lost a bit'
run measure odd.yaml --seed 18446744073709551615 --json

# Too high for its depth: one warning, and 0.6 of the depth.
"$BOLAN" measure open-sea --depth 0.5 --json > out 2> err || fail 'a sea too high for its depth fails'
[ "$(wc -l < err)" -eq 1 ] || fail "more than one warning: $(cat err)"
grep -q 'warning: the sea is too high for its depth of 0.5 m' err || fail 'no warning'
near "$(value m0_spectrum)" 0.005625 1e-6
near "$(value mean_level)" 0 0.0006

# Wind, tables and shapes do what their names say. Fully developed Hs by Pierson & Moskowitz is 0.21 U^2/g: 20 m/s: 8.6 m.
run measure open-sea --beaufort 0 --json
near "$(value hs)" 0 1e-6
run measure island --wind 20 --spectrum pm --seed 3 --json
near "$(value m0_spectrum)" 5.2 1.0 # swell of the scene included
run measure open-sea --sea-state 5 --json
awk -v m0="$(value m0_spectrum)" 'BEGIN { hs = 4 * sqrt(m0); exit !(hs > 2.5 && hs < 4.0) }' || fail 'Douglas 5 is 2.5 to 4 m'
run measure open-sea --wind 12 --depth 8 --spectrum tma --json
shallow=$(value m0_spectrum)
run measure open-sea --wind 12 --spectrum jonswap --json
awk -v a="$shallow" -v b="$(value m0_spectrum)" 'BEGIN { exit !(a < b) }' || fail 'TMA is no lower than JONSWAP'

# The shipped spectrum: two systems of 1.6 m and 1.3 m, so 4 sqrt(m0) = 2.06 m; integers in the file: 1 %.
run measure measured --json
near "$(awk -v m0="$(value m0_spectrum)" 'BEGIN { print 4 * sqrt(m0) }')" 2.0616 0.02

# Bad files.
spectrum=$BOLAN_SOURCE_DIR/scenes/spectra/synthetic-bimodal.spec
run measure --spectrum "$spectrum" --json
refuse 1 'none.spec: cannot be read: No such file or directory' measure --spectrum none.spec
: > empty.spec
refuse 1 'empty.spec' measure --spectrum empty.spec
head -c 4000 "$spectrum" > truncated.spec
refuse 1 'truncated.spec' measure --spectrum truncated.spec
head -c 3000 /dev/urandom > binary.spec
refuse 1 'binary.spec' measure --spectrum binary.spec
awk '/^FACTOR/ { factor = NR } factor && NR == factor + 4 { sub(/ [0-9]+$/, "   -7") } { print }' "$spectrum" > negative.spec
refuse 1 'negative.spec:' measure --spectrum negative.spec
refuse 1 'synthetic-bimodal.spec' measure --spectrum "$spectrum" --record 9
refuse 1 'cannot be read: it is a folder' measure --spectrum .

# Measured seas: 4 sqrt(m0) of the files by their publishers' integration, and the mean height of ten realisations. One
# realisation of a few hundred waves scatters by some per cent, ten by a third of that: 5 %.
data=$BOLAN_SOURCE_DIR/tests/data/spectra
swan=$data/swan_maari_lonlat_24f36d.spec
height() { awk -v m0="$(value m0_spectrum)" 'BEGIN { print 4 * sqrt(m0) }'; }
check_file() { # HS FILE OPTIONS...
    published=$1
    file=$2
    shift 2
    sum=0
    for seed in 1 2 3 4 5 6 7 8 9 10; do
        run measure --spectrum "$data/$file" --seed "$seed" --json "$@"
        near "$(height)" "$published" "$(awk -v h="$published" 'BEGIN { print h * 0.005 }')"
        near "$(value jacobian_mean)" 1 3e-3 # 65536 places of a Jacobian that spreads by 0.2
        sum=$(awk -v s="$sum" -v h="$(value hs)" 'BEGIN { print s + h }')
    done
    mean=$(awk -v s="$sum" 'BEGIN { print s / 10 }')
    echo "$file: mean hs of ten seas $mean m, published $published m"
    near "$mean" "$published" "$(awk -v h="$published" 'BEGIN { print h * 0.05 }')"
}
check_file 1.7158 swan_maari_lonlat_24f36d.spec
check_file 1.2881 ndbc_44004w2000.txt --from 90 --spread 20
near "$(value direction_from)" 90 4 # one realisation
run measure --spectrum "$swan" --record 4 --json
near "$(height)" 4.2587 0.021
near "$(value tm02)" 7.3809 0.0001
near "$(value tp)" 13.5685 0.0001
near "$(value te)" 10.1755 0.0001
near "$(value spread)" 23.27 0.01
grep -q '"record_time": "2016-10-15T00:00:00"' out || fail 'no time of the record'
hash=$(value hash)
run measure --spectrum "$swan" --record 4 --record-time
[ "$(cat out)" = 2016-10-15T00:00:00 ] || fail "--record-time prints $(cat out)"

# Records by date, locations, and what stands in.
run measure --spectrum "$swan" --record 2016-10-15T00:00 --json
[ "$(value hash)" = "$hash" ] || fail 'record 4 by its date is another sea'
refuse 1 'the record of 2015-01-01 was asked for' measure --spectrum "$swan" --record 2015-01-01
refuse 2 '--record is 2016-13-01; expected a whole number' measure --spectrum "$swan" --record 2016-13-01
refuse 1 '2 of the 3 have energy: 2, 3' measure --spectrum "$data/firstdry.spec"
run measure --spectrum "$data/firstdry.spec" --location 2 --json
near "$(height)" 1.9890 0.0001
"$BOLAN" measure --spectrum "$data/firstdry.spec" --location 3.1,3 --json > out 2> err || fail "$(cat err)"
grep -q 'firstdry.spec: the location nearest to 3.1, 3 is number 3 at 3, 3, 11 km away' err || fail "said: $(cat err)"
near "$(height)" 3.9955 0.0001
refuse 1 'location 4 was asked for; expected 1 to 3' measure --spectrum "$data/firstdry.spec" --location 4
refuse 2 '--location is 0; expected a whole number from 1' measure --spectrum "$data/firstdry.spec" --location 0
run measure --spectrum "$data/41004w2018.txt" --json
near "$(value direction_from)" 180 3 # one realisation of a sea from 180
for letter in d i j k; do
    refuse 1 "this is NDBC's table of" measure --spectrum "$data/41004${letter}2018.txt"
done
run measure --spectrum "$data/zero.spec" --json
near "$(value hs)" 0 0
warned() { # WORDS ARGUMENTS...: succeeds, with one line on stderr that holds the words
    words=$1
    shift
    "$BOLAN" "$@" > out 2> err || fail "bolan $*: $(cat err)"
    [ "$(wc -l < err)" -eq 1 ] || fail "bolan $*: not one line on stderr: $(cat err)"
    grep -q "warning: .*$words" err || fail "bolan $*: said '$(cat err)', expected '$words'"
}
warned 'the waves come from 270 degrees' measure --spectrum "$data/ndbc_44004w2000.txt" --json
warned 'there is no row of 2026-06-08T03:40Z' measure --spectrum "$data/rtmiss.data_spec" --json
near "$(value direction_from)" 180 3
cat > buoy.yaml << END
sea:
  spectrum: {file: "$data/ndbc_44004w2000.txt", from: 200, spread: 30, record: 2000-01-01T00:00}
END
run measure buoy.yaml --json
near "$(height)" 1.2881 0.0065
near "$(value direction_from)" 200 4
near "$(value spread)" 14.6 3 # sqrt(2 / 31) rad, and the tail
run measure buoy.yaml --from 20 --spread 3 --json
near "$(value direction_from)" 20 6
near "$(value spread)" 40.5 5 # sqrt(2 / 4) rad
# Another file than the scene's: nothing of the scene's options stays.
warned 'the waves come from 270 degrees' measure buoy.yaml --spectrum "$data/ndbc_44004w2000.txt"

# The wind sea and the swell of the scene.
run measure open-sea --json
grep -q '"systems": \[{"kind": "wind sea", "hs": 1\.[0-9]*, "tp": 7\.' out || fail 'no wind sea'
run measure open-sea
grep -Eq '^  swell +[0-9.]+ +1[23]\.[0-9]' out || fail 'no swell in the table'
