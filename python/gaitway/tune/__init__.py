"""Tuning: the gait's dimensionless numbers of one robot, searched by CMA-ES on trials, and judged on others."""
