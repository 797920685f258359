"""Sweeps: many trials over robots, configurations, parameters and seeds, here or on a cluster of computers."""
