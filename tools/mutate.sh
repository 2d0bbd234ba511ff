#!/bin/sh
# SPDX-License-Identifier: MIT
# mutate.sh [--list] [--only REGEX] [--jobs N] [TABLE]: can the tests fail? Applies the one-line mutations of
# tools/mutations.txt, one at a time, to a copy of the sources, builds what the tests named there need, runs those tests,
# and reports which of them killed the mutant, or that it SURVIVED. The sources themselves are never touched.
#
# The copy and its one build folder stay in ${TMPDIR:-/tmp}/bolan-mutate (or $BOLAN_MUTATE_DIR), so that each mutant is an
# incremental build; CMAKE_C_COMPILER_LAUNCHER is honoured. A mutation whose old text does not stand exactly once in its
# file is STALE, one that does not compile is NOT BUILT: both make the run fail, survivors do not.
# A mutant that hangs is killed by the time limit of its test.
set -eu
root=$(cd "$(dirname "$0")/.." && pwd)
table=$root/tools/mutations.txt only='' jobs=2 list=''
while [ $# -gt 0 ]; do
    case $1 in
    --list) list=1 ;;
    --only) only=$2 && shift ;;
    --jobs) jobs=$2 && shift ;;
    -*)
        echo "mutate.sh: unknown option $1; expected --list, --only REGEX or --jobs N" >&2
        exit 2
        ;;
    *) table=$(cd "$(dirname "$1")" && pwd)/${1##*/} ;;
    esac
    shift
done
# The tests of a mutant without a line of its own, by its folder. Each regular expression is run in turn until one kills.
shader_tests='^shaders/ ^images/'
# What says whether a mutated shader is a shader at all.
shader_check='^sources/shaders$'
io_tests='^unit/test_io ^cli/ ^physics/'
core_tests='^unit/ ^physics/ ^kernels/ ^determinism/'
# Literal hashes change with every change: a mutant that only they kill is not known to be wrong by any number.
never='^determinism/test_golden$|^packaging/|^sources/docs$'
separator=$(printf '\001')

# One line for each mutation: label, description, file, old, new, tests.
records() {
    awk -v only="$only" -v s="$separator" -v shader="$shader_tests" -v io="$io_tests" -v core="$core_tests" '
        function close_record() {
            if (label != "" && (only == "" || label ~ only)) {
                if (tests == "") tests = file ~ /^shaders|^src\/render/ ? shader : file ~ /^src\/io|^apps/ ? io : core
                print label s what s file s old s new s tests
            }
            label = ""
        }
        /^#/ || /^$/ { next }
        /^@ / { close_record(); split($0, part, /[ :]+/); label = part[2]; what = $0; sub(/^@ [^:]*: */, "", what)
                file = old = new = tests = ""; next }
        /^- / { old = substr($0, 3); next }
        /^\+ / || /^\+$/ { new = substr($0, 3); next }
        /^= / { tests = substr($0, 3); next }
        { file = $0 }
        END { close_record() }' "$table"
}

if [ -n "$list" ]; then
    records | awk -F "$separator" '{ printf "%-28s %-34s %s\n", $1, $3, $2 }'
    exit 0
fi

scratch=${BOLAN_MUTATE_DIR:-${TMPDIR:-/tmp}/bolan-mutate}
tree=$scratch/tree build=$scratch/build log=$scratch/log
mkdir -p "$tree"
records >"$scratch/records"
[ -s "$scratch/records" ] || {
    echo "mutate.sh: no mutation in $table has a label like '$only'" >&2
    exit 2
}
trap 'exit 130' INT TERM

# Brings the copy up to date. Only files that differ are written, so that ninja sees what an interrupted run left mutated.
refresh() {
    cd "$root"
    git ls-files --cached --others --exclude-standard | while read -r path; do
        [ -f "$path" ] || continue
        if ! cmp -s "$path" "$tree/$path"; then
            mkdir -p "$tree/$(dirname "$path")"
            cp "$path" "$tree/$path"
            chmod --reference="$path" "$tree/$path"
        fi
    done
    git ls-files --cached --others --exclude-standard | sort >"$scratch/wanted"
    (cd "$tree" && find . -type f | sed 's|^\./||' | sort) | comm -13 "$scratch/wanted" - | while read -r path; do
        rm -f "$tree/$path"
    done
}

# occurrences FILE: how often $OLD stands in it. replace FILE: the file with $NEW in its place.
occurrences() {
    OLD=$old awk 'BEGIN { n = 0; old = ENVIRON["OLD"] }
        { for (line = $0; (at = index(line, old)); line = substr(line, at + length(old))) n++ }
        END { print n }' "$1"
}
replace() {
    OLD=$old NEW=$new awk 'BEGIN { old = ENVIRON["OLD"]; new = ENVIRON["NEW"] }
        (at = index($0, old)) { $0 = substr($0, 1, at - 1) new substr($0, at + length(old)) }
        { print }' "$1"
}

# targets REGEX: what must be built for these tests.
targets() {
    ctest --test-dir "$build" -N -R "$1" -E "$never" | sed -n 's/^ *Test *#[0-9]*: //p' | while read -r name; do
        case $name in
        cli/*) echo bolan_cli ;;
        examples/*) echo "example_${name#*/}" ;;
        sources/shaders) echo print_shader print_variants ;;
        sources/*) ;;
        *) echo "${name#*/}" ;;
        esac
    done | sort -u
}

