# SPDX-License-Identifier: MIT
# bolan bake writes a folder whole or not at all, and a scene can use it.
set -eu
. "$BOLAN_SOURCE_DIR/tests/cli/common"

run bake pond -o tiles --frames 3
[ -f tiles/index.json ] || fail 'no index.json'
for part in height normal detail caustics; do
    [ "$(find tiles -name "$part*" | wc -l)" -ge 3 ] || fail "fewer than 3 files of $part"
done
rm -f out err

# DIR must not be there yet: nothing is replaced.
refuse 1 'tiles' bake pond -o tiles --frames 3
refuse 2 'bake needs -o' bake pond
refuse 1 'no/such/folder' bake pond -o no/such/folder/tiles --frames 2
[ ! -e no ] || fail 'a folder was made on the way'

need_gl
printf 'tiles: tiles\ntechnique: two-triangle\nsea: {wind: {speed: 3, from: 200}, fetch_km: 0.2}\n' > baked.yaml
run render baked.yaml -o baked.png --size 64x48 --samples 1 --quality low
[ -s baked.png ] || fail 'no picture from baked tiles'
rm -f out err tiles/index.json
refuse 1 'index.json' render baked.yaml -o no.png --size 64x48
[ ! -e no.png ] || fail 'a picture without its tiles'
