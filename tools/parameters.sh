#!/bin/sh
# SPDX-License-Identifier: MIT
# parameters.sh [BOLAN [FOLDER]]: writes what is made of the tables of parameters: the tables in docs/scenes.md and
# docs/command-line.md, and the schema scenes/scene.schema.json. BOLAN is the program, by default build/bolan; with FOLDER the
# files are written there, for a comparison.
set -eu
source=$(cd "$(dirname "$0")/.." && pwd)
bolan=${1:-$source/build/bolan}
folder=${2:-$source}
mkdir -p "$folder/docs" "$folder/scenes"
tables=$(mktemp)
trap 'rm -f "$tables"' EXIT
"$bolan" info --parameters > "$tables"
for page in scenes command-line; do
    awk -v tables="$tables" '
        BEGIN { while ((getline line < tables) > 0) if (line ~ /^# /) name = substr(line, 3); else text[name] = text[name] line "\n" }
        /^<!-- end of parameters -->$/ { inside = 0 }
        !inside { print }
        /^<!-- parameters: / { inside = 1; printf "%s", text[$3] }
    ' "$source/docs/$page.md" > "$folder/docs/$page.new"
    mv "$folder/docs/$page.new" "$folder/docs/$page.md"
done
"$bolan" info --schema > "$folder/scenes/scene.schema.json"
