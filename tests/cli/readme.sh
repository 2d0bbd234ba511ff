# SPDX-License-Identifier: MIT
# What the README says is so: its quick start compiles and runs, its pictures and files exist, and it stays short.
set -eu
readme=$BOLAN_SOURCE_DIR/README.md
fail() {
    echo "README.md: $*" >&2
    exit 1
}

lines=$(wc -l < "$readme")
[ "$lines" -le 180 ] || fail "$lines lines; at most 180"

# Paths: targets of links and pictures, and everything in the map of the tree.
sed -n 's/.*](\([^)#]*\)).*/\1/p' "$readme" | grep -v '^http' | while read -r path; do
    [ -e "$BOLAN_SOURCE_DIR/$path" ] || fail "it points to $path, which is not there"
done
sed -n '/^```tree$/,/^```$/p' "$readme" | awk '!/^```/ { print $1 }' | while read -r path; do
    [ -e "$BOLAN_SOURCE_DIR/$path" ] || fail "its map names $path, which is not there"
done

# The first C block is a whole program.
awk '/^```c$/ && !seen { seen = inside = 1; next } /^```$/ { inside = 0 } inside' "$readme" > quick_start.c
size=$(wc -l < quick_start.c)
[ "$size" -gt 5 ] || fail "no C quick start"
[ "$size" -le 30 ] || fail "the quick start has $size lines; at most 30"
library=$BOLAN_BUILD_DIR/libbolan.a
if nm "$library" 2> /dev/null | grep -q '__asan_\|__tsan_'; then
    echo 'skipped: the library is built with a sanitizer'
    exit 77
fi
"$CC" -std=c17 -Wall -Wextra -Werror -I "$BOLAN_SOURCE_DIR/include" quick_start.c "$library" -lm -lpthread -o quick_start
./quick_start > output.txt
[ "$(wc -l < output.txt)" -ge 2 ] || fail "the quick start printed too little"
cat output.txt
