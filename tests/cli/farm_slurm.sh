# SPDX-License-Identifier: MIT
# The script of bolan farm --slurm runs on a Slurm of one node, which this test starts: munge, slurmctld and slurmd with
# a configuration, keys, ports and folders of their own.
set -eu
. "$BOLAN_SOURCE_DIR/tests/cli/common"

film='open-sea --technique exp-cosine --size 160x90 --quality low --fps 10 --frames 2 --quiet'
# shellcheck disable=SC2086 # split on purpose
run farm $film -o drawn --slurm farm.sh
[ ! -e drawn ] || fail '--slurm drew'
sh -n farm.sh || fail 'the script is not one'
grep -q '^#SBATCH --array=0-1$' farm.sh || fail 'the script has another number of tasks'
rm farm.sh
quote="it's"
run farm pond --frames 5000 -o "$quote" --slurm farm.sh
grep -q "^#SBATCH --array=0-999$" farm.sh || fail 'the array is too long'
grep -q "'it'\\\\''s'" farm.sh || fail "a quote is lost: $(cat farm.sh)"

skip() {
    [ "${BOLAN_REQUIRE_SLURM:-}" != 1 ] || fail "$1, and BOLAN_REQUIRE_SLURM is 1"
    echo "skipped: $1"
    exit 77
}
PATH=$PATH:/usr/sbin:/sbin
for program in munged slurmctld slurmd sbatch squeue; do
    command -v "$program" > /dev/null || skip "there is no $program on this machine; Debian: slurmctld slurmd slurm-client munge"
done
[ "$(id -u)" -eq 0 ] || skip 'a Slurm of its own takes root'
need_gl

# munged refuses folders that others may write to, as the parents of the build tree may be.
place=$(mktemp -d /run/bolan-slurm-XXXXXX 2> /dev/null) || skip 'there is no /run to write to'
chmod 755 "$place"
controller= node= keys=
stop() {
    for process in $node $controller $keys; do kill "$process" 2> /dev/null || true; done
    for process in $node $controller $keys; do wait "$process" 2> /dev/null || true; done
    rm -rf "$place"
}
trap stop EXIT
trap 'exit 130' INT TERM
mkdir "$place/munge" "$place/state" "$place/spool" "$place/log"
head -c 128 /dev/urandom > "$place/munge/key"
chmod 600 "$place/munge/key"
chmod 700 "$place/munge"
chmod 755 "$place"
munged --foreground --force --key-file="$place/munge/key" --socket="$place/socket" --pid-file="$place/munge/pid" \
    --log-file="$place/munge/log" --seed-file="$place/munge/seed" > "$place/log/munged" 2>&1 &
keys=$!

# A port of the machine that nobody listens at, and the next.
port=$((20000 + $$ % 20000))
cores=$(nproc)
cat > "$place/slurm.conf" << END
ClusterName=bolan
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket=$place/socket
CredType=cred/munge
SlurmctldPort=$port
SlurmdPort=$((port + 1))
StateSaveLocation=$place/state
SlurmdSpoolDir=$place/spool
SlurmctldPidFile=$place/slurmctld.pid
SlurmdPidFile=$place/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
SchedulerParameters=sched_interval=1,batch_sched_delay=0
JobCompType=jobcomp/none
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=$cores State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
SLURM_CONF=$place/slurm.conf
export SLURM_CONF
slurmctld -D -c > "$place/log/slurmctld" 2>&1 &
controller=$!
slurmd -D -c > "$place/log/slurmd" 2>&1 &
node=$!
logs() { tail -n 20 "$place"/log/* slurm-*.out 2> /dev/null || true; }
tries=0
until sinfo -h -o %T 2> /dev/null | grep -q idle; do
    tries=$((tries + 1))
    [ "$tries" -lt 300 ] || fail "the Slurm of one node does not start: $(logs)"
    sleep 0.1
done

# shellcheck disable=SC2086
{
    run farm $film -o drawn --slurm farm.sh
    sbatch --wait farm.sh > out.txt 2>&1 || fail "the array failed: $(cat out.txt) $(logs)"
    run farm $film -o alone --processes 1
}
diff -r alone drawn > difference || fail "Slurm's files are others: $(cat difference)"
