// Prepares a motion while the project is built, so that a robot that starts need not plan: robot, motion's
// file, table.
#include <cstdio>
#include <exception>

#include "gaitway/motion/motion.hpp"
#include "gaitway/motion/motion_planner.hpp"
#include "gaitway/trajectory/motion_table.hpp"

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: %s ROBOT_FOLDER MOTION.yaml TABLE.motion\n", argv[0]);
    return 1;
  }
  try {
    const gaitway::urdf::RobotModel robot = gaitway::urdf::load_robot(argv[1]);
    const gaitway::motion::Motion motion = gaitway::motion::read_motion(argv[2], robot);
    gaitway::trajectory::write_motion_table(gaitway::motion::prepare_motion(robot, motion, {}).table,
                                            argv[3]);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
