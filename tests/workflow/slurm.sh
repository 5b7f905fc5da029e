#!/usr/bin/env bash
# A real Slurm of one node on this machine, for the tests: slurm.sh start FOLDER | slurm.sh stop FOLDER.
# Needs Debian's packages slurm-wlm and munge, and root. Its configuration, state and logs stay in FOLDER, but for a link
# /etc/slurm/slurm.conf that jobs read; a machine that has that file already is left alone. No accounting.
set -euo pipefail
what=$1 folder=$(realpath -m "$2") host=$(hostname -s)
conf=/etc/slurm/slurm.conf

start() {
  [[ ! -e $conf ]] || { echo "$conf is there already: this machine has a Slurm of its own" >&2; return 1; }
  mkdir -p "$folder"/{state,spool} /run/munge
  chown munge: /run/munge
  if ! munge -n >/dev/null 2>&1; then
    runuser -u munge -- /usr/sbin/munged --log-file=/run/munge/munged.log --pid-file=/run/munge/munged.pid
    cp /run/munge/munged.pid "$folder/munged.pid"
  fi
  cat >"$folder/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
SlurmctldPort=16817
SlurmdPort=16818
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
ReturnToService=2
MinJobAge=3600
NodeName=$host NodeAddr=127.0.0.1 CPUs=$(nproc) RealMemory=4000 State=UNKNOWN
PartitionName=main Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
  mkdir -p /etc/slurm
  ln -s "$folder/slurm.conf" $conf
  slurmctld -c
  slurmd -c
  for _ in $(seq 60); do
    sinfo -h -o %T 2>/dev/null | grep -q idle && { sinfo; return; }
    sleep 1
  done
  echo "no idle node after a minute; see $folder/slurmctld.log, $folder/slurmd.log" >&2
  return 1
}

stop() {
  for daemon in slurmd slurmctld munged; do
    [[ ! -s $folder/$daemon.pid ]] || kill "$(<"$folder/$daemon.pid")" || true
  done
  [[ $(readlink $conf) != "$folder/slurm.conf" ]] || rm $conf
}

$what
