# SPDX-License-Identifier: MIT
# Hostile words and files: no control character of an input reaches the terminal, and nothing takes long.
set -eu
. "$BOLAN_SOURCE_DIR/tests/cli/common"

escape=$(printf '\033[31mred')
c1=$(printf '\302\23331m') # CSI as one character of C1, in UTF-8
line=$(printf 'two\nlines')
for word in "$escape" "$c1" "$line"; do
    for arguments in measure 'measure --wind' 'measure --spectrum' 'measure --technique' 'measure --points' 'query --points' \
        'render -o' 'query --points /dev/null -o' 'bake --frames 2 -o' 'render -o a.png --effects' 'measure --terrain none --at'; do
        status=0
        # shellcheck disable=SC2086 # split on purpose
        "$BOLAN" $arguments "$word/no.yaml" > out 2> err < /dev/null || status=$?
        [ "$status" -eq 1 ] || [ "$status" -eq 2 ] || fail "bolan $arguments: exit code $status"
        [ "$(wc -l < err)" -eq 1 ] || fail "bolan $arguments: not one line: $(cat err)"
        ! LC_ALL=C grep -q "$(printf '[\001-\011\013-\037\177]')" err out || fail "bolan $arguments: a control character"
        ! grep -q "$(printf '\302\233')" err out || fail "bolan $arguments: a control character of C1"
    done
    mkdir "$word"
    printf 'sea: {wind: {speed: 3}}\n' > "$word/$word.yaml"
    run measure "$word/$word.yaml"
    ! LC_ALL=C grep -q "$(printf '[\033\302]')" out || fail 'measure prints the name of a scene as it is'
    [ "$(grep -c seed out)" -eq 1 ] && head -1 out | grep -q seed || fail 'the name of a scene broke a line'
    rm -r "$word"
done
rm -f out err

# A word is cut between characters: 40 bytes are not 13 seas and a third.
printf 'time: %s\n' "$(printf '海%.0s' 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16)" > uni.yaml
refuse 1 'uni.yaml:1: time is 海海海海海海海海海海海海海...; expected' measure ./uni.yaml
refuse 2 '--wind is 海海海海海海海海海海海海海海海海海海海海...; expected' measure --wind "$(printf '海%.0s' 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 19 20 21 22)"
printf 'time: 1\n# \377\n' > bytes.yaml
refuse 1 'bytes.yaml:2: not YAML' measure ./bytes.yaml

# Scenes that would take minutes.
hostile=$BOLAN_SOURCE_DIR/tests/data/hostile
repeat() { awk -v text="$1" -v n="$2" 'BEGIN { for (i = 0; i < n; i++) printf "%s", text }'; }
quick() {
    began=$(date +%s)
    refuse "$@"
    [ $(($(date +%s) - began)) -le 3 ] || fail "took long: $*"
}
quick 1 'scene_nested_20kB.yaml:1: more than 4096 brackets' measure "$hostile/scene_nested_20kB.yaml"
repeat '[' 4096 > at.yaml
quick 1 'at.yaml:1: not YAML' measure ./at.yaml
repeat '{a: ' 60000 > maps.yaml
quick 1 'maps.yaml:1: more than 4096 brackets' measure ./maps.yaml
repeat '# "[
[' 5000 > quotes.yaml
quick 1 'quotes.yaml:2049: more than 4096 brackets' measure ./quotes.yaml
awk 'BEGIN { for (i = 0; i < 9000; i++) printf "- &a%d x\n- *a%d\n", i, i }' > anchors.yaml
quick 1 'anchors.yaml:4097: more than 4096 anchors' measure ./anchors.yaml
repeat '- ' 120000 > dashes.yaml
quick 1 'dashes.yaml:1: ' measure ./dashes.yaml
repeat '# a line of a comment of forty-eight characters.
' 5600 > large.yaml
quick 1 'large.yaml: larger than 256 KiB' measure ./large.yaml
quick 1 'sky.sun.date is no date' measure "$hostile/scene_date_feb31.yaml"

# Numbers are read as they are, or not at all.
printf 'sea: {seed: 9007199254740993}\n' > seed.yaml
run measure ./seed.yaml
head -1 out | grep -q 'seed 9007199254740993' || fail 'a seed of 54 bits was rounded'
printf 'sea: {seed: 18446744073709551616}\n' > seed.yaml
refuse 1 'seed is 18446744073709551616; expected a whole number from 0 to 18446744073709551615' measure ./seed.yaml
refuse 2 '--seed is 18446744073709551616; expected' measure --seed 18446744073709551616
printf '"1","2"\n"3","4"\n' > quoted.csv
run query open-sea --points quoted.csv
[ "$(cut -d, -f1,2 out | tail -2 | tr '\n' ' ')" = '1,2 3,4 ' ] || fail 'quoted numbers'
run info
grep -Eq 'compiled by (GCC|Clang) [0-9]' out || fail 'bolan info does not name the compiler'
