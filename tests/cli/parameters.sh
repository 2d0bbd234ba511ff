# SPDX-License-Identifier: MIT
# What is made of the tables of parameters is up to date: the tables of the documentation and the schema for editors. Every
# built-in scene keeps to the schema.
set -eu
. "$BOLAN_SOURCE_DIR/tests/cli/common"

sh "$BOLAN_SOURCE_DIR/tools/parameters.sh" "$BOLAN" "$PWD/made"
for file in docs/scenes.md docs/command-line.md scenes/scene.schema.json; do
    cmp "made/$file" "$BOLAN_SOURCE_DIR/$file" || fail "$file is out of date: run tools/parameters.sh"
done
[ "$(grep -c '^<!-- parameters: ' "$BOLAN_SOURCE_DIR/docs/scenes.md")" -eq 9 ] || fail 'docs/scenes.md lacks a table'
grep -q '^| `sharpness` | 0.01..2 | 0.5 |' made/docs/scenes.md || fail 'the table of the sea lacks a row'
grep -q '^| `--wind MPS` | 0..70 m/s |' made/docs/command-line.md || fail 'the table of the options lacks a row'

# Every option of a scene stands in a table with its range, and is refused outside.
"$BOLAN" measure --help > help
while read -r option low high; do
    grep -q -- "--$option .*($low\.\.$high" help || fail "--$option: no range $low..$high in the help"
    refuse 2 "--$option is 1e30; expected a" measure --spectrum a.spec "--$option" 1e30
    refuse 2 "--$option is -1e30; expected a" measure --spectrum a.spec "--$option" -1e30
done << 'END'
wind 0 70
wind-from -360 360
fetch 0.1 10000
beaufort 0 12
sea-state 0 9
from -360 360
spread 0 200
depth 0.1 10000
time -1e9 1e9
END
printf '0,0\n' > point.csv
printf 'sea: {resolution: 32, cascades: 1}\n' > small.yaml
for arguments in '--wind 0' '--wind 70' '--wind-from -360' '--fetch 0.1' '--fetch 10000' '--beaufort 12' '--sea-state 9' \
    '--depth 0.1' '--depth 10000' '--time -1e9' '--time 1e9' '--seed 18446744073709551615' '--waves COSINES' '--paper'; do
    # shellcheck disable=SC2086 # split on purpose
    "$BOLAN" query ./small.yaml --points point.csv $arguments > out 2> err || fail "bolan query $arguments: $(cat err)"
done

python3 -c 'import yaml' 2> /dev/null || { echo 'no Python with yaml: the scenes are not held against the schema'; exit 0; }
python3 "$BOLAN_SOURCE_DIR/tests/cli/check_schema.py" "$BOLAN_SOURCE_DIR/scenes/scene.schema.json" \
    "$BOLAN_SOURCE_DIR"/scenes/*.yaml || fail 'a built-in scene does not keep to the schema'
for bad in 'sea: {wnd: 3}' 'sea: {sharpness: 2.1}' 'sea: {resolution: 300}' 'look: {show: all}' 'camera: {position: [1, 2]}' \
    'objects: [{scale: 2}]' 'sea: {swell: [{hs: 1}]}' 'sky: {sun: {elevation: 91}}' 'look: {effects: [foam, smoke]}'; do
    printf '%s\n' "$bad" > bad.yaml
    ! python3 "$BOLAN_SOURCE_DIR/tests/cli/check_schema.py" "$BOLAN_SOURCE_DIR/scenes/scene.schema.json" bad.yaml > out 2>&1 ||
        fail "the schema takes $bad"
done
