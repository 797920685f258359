#!/usr/bin/env bash
# Installs a wheel on a Debian 12 that has Python and nothing else, no compiler, and lets the robot walk there; says how long
# that took, from `pip install` with no cache to the end of a walk of 20 s. Then tries the rest of the package.
#
#   python/packaging/try_on_bare_debian.sh WHEEL [FOLDER]
#
# As root, with debootstrap installed. FOLDER (default out/bare_debian) becomes the bare system, or is one from before.
set -euo pipefail
[ $# -ge 1 ] && [ -f "$1" ] || { echo "Usage: $0 WHEEL [FOLDER]" >&2; exit 1; }
wheel=$(realpath "$1") folder=$(realpath -m "${2:-out/bare_debian}")
[ "$(id -u)" -eq 0 ] || { echo "$0: must be root, for chroot" >&2; exit 1; }

if [ ! -e "$folder/is_complete" ]; then
  command -v debootstrap >/dev/null || { echo "$0: apt-get install debootstrap first" >&2; exit 1; }
  rm -rf "$folder"
  debootstrap --variant=minbase --include=python3,python3-venv,ca-certificates bookworm "$folder" "${DEBIAN_MIRROR:-http://deb.debian.org/debian}" >"$folder.log" 2>&1 ||
    { tail -n 20 "$folder.log" >&2; exit 1; }
  touch "$folder/is_complete"
fi
# The package index is reached as it is from here.
cp -L /etc/resolv.conf "$folder/etc/resolv.conf"
cp -L "${PIP_CERT:-/etc/ssl/certs/ca-certificates.crt}" "$folder/etc/ssl/certs/ca-certificates.crt"
rm -rf "$folder/root/try" && mkdir "$folder/root/try"
cp "$wheel" "$folder/root/try/"

cat >"$folder/root/try/try.sh" <<'INSIDE'
set -euo pipefail
cd /root/try
for program in cc gcc g++ c++ ld make cmake; do
  if command -v "$program" >/dev/null; then echo "this system is not bare: it has $program" >&2; exit 1; fi
done
wheel=$(echo /root/try/gaitway-*.whl)
install_and_walk() {
  venv/bin/pip install --quiet --no-cache-dir --disable-pip-version-check "$wheel"
  venv/bin/gaitway run --seconds 20 --out walk --quiet --no-pictures
}
python3 -m venv venv
TIMEFORMAT='from pip install to the end of a 20 s walk: %R s (CPU: %U s in programs, %S s in the system)'
time install_and_walk
grep -q '"ended": *true' walk/summary.json
venv/bin/python - <<'CODE'
import json
import gaitway

robot = gaitway.Robot()
robot.run(1.0)
robot.walk(0.15)
robot.run(19.0)
assert robot.digest == json.load(open("walk/summary.json"))["digest"], "not the robot of gaitway run"
assert robot.truth().base_m[0] > 1.5, robot.truth()
print(f"Robot: walked {robot.truth().base_m[0]:.2f} m, as gaitway run did")
CODE
venv/bin/pip install --quiet --no-cache-dir --disable-pip-version-check "$wheel[gym,sweep,tune]"
venv/bin/python - <<'CODE'
import numpy as np
import gaitway

env = gaitway.Env()
env.reset(seed=1)
for _ in range(20):
    env.step(np.array([0.15, 0.0, 0.0]))
vec = gaitway.make_vec(2)
vec.reset(seed=1)
vec.step(np.zeros((2, 3)))
print(f"Env and make_vec: {env.robot.time_s:.2f} s")
CODE
printf 'seeds: 1..4\nseconds: 3\nmeasures: [survived, mean_speed_m_s]\n' >sweep.yaml
venv/bin/gaitway sweep sweep.yaml --store store --out sweep
[ "$(wc -l <sweep/results.csv)" -eq 5 ]
result=0
venv/bin/gaitway tune --robot humanoid22 --size small --generations 1 --numbers trajectory.lift --store store --out tune || result=$?
case $result in 0 | 6) ;; *) echo "gaitway tune ended with $result" >&2; exit 1 ;; esac
[ -s tune/tuned.md ]
venv/bin/gaitway motion check squat >/dev/null
venv/bin/gaitway calibrate --simulate --rounds 1 --quiet
echo "sweep, tune, motion and calibrate: as they should"
INSIDE

environment=(HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 PIP_CERT=/etc/ssl/certs/ca-certificates.crt)
for name in PIP_INDEX_URL PIP_DEFAULT_TIMEOUT http_proxy https_proxy no_proxy; do
  [ -z "${!name:-}" ] || environment+=("$name=${!name}")
done
# shellcheck disable=SC2016
unshare --mount --pid --fork bash -c 'mount --make-rprivate / && mount -t proc proc "$1/proc" && mount --rbind /dev "$1/dev" &&
  exec chroot "$1" env -i "${@:2}" bash /root/try/try.sh' in "$folder" "${environment[@]}"
