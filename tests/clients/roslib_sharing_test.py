"""Runs roslib's topics and services among clients (roslib_sharing_test.mjs) against a served robot."""
from served_robot import ServedRobot, run_script

with ServedRobot() as robot:
    run_script("roslib_sharing_test.mjs", robot.port)
