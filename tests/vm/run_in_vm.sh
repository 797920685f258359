#!/usr/bin/env bash
# Runs a command on a Linux kernel that has CAN, whatever this computer's kernel has: inside user-mode Linux, with
# the files of this computer, the same folder and environment, as root, and with the interface vcan0 up.
#
#   run_in_vm.sh COMMAND [ARGUMENT...]
#
# The command's output comes when it has ended; its exit code is this script's. Others: 77 skipped, since
# user-mode Linux cannot run here (or 1, a failure, where GAITWAY_REQUIRE_VM=1), 124 no end within
# GAITWAY_VM_SECONDS (default 240), 125 the kernel stopped before the command ended.
set -uo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

cannot() { echo "SKIPPED: $*"; exit 77; }  # nothing that is set up on this computer would change it
skip() {
  echo "SKIPPED: $*"
  [ "${GAITWAY_REQUIRE_VM:-0}" = 1 ] && { echo "GAITWAY_REQUIRE_VM is set: a skipped test is a failure here."; exit 1; }
  exit 77
}

[ $# -gt 0 ] || { sed -n '2,9p' "$0" >&2; exit 2; }
[ "$(uname -m)" = x86_64 ] || skip "user-mode Linux is packaged for x86_64 alone, and this is $(uname -m)"
kernel=$(command -v linux.uml) || skip "there is no linux.uml (Debian package user-mode-linux)"
for tool in busybox unshare setpriv timeout ip tc candump; do
  PATH=$PATH:/usr/sbin:/sbin command -v "$tool" >/dev/null ||
    skip "'$tool' is missing (Debian packages busybox-static, util-linux, coreutils, iproute2, can-utils)"
done
modules=$(echo /usr/lib/uml/modules/*/kernel)
[ -f "$modules/net/can/can-raw.ko" ] || skip "$kernel has no CAN modules in $modules"
isolate=(unshare --pid --fork --kill-child=KILL --mount-proc)
[ "$(id -u)" -eq 0 ] || isolate=(unshare --user --map-root-user "${isolate[@]:1}")
"${isolate[@]}" true 2>/dev/null || skip "no process namespace of its own for it (unshare): $("${isolate[@]}" true 2>&1)"

# The guest's memory is a file that must be executable: prefer one that lies in memory itself.
memory_mb=${GAITWAY_VM_MEMORY_MB:-512}
memory_folder=
for folder in /dev/shm "${TMPDIR:-/tmp}"; do
  [ -w "$folder" ] || continue
  free_mb=$(df --output=avail -m "$folder" | tail -1)
  findmnt -nT "$folder" -o OPTIONS | grep -qw noexec && continue
  [ "$free_mb" -ge "$memory_mb" ] && { memory_folder=$folder; break; }
done
[ -n "$memory_folder" ] || skip "neither /dev/shm nor ${TMPDIR:-/tmp} has $memory_mb MB for it, on a file system without noexec"

job=$(mktemp -d -t gaitway_vm.XXXXXX)
trap 'rm -rf "$job"' EXIT
export -p >"$job/command"
{ printf 'cd %q\nexport TMPDIR=/dev/shm\nexec' "$PWD"; printf ' %q' "$@"; echo; } >>"$job/command"

# If this script dies, so must everything in the guest: its processes are processes of this computer's kernel,
# and left alone they would make system calls there. A process namespace ends them all with its first one, and each
# of the processes in between dies with its parent. That first one is a shell: a kernel that panics sends itself
# SIGABRT again and again, and a namespace's first process never gets it.
mortal=(setpriv --pdeathsig KILL)
seconds=${GAITWAY_VM_SECONDS:-240}
TMPDIR=$memory_folder "${mortal[@]}" timeout -s KILL "$seconds" "${mortal[@]}" "${isolate[@]}" \
  sh -c '"$@"; exit $?' kernel "$kernel" mem="${memory_mb}M" uml_dir="$job" umid=vm root=/dev/root rootfstype=hostfs rootflags=/ rw \
  init="$here/guest_init.sh" gaitway_job="$job" gaitway_modules="$modules" \
  quiet loglevel=1 con=null con0=null,null >"$job/kernel_log" 2>&1 </dev/null &
vm=$!
trap 'kill -KILL $vm 2>/dev/null; rm -rf "$job"; exit 143' TERM INT HUP
{ wait "$vm"; ended=$?; } 2>/dev/null

[ -f "$job/output" ] && cat "$job/output"
[ -f "$job/exit_code" ] && exit "$(cat "$job/exit_code")"
if [ ! -f "$job/ready" ]; then
  # Linux 6.1's user mode has no room for the registers of a processor with AMX: setting those of its first process fails.
  grep -qw amx_tile /proc/cpuinfo && cannot "user-mode Linux ended with $ended: it has no room for the registers of this processor (AMX)"
  tail -5 "$job/kernel_log"
  skip "user-mode Linux did not come up (it ended with $ended); its last lines are above"
fi
[ "$ended" -eq 137 ] && { echo "run_in_vm: no end within $seconds s" >&2; exit 124; }
echo "run_in_vm: the kernel stopped ($ended) before the command ended:" >&2
tail -20 "$job/kernel_log" >&2
exit 125
