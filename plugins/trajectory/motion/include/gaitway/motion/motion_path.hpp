// From a motion's keys to whole postures, and between them to splines: quintic polynomials from knot to knot,
// with rests at the knots that are held.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <optional>
#include <stdexcept>
#include <vector>

#include "gaitway/motion/motion.hpp"
#include "gaitway/motion/motion_limits.hpp"
#include "gaitway/trajectory/quintic.hpp"

namespace gaitway::motion {

// Why a motion cannot be played: names file, line and key, or joint and time, with value, limit and remedy.
class MotionError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct KeyPosture {
  Eigen::VectorXd joint_rad;
  // As StanceMap has it; none where the robot does not stand on flat feet.
  std::optional<Eigen::VectorXd> stance;
};

// The posture that the motion starts from, and one for each key (not for the first if the motion starts
// there). Throws MotionError where a key is out of reach or limits, out of balance, or moves a foot that it
// stands on.
[[nodiscard]] std::vector<KeyPosture> key_postures(const urdf::RobotModel& robot, const Motion& motion,
                                                   const MotionLimits& limits);

// Coordinates at a key as seen by the segments on both sides, with their derivatives. At rest where `moving`
// is empty.
struct Knot {
  Eigen::VectorXd velocity, acceleration;  // zero but for those that move
  std::vector<Eigen::Index> moving;        // coordinates that may pass through with a velocity
};

struct Segment {
  bool standing = true;  // coordinates of StanceMap; else the joints' angles
  Contact contact = Contact::both;
  Eigen::VectorXd from, to;
  double duration_s = 0.0;
  double min_time_s = 0.0;
  double hold_s = 0.0;  // at its end
};

struct MotionPath {
  std::vector<Segment> segments;
  std::vector<Knot> knots;  // one more than segments

  // Slower by the factor, along the very same curve.
  void stretch(double factor);
  // Durations and holds up to whole points.
  void round_up_to_points();
};

// Segments between the key postures, all at rest, each with a first guess of its duration that is on the slow
// side.
[[nodiscard]] MotionPath first_path(const urdf::RobotModel& robot, const Motion& motion,
                                    const std::vector<KeyPosture>& postures, const MotionLimits& limits);

// The polynomials of one segment.
[[nodiscard]] std::vector<trajectory::Quintic> polynomials(const Segment& segment, const Knot& start,
                                                           const Knot& end);

}  // namespace gaitway::motion
