# SPDX-License-Identifier: MIT
# bolan farm by ranks of Open MPI: the bytes are those of one process, rank 0 alone speaks, and a process that dies costs
# its frame.
set -eu
. "$BOLAN_SOURCE_DIR/tests/cli/common"

skip() {
    [ "${BOLAN_REQUIRE_MPI:-}" != 1 ] || fail "$1, and BOLAN_REQUIRE_MPI is 1"
    echo "skipped: $1"
    exit 77
}
command -v mpirun > /dev/null || skip 'there is no mpirun on this machine; Debian: openmpi-bin'
OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_ALLOW_RUN_AS_ROOT OMPI_ALLOW_RUN_AS_ROOT_CONFIRM
# ranks N ARGUMENTS...
ranks() {
    count=$1
    shift
    mpirun --oversubscribe -n "$count" "$BOLAN" "$@"
}
status=0
ranks 2 farm pond --frames 4 -o 'a-%d.png' --processes 2 > out 2> err || status=$?
! grep -q 'built without MPI' err || skip 'the program is built without MPI'
[ "$status" -eq 2 ] || fail "exit code $status: $(cat err)"
[ "$(grep -c '^bolan: --processes does not go with mpirun' err)" -eq 1 ] || fail "said: $(cat err)"
printf 'wind\n3\n71\n' > t.csv
status=0
ranks 2 farm t.csv -o out > /dev/null 2> err || status=$?
[ "$status" -eq 2 ] || fail "a wrong row: exit code $status: $(cat err)"
[ "$(grep -c '^bolan: t.csv:3: --wind is 71' err)" -eq 1 ] || fail "a wrong row: $(cat err)"
need_gl

film='open-sea --technique exp-cosine --size 160x90 --quality low --fps 10 --frames 4 --quiet'
# shellcheck disable=SC2086 # split on purpose
{
    run farm $film -o one --processes 1
    ranks 2 farm $film -o ranks > out 2> err || fail "$(cat err)"
}
[ ! -s out ] || fail "printed: $(cat out)"
diff -r one ranks > difference || fail "ranks write other files: $(cat difference)"

# A process dies while it draws its first frame.
rm -r ranks
status=0
# shellcheck disable=SC2086
ranks 2 farm $film -o ranks > out 2> err &
job=$!
# Processes that draw, below our mpirun.
drawers() {
    ps -eo pid=,ppid=,args= | awk -v root="$job" '
        { parent[$1] = $2; if ($0 ~ / worker [0-9]/) drawer[$1] }
        END { for (p in drawer) { for (up = p; up in parent && up != root;) up = parent[up]; if (up == root) print p } }'
}
tries=0
until [ "$(drawers | wc -l)" -eq 2 ]; do
    tries=$((tries + 1))
    [ "$tries" -lt 2400 ] || fail "nobody draws: $(cat err)"
    sleep 0.05
done
kill -KILL "$(drawers | tail -n 1)"
wait "$job" || status=$?
[ "$status" -ne 0 ] || fail 'a dead process is no failure'
[ "$(grep -c '^bolan: 1 of 4 frames failed: [0-9] (its process was ended by signal 9)' err)" -eq 1 ] || fail "said: $(cat err)"
[ "$(find ranks -name '*.png' | wc -l)" -eq 3 ] || fail "a dead process cost more than its frame: $(ls ranks)"
[ -z "$(find ranks -name '*.part*')" ] || fail 'left an unfinished file'
