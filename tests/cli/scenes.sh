# SPDX-License-Identifier: MIT
# Scene files: what is wrong in them is named with file, line and key; exit code 1, no output file.
set -eu
. "$BOLAN_SOURCE_DIR/tests/cli/common"

printf 'sea:\n  wnd: {speed: 3}\n' > key.yaml
refuse 1 'key.yaml:2: unknown key sea.wnd; expected one of wind, ' measure key.yaml
refuse 1 'key.yaml:2: unknown key sea.wnd; expected one of wind, ' render key.yaml -o a.png
printf 'time: 3\nsea:\n  wind:\n    speed: 300\n' > value.yaml
refuse 1 'value.yaml:4: sea.wind.speed is 300; expected a number from 0 to 70 m/s' measure value.yaml
printf 'sea: {wind: {speed: 3\n' > syntax.yaml
refuse 1 'syntax.yaml:1: not YAML' measure syntax.yaml
printf '\000\001\002\377' > binary.yaml
refuse 1 'binary.yaml:1: not YAML' measure binary.yaml
refuse 1 './none.yaml: cannot be read: No such file or directory' measure ./none.yaml
mkdir folder.yaml
refuse 1 'folder.yaml: cannot be read: it is a folder' measure folder.yaml

# Terrain that is not there, or is none.
printf 'terrain: {raster: {file: none.tif}}\n' > raster.yaml
refuse 1 'none.tif: the raster cannot be read: No such file or directory' render raster.yaml -o a.png
refuse 1 'none.tif: the raster cannot be read: No such file or directory' render coast --terrain none.tif -o a.png
printf 'no raster' > text.tif
refuse 1 'text.tif: not a raster that GDAL reads' render coast --terrain text.tif -o a.png
printf 'terrain: {raster: {}}\n' > default.yaml
if [ ! -e /usr/share/ferret-vis/data/etopo5.cdf ]; then
    refuse 1 'the scene needs a raster of elevations; give one with --terrain FILE [--at LAT,LON]' render default.yaml -o a.png
    refuse 1 'coast: the scene needs a raster of elevations' render coast -o a.png
fi

# A raster by a name of GDAL's, on the command line and beside a scene; a warning where a default stands in for data.
rasters=$BOLAN_SOURCE_DIR/tests/data/rasters
printf '0,0\n' > middle.csv
run query open-sea --terrain "NETCDF:$rasters/multi.nc:z" --points middle.csv
run query "$rasters/sub.yaml" --points middle.csv
printf 'terrain: {raster: {file: %s, variable: none}}\n' "$rasters/multi.nc" > variable.yaml
refuse 1 'it has no such variable; expected one of: 1 interpolation_flag, 2 z' query variable.yaml --points middle.csv
printf 'terrain: {raster: {file: none.tif, vertical_scale: 0.0001}}\n' > small.yaml
refuse 1 'small.yaml:1: terrain.raster.vertical_scale is 0.0001; expected a number from 0.001 to 1000, or its negative' measure small.yaml
printf 'terrain: {raster: {file: none.tif, nodata: hole}}\n' > nodata.yaml
refuse 1 'nodata.yaml:1: terrain.raster.nodata is hole; expected fill, sea' measure nodata.yaml

# What is right is taken; an option goes over the scene.
printf 'sea: {wind: {speed: 12, from: 200}, seed: 5}\nwater: {type: II}\n' > good.yaml
run measure good.yaml --json
one=$(value hash)
run measure good.yaml --wind 12 --wind-from 200 --seed 5 --json
[ "$(value hash)" = "$one" ] || fail 'the same options changed the sea'
run measure good.yaml --seed 6 --json
[ "$(value hash)" != "$one" ] || fail '--seed did not change the sea'
for name in island open-sea storm measured reef underwater calm; do
    run measure "$name" --json
    near "$(value jacobian_mean)" 1 3e-3 # mass is conserved; 65536 places of a Jacobian that spreads by 0.2
done