# build_for REGEX
build_for() {
    # shellcheck disable=SC2046 # names are words
    set -- $(targets "$1")
    [ $# = 0 ] || timeout 1200 cmake --build "$build" -j "$jobs" --target "$@" >"$log" 2>&1
}

# run_tests REGEX: fails where one of them fails; leaves the names of those in $scratch/failed. Tests that fail without any
# mutation are left out.
run_tests() {
    rm -f "$build/Testing/Temporary/LastTestsFailed.log"
    status=0
    ctest --test-dir "$build" -j "$jobs" -R "$1" -E "$never$broken" --timeout 300 \
        --no-tests=ignore $stop >"$log" 2>&1 || status=$?
    sed 's/^[0-9]*://' "$build/Testing/Temporary/LastTestsFailed.log" >"$scratch/failed" 2>/dev/null || : >"$scratch/failed"
    [ $status = 0 ]
}

refresh
{
    cmake -S "$tree" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DBOLAN_WERROR=OFF
} >"$log" 2>&1 || {
    cat "$log"
    exit 1
}
# Without a mutation first: what fails now says nothing about a mutant.
broken='' stop=''
every=$({ echo "$shader_check" && cut -d "$separator" -f 6 "$scratch/records"; } | tr ' ' '\n' | sort -u | tr '\n' '|' | sed 's/|$//')
echo "Building and testing without a mutation"
build_for "$every" || {
    tail -n 30 "$log"
    echo 'The sources do not build'
    exit 1
}
if ! run_tests "$every"; then
    while read -r name; do
        echo "left out, since it fails without a mutation: $name"
        broken="$broken|^$name\$"
    done <"$scratch/failed"
fi

stop=--stop-on-failure killed=0 survived=0 invalid=0
# report WORD
report() { printf '%-10s %-28s %s\n' "$1" "$label" "$2"; }

# try: the present record.
try() {
    if [ ! -f "$tree/$file" ] || [ "$(occurrences "$tree/$file")" != 1 ]; then
        report STALE "$file: the old text stands there $(occurrences "$tree/$file" 2>/dev/null || echo 0) times, not once"
        invalid=$((invalid + 1))
        return
    fi
    replace "$tree/$file" >"$scratch/mutant"
    cat "$scratch/mutant" >"$tree/$file"
    result=SURVIVED detail=$what
    case $file in
    shaders/*)
        if ! build_for "$shader_check" || ! run_tests "$shader_check"; then
            result='NOT BUILT' detail='the offline compiler of shaders refuses it' tests=''
        fi
        ;;
    esac
    for regex in $tests; do
        if ! build_for "$regex"; then
            result='NOT BUILT' detail=$(grep -m 1 -i 'error' "$log" || tail -n 1 "$log")
            break
        fi
        if ! run_tests "$regex"; then
            result=killed detail="by $(head -n 1 "$scratch/failed")"
            break
        fi
    done
    cat "$root/$file" >"$tree/$file"
    report "$result" "$detail"
    case $result in
    killed) killed=$((killed + 1)) ;;
    SURVIVED) survived=$((survived + 1)) ;;
    *) invalid=$((invalid + 1)) ;;
    esac
}

while IFS=$separator read -r label what file old new tests; do
    try </dev/null
done <"$scratch/records"
tried=$((killed + survived))
[ $tried = 0 ] || echo "$killed of $tried killed: $((100 * killed / tried)) %"
[ $invalid = 0 ] || {
    echo "$invalid mutations are stale or do not build: mend $table"
    exit 1
}
