# SPDX-License-Identifier: MIT
# bolan info FILE and bolan export spectrum: what a file of spectra holds, the choice of a record, and spectra as files.
set -eu
. "$BOLAN_SOURCE_DIR/tests/cli/common"
data=$BOLAN_SOURCE_DIR/tests/data/spectra

run info "$data/ww3_netcdf.nc"
for words in ': WAVEWATCH III point spectra (NetCDF)' 'records      9, 2014-12-01T00:00Z to 2014-12-05T00:00Z, every 12 h' \
    'locations    1 at 92.1, 19.95 (longitude, latitude)' '2 at 92, 19.8' \
    '2014-12-01T00:00Z at 92.1, 19.95: Hs 0.7413 m, Tp 13.71 s, from 209.3 degrees, spread 39.2 degrees' \
    'frequencies  25, 0.04118 to 0.4056 Hz' \
    'directions   24, every 15 degrees' 'Hs 0.6444 to 0.824 m' 'Tp 11.33 to 15.08 s' 'swell'; do
    grep -qF "$words" out || fail "info does not say: $words"
done
run info "$data/ww3_netcdf.nc" --json
[ "$(value format)" = ww3-netcdf ] || fail 'another format'
[ "$(value record_time)" = 2014-12-01T00:00Z ] || fail 'another record'
if command -v python3 > /dev/null; then python3 -m json.tool out > /dev/null || fail 'not JSON'; fi
run info "$data/ww3_netcdf.nc" --json --record 2
[ "$(value record_time)" = 2014-12-02T00:00Z ] || fail 'another record'
run info "$data/era5_spectra.nc" # has land among its places
grep -q 'unreadable   23 of the 50' out || fail 'land is not counted'

run info "$data/datawell_20240909T0115Z.spt"
grep -q 'directions   their moments, by band' out || fail 'moments are not said'
run info "$data/triaxys_20180131.NONDIRSPEC" --from 10 --spread 5
grep -q 'directions   none' out || fail 'no directions are not said'

# A latitude in the place of the longitude is no place on earth.
refuse 1 'expected longitude, latitude in degrees' info "$data/ww3_netcdf.nc" --location 19.95,92.1

# The choice of a location says the distance; interpolation says between what.
"$BOLAN" info "$data/ww3_netcdf.nc" --location 92,19.9 > out 2> err || fail "$(cat err)"
grep -q 'nearest to 92, 19.9 is number 1 at 92.1, 19.95, 12 km away' err && fail 'the farther location'
grep -Eq 'nearest to 92, 19.9 is number 2 at 92, 19.8, 11 km away' err || fail "said: $(cat err)"
"$BOLAN" info "$data/ww3_netcdf.nc" --record 2014-12-01T06:00 --interpolate --json > out 2> err || fail "$(cat err)"
[ "$(value record_time)" = 2014-12-01T06:00Z ] || fail 'not interpolated'
grep -q 'between the records of 2014-12-01T00:00Z and 2014-12-01T12:00Z' err || fail "said: $(cat err)"
refuse 1 'expected a time within an hour of one of its 9 records' info "$data/ww3_netcdf.nc" --record 2014-12-01T06:00
refuse 2 '--record is x' info "$data/ww3_netcdf.nc" --record x
refuse 2 'bolan info has no file of spectra to choose from' info --record 2
refuse 2 '--interpolate chooses from a spectrum file' measure open-sea --interpolate

# What is written is read.
run export spectrum open-sea -o sea.spec
run measure open-sea --json
whole=$(value m0_spectrum)
run measure open-sea --spectrum sea.spec --json
near "$(value m0_spectrum)" "$whole" 0.005
run export spectrum --spectrum "$data/swan_maari_lonlat_24f36d.spec" -o place.spec
run info place.spec
grep -qF 'locations    1 at 174.673, -38.1736 (longitude, latitude)' out || fail 'the place is lost'
run export spectrum open-sea -o sea.csv
[ "$(wc -l < sea.csv)" -eq 6913 ] || fail 'not 96 x 72 rows'
run export spectrum --spectrum "$data/octopus_maari_20180311.oct" --record 3 -o sea.png
[ "$(head -c 4 sea.png | tail -c 3)" = PNG ] || fail 'not a PNG'
refuse 2 'bolan export cake: expected mesh, fields, sky or spectrum' export cake -o a.csv
refuse 2 'bolan export needs to know what: mesh, fields, sky or spectrum' export -o a.csv
refuse 2 'bolan export spectrum needs -o FILE' export spectrum
refuse 2 'expected .png, .csv or .spec' export spectrum -o a.txt
