# SPDX-License-Identifier: MIT
# The manual page has every command and every option that --help prints, with the same sentence, and groff takes it.
set -eu
. "$BOLAN_SOURCE_DIR/tests/cli/common"

run info --man
mv out bolan.1
grep -q "^\.TH BOLAN 1 .*\"$("$BOLAN" --version)\"" bolan.1 || fail 'no version in the title'
# What a reader sees, on one line a paragraph of any length.
if command -v groff > /dev/null; then
    groff -man -ww -Tutf8 -rLL=2000n -P-cbou bolan.1 > page 2> warnings || fail 'groff refuses the page'
    [ ! -s warnings ] || fail "groff: $(cat warnings)"
else
    [ -z "${BOLAN_REQUIRE_DOCS:-}" ] || fail 'groff is missing'
    echo 'no groff: the source of the page is read'
    sed 's/\\f[BIR]//g; s/\\-/-/g; s/\\&//g; s/\\(aq/'"'"'/g' bolan.1 > page
fi
sed -i 's/[‐−]/-/g; s/’/'"'"'/g; s/^ *//; s/  */ /g' page

run --help
sed -n 's/^  bolan //p' out | grep -v '^bench ' > commands
[ "$(wc -l < commands)" -ge 7 ] || fail "commands: $(cat commands)"
while read -r name rest; do
    grep -q "^bolan $name" page || fail "the page lacks bolan $name"
    sentence=$(printf '%s\n' "$rest" | sed 's/.*  //')
    grep -qF -- "$sentence" page || fail "the page lacks '$sentence'"
    "$BOLAN" "$name" --help | sed -n '/^options:/,/^SCENE/p' |
        sed -n 's/^  *\(-., \)\{0,1\}\(--[a-z-]*\)\( [^ ][^ ]*\)\{0,1\} *\(.*\)/\2\3\t\4/p' > options
    [ -s options ] || fail "bolan $name --help lists no option"
    while IFS="$(printf '\t')" read -r option sentence; do
        grep -q -- "^\(-., \)\{0,1\}$(printf '%s\n' "$option" | sed 's/[].*[]/\\&/g')" page || fail "the page lacks $option of bolan $name"
        # A long option has its sentence on the next line of the help.
        grep -qF -- "$sentence" page || fail "the page lacks '$sentence' of $option"
    done < options
done < commands
grep -q 'where the wind comes from, compass degrees (-360..360 degrees). Goes with: view, render, measure' page ||
    fail "--wind-from: $(grep -A 2 -e --wind-from page)"
for scene in island storm open-sea; do grep -q "^$scene" page || fail "the page lacks the scene $scene"; done
