"""Runs roslib's own test (roslib_test.mjs) against a served robot."""
from served_robot import ServedRobot, run_script

with ServedRobot(speed=2.0) as robot:
    run_script("roslib_test.mjs", robot.port)
