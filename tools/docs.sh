#!/bin/sh
# SPDX-License-Identifier: MIT
# docs.sh SOURCE-FOLDER OUTPUT-FOLDER [PROGRAM [all|first]]: builds the site OUTPUT-FOLDER/html: the manual and, by
# doxygen, the reference. PROGRAM draws the pictures of the gallery, or a small first one; without it the gallery has
# commands alone. Any warning is a failure: a function, type, enum or macro without a comment, a reference that leads nowhere. A
# plain member of a documented struct may stand by its name alone. So is a link or picture whose target the site lacks,
# and a file or a function that the page of the data flow names and the sources lack.
set -eu
cd "$1"
root=$PWD
failures=0
fail() {
    echo "$*"
    failures=$((failures + 1))
}

# Each line of the page names files, and functions that one of them defines: `path/file.c` | `function()`, `other()`.
page=docs/how-a-picture-is-made.md
functions=0
while read -r line; do
    names=$(printf '%s\n' "$line" | grep -o '`[^`]*`' | tr -d '`')
    files=''
    for name in $names; do
        case $name in
        */*.*) if [ -f "$name" ]; then files="$files $name"; else fail "$page: there is no file $name"; fi ;;
        esac
    done
    for name in $names; do
        case $name in *'()') ;; *) continue ;; esac
        functions=$((functions + 1))
        # A definition begins at the margin; a kernel's name stands in parentheses.
        # shellcheck disable=SC2046,SC2086 # our file names hold no space
        grep -qE "^[a-z].*[^a-zA-Z0-9_]${name%()}[)]?[(]" ${files:-$(find src apps -name '*.c')} ||
            fail "$page: $name does not stand in ${files:-src or apps}"
    done
done <$page
[ $functions -ge 60 ] || fail "$page names $functions functions; expected 60 or more"
[ $failures = 0 ] || exit 1

for tool in doxygen cmark-gfm python3 ffmpeg; do
    command -v $tool >/dev/null && continue
    echo "$tool is missing: skipped"
    [ -z "${BOLAN_REQUIRE_DOCS:-}" ] || exit 1
    exit 77
done
rm -rf "$2/html"
mkdir -p "$2/html"
{
    cat docs/Doxyfile
    echo "OUTPUT_DIRECTORY = $2"
    echo "GENERATE_TAGFILE = $2/html/reference/bolan.tag"
} | doxygen - 2>"$2/log"
if grep -v 'Member .* (variable) .* is not documented' "$2/log"; then exit 1; fi
program=${3:-}
if [ -n "$program" ] && "$program" info --json | grep -q '"gl": null'; then
    echo 'There is no OpenGL here: the gallery has no pictures'
    [ "${BOLAN_REQUIRE_GL:-}" != 1 ] || exit 1
    program=
fi
python3 tools/site/site.py "$root" "$2/html" --bolan "$program" --gallery "${4:-all}" || fail 'the pages'
rm "$2/html/reference/bolan.tag"
python3 tools/site/links.py "$2/html" || fail 'the links'

grep -q 'is a C library for water' "$2/html/index.html" || fail 'the front page is not the README'
pictures=$(find "$2/html/gallery" -name '*.jpg' 2>/dev/null | wc -l)
commands=$(grep -c '^bolan render ' docs/gallery.md)
[ "${program:+${4:-all}}" != all ] || [ "$pictures" = "$commands" ] || fail "the gallery has $pictures pictures of $commands commands"
# Every log id of base.h has its row in the page of errors, with its number, and no row is of another id.
sed -n 's/^ *X(\([0-9]*\), \([A-Z0-9_]*\)).*/| \1 | `\2` |/p' "$root/include/bolan/base.h" | sort >"$2/ids"
sed -n 's/^\(| [0-9]* | `[A-Z0-9_]*` |\).*/\1/p' "$root/docs/errors.md" | sort >"$2/rows"
diff "$2/ids" "$2/rows" >"$2/difference" || fail "docs/errors.md and base.h differ in log ids: $(tr '\n' ' ' <"$2/difference")"
[ $failures = 0 ]
