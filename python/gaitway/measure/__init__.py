"""The trials of `gaitway measure gait` on the engine of sweeps."""
