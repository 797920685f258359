#!/bin/sh
# The first process of the guest that run_in_vm.sh starts: brings CAN up, runs the job's command, powers off.
# The kernel passes gaitway_job and gaitway_modules on from its command line. The root file system is that of the
# computer outside: nothing is changed in it but the job's own folder, and mounts are the guest's alone.
export PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin
mount -t proc proc /proc
mount -t sysfs sys /sys
mkdir -p /dev/shm /dev/pts
mount -t tmpfs -o mode=1777 shm /dev/shm
mount -t devpts -o ptmxmode=666 pts /dev/pts

modules="net/can/can net/can/can-raw net/can/can-gw drivers/net/can/dev/can-dev drivers/net/can/slcan/slcan net/sched/sch_netem"
for module in $modules; do
  busybox insmod "$gaitway_modules/$module.ko" || echo "$module cannot be loaded" >>"$gaitway_job/kernel_log"
done
# As a controller does, vcan gives a frame back to its sender when it has left the queue, not before.
busybox insmod "$gaitway_modules/drivers/net/can/vcan.ko" echo=1
# Frames are delivered by a kernel thread when there are many: programs of high priority must not hold it up.
for thread in $(busybox pgrep ksoftirqd); do
  busybox chrt -f -p 90 "$thread" >/dev/null
done
ip link set lo up
if ip link add dev vcan0 type vcan && ip link set vcan0 mtu 72 up; then
  : >"$gaitway_job/ready"
  setsid bash "$gaitway_job/command" >"$gaitway_job/output" 2>&1 </dev/null
  echo $? >"$gaitway_job/exit_code.new"
  mv "$gaitway_job/exit_code.new" "$gaitway_job/exit_code"
fi
busybox poweroff -f
