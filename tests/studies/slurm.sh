# shellcheck shell=bash
# Runs a Slurm of one node on loopback for tests, with its own configuration, keys, ports and logs in a folder.
#
#   . slurm.sh
#   start_slurm FOLDER    starts munged, slurmctld and slurmd, and waits until the node takes jobs; then sbatch,
#                         squeue, … use it. Returns 1 and prints the reason if that fails.
#   stop_slurm            ends them by their process ids; may be called in a trap.

slurm_processes=()

free_port() { # prints an unused port on loopback
  local port
  while :; do
    port=$((20000 + (RANDOM * 32768 + RANDOM) % 20000))
    if ! (exec 3<>"/dev/tcp/127.0.0.1/$port") 2>/dev/null; then
      echo "$port"
      return
    fi
  done
}

stop_slurm() {
  local process
  for process in "${slurm_processes[@]}"; do kill "$process" 2>/dev/null || :; done
  for process in "${slurm_processes[@]}"; do wait "$process" 2>/dev/null || :; done
  slurm_processes=()
}

start_slurm() {
  local dir=$1 host tool
  for tool in munged slurmctld slurmd sbatch squeue sinfo; do
    if ! command -v $tool >/dev/null; then
      echo "no Slurm: $tool is not installed"
      return 1
    fi
  done
  if [ "$(id -u)" != 0 ]; then
    echo "no Slurm: slurmd has to be started by root"
    return 1
  fi
  host=$(hostname -s)
  mkdir -p "$dir"/{state,spool,log}
  chmod 0711 "$dir"
  head -c 1024 /dev/urandom >"$dir/munge.key"
  chmod 0600 "$dir/munge.key"
  cat >"$dir/slurm.conf" <<END
ClusterName=morula-test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$(free_port)
SlurmdPort=$(free_port)
SlurmUser=root
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$dir/munge.socket
StateSaveLocation=$dir/state
SlurmdSpoolDir=$dir/spool
SlurmctldPidFile=$dir/slurmctld.pid
SlurmdPidFile=$dir/slurmd.pid
SlurmctldLogFile=$dir/log/slurmctld
SlurmdLogFile=$dir/log/slurmd
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerParameters=batch_sched_delay=0,sched_interval=2,sched_min_interval=0
MinJobAge=60
ReturnToService=2
MailProg=/bin/true
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 RealMemory=1500 State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
  export SLURM_CONF=$dir/slurm.conf
  munged --foreground --force --key-file="$dir/munge.key" --socket="$dir/munge.socket" --pid-file="$dir/munged.pid" \
    --log-file="$dir/log/munged" --seed-file="$dir/munge.seed" >"$dir/log/munged.out" 2>&1 &
  slurm_processes+=($!)
  local i
  for ((i = 0; i < 100; ++i)); do
    if [ -S "$dir/munge.socket" ]; then break; fi
    sleep 0.05
  done
  slurmctld -D -f "$SLURM_CONF" >"$dir/log/slurmctld.out" 2>&1 &
  slurm_processes+=($!)
  slurmd -D -f "$SLURM_CONF" -N "$host" >"$dir/log/slurmd.out" 2>&1 &
  slurm_processes+=($!)
  for ((i = 0; i < 150; ++i)); do
    if [ "$(sinfo --noheader --format=%t 2>/dev/null)" = idle ]; then return 0; fi
    sleep 0.1
  done
  echo "no Slurm: its daemons did not come up: $(tail -qn 2 "$dir"/log/* 2>/dev/null | tr '\n' ';' | cut -c 1-400)"
  stop_slurm
  return 1
}
