# %% [markdown]
# # A walk, and a push from the side
# Each cell stands alone in a notebook (`# %%`); as a script it writes its plots into a folder: `python push_recovery.py OUT`.
# Without matplotlib there is a table in place of the plots.

# %%
import pathlib
import sys

import numpy as np

import gaitway

out = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "out/python")
out.mkdir(parents=True, exist_ok=True)

# %% A robot; what it is told takes effect in the next millisecond.
robot = gaitway.Robot(seed=3)
print(robot, "with", len(robot.joints), "joints")
print(gaitway.topics()["imu"])
robot.run(1.0)
robot.walk(0.15)

# %% Every 10 ms what the filters make of the sensors, and the truth. A view follows by itself; nothing is copied but what is kept.
estimate = robot.view("estimate")
rows = []
snapshot = None
for i in range(500):
    if i == 300:
        snapshot = robot.snapshot()
        robot.push("trunk" if "trunk" in robot.links else robot.links[0], (0.0, 1.0, 0.0))
    robot.run(0.01)
    truth = robot.truth()
    rows.append((robot.time_s, *estimate["dcm"], *estimate["zmp"], *truth.base_m[:2], truth.tilt_rad))
data = np.array(rows)

# %% The same instant again, without the push.
assert snapshot is not None
robot.restore(snapshot)
robot.run(2.0)
unpushed_m = robot.truth().base_m

# %%
print(f"pushed: at {data[-1, 5]:.3f}, {data[-1, 6]:.3f} m, largest tilt {np.rad2deg(data[:, 7].max()):.1f} deg; "
      f"unpushed: at {unpushed_m[0]:.3f}, {unpushed_m[1]:.3f} m; fallen: {robot.fallen}")
for event in robot.events()[-3:]:
    print(f"{event.time_s:7.3f} s  {event.kind:8} {event.source}: {event.text}")

# %%
try:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
except ImportError:
    np.savetxt(out / "push_recovery.csv", data, delimiter=",", header="time_s,dcm_x,dcm_y,zmp_x,zmp_y,base_x,base_y,tilt", comments="")
else:
    figure, (upper, lower) = plt.subplots(2, 1, sharex=True, figsize=(9, 6))
    upper.plot(data[:, 0], data[:, 2], label="DCM, left [m]")
    upper.plot(data[:, 0], data[:, 4], label="ZMP, left [m]", linewidth=0.8)
    lower.plot(data[:, 0], np.rad2deg(data[:, 7]), label="tilt of the trunk [deg]")
    for axes in (upper, lower):
        axes.axvline(data[300, 0], color="grey", linestyle=":")
        axes.legend()
    lower.set_xlabel("time [s]")
    figure.savefig(out / "push_recovery.png", dpi=100)
