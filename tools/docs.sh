#!/bin/sh
# SPDX-License-Identifier: MIT
# docs.sh SOURCE-FOLDER OUTPUT-FOLDER: builds the API reference. Any warning is a failure: a function, type, enum or macro
# without a comment, a reference that leads nowhere. A plain member of a documented struct may stand by its name alone.
# So is a picture that a page shows and the folder lacks, a page named after a folder of this machine, and a file or a
# function that the page of the data flow names and the sources lack.
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

if ! command -v doxygen >/dev/null; then
    echo 'doxygen is missing: skipped'
    exit 77
fi
rm -rf "$2/html"
mkdir -p "$2"
{
    cat docs/Doxyfile
    echo "OUTPUT_DIRECTORY = $2"
} | doxygen - 2>"$2/log"
if grep -v 'Member .* (variable) .* is not documented' "$2/log"; then exit 1; fi

cd "$2/html"
# Doxygen leaves out a picture that it does not find, without a warning: count them on both sides.
grep -oh '<img [^>]*src="[^"]*"\|<object [^>]*data="[^"]*"' ./*.html | sed 's/.*"\([^"]*\)"$/\1/' | grep -v '^http' | sort -u >../shown
while read -r picture; do
    [ -s "$picture" ] || fail "a page shows $picture, which is not there"
done <../shown
(cd "$root" && sed -n 's/!\[/\n![/gp' README.md docs/*.md | sed -n 's/^!\[[^]]*\](\([^)]*\)).*/\1/p' | sed 's|.*/||' | sort -u) >../wanted
for picture in $(cat ../wanted); do
    grep -q "^$picture\$" ../shown || fail "no page shows $picture"
done
[ -s ../wanted ] || fail 'the pages have no pictures'
for page in ./md_*.html; do
    case $page in
    ./md_docs_* | ./md_CONTRIBUTING.html | ./md_CHANGELOG.html) ;;
    *) fail "$page is named after a folder" ;;
    esac
done
grep -q 'A volcanic island' index.html || fail 'the front page is not the README'
# Every log id of base.h has its row in the page of errors, with its number, and no row is of another id.
sed -n 's/^ *X(\([0-9]*\), \([A-Z0-9_]*\)).*/| \1 | `\2` |/p' "$root/include/bolan/base.h" | sort >../ids
sed -n 's/^\(| [0-9]* | `[A-Z0-9_]*` |\).*/\1/p' "$root/docs/errors.md" | sort >../rows
diff ../ids ../rows >../difference || fail "docs/errors.md and base.h differ in log ids: $(tr '\n' ' ' <../difference)"
[ $failures = 0 ]
