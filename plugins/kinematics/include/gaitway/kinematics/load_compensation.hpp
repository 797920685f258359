// A servo gives way under load: its joint comes to lie where stiffness times error is the load. So the
// references lead the planned angles by the planned load over the stiffness, and the legs go where they were
// planned.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <span>

#include "gaitway/kinematics/leg_load.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematics {

class LoadCompensation {
 public:
  explicit LoadCompensation(const urdf::RobotModel& model);

  // Where the base is at each point of the plan that is solved now; plan frame.
  [[nodiscard]] Eigen::Isometry3d& base(int point) noexcept { return base_[static_cast<std::size_t>(point)]; }

  // Adds the lead to the legs' angles in joint_plan, all points; base() of each must be set. `goes_on`: the
  // batch follows the one of the last call. The first batch fades the compensation in from where the
  // references are (joint order of the model; empty: from none). No allocation.
  void apply(const MotionPlan& plan, bool goes_on, std::span<const double> reference_rad,
             JointPlan& joint_plan);

  // The next batch is like the first one.
  void begin_anew() noexcept { past_.started = false; }
  // The next batch replaces the last one.
  void take_back() noexcept { past_ = past_before_; }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.past_.started, self.past_.share, self.past_.rows);
  }

 private:
  static constexpr int kBefore = 2;  // points of the last batch that are kept: for accelerations
  using Angles = std::array<double, 6>;
  struct Row {  // a point's legs, without compensation
    std::array<Angles, 2> angle_rad{};
    std::array<LegPlaces, 2> places;
    template <class Self, class Archive>
    static void visit_state(Self& self, Archive& archive) {
      archive(self.angle_rad);
      for (auto& leg : self.places) archive(leg.joint_m, leg.axis, leg.com_m);
    }
  };

  // The points from whose places and angles a difference is taken: middle - reach, middle, middle + reach.
  struct Neighbours {
    int middle = 0, reach = 0;
  };

  void read_row(const JointPlan& joint_plan, int point);
  [[nodiscard]] std::array<GroundForce, 2> ground_forces(const MotionPlan& plan, int point) const noexcept;
  [[nodiscard]] std::array<Angles, 2> lead_rad(const MotionPlan& plan, int point, const Neighbours& by) const;
  [[nodiscard]] const Row& row(int point) const noexcept;
  void add(const std::array<Angles, 2>& lead, JointPlan& joint_plan, int point) const noexcept;
  void add_to_tail(const MotionPlan& plan, int points, std::array<Angles, 2> lead, JointPlan& joint_plan);
  [[nodiscard]] double share_of(std::span<const double> reference_rad,
                                const std::array<Angles, 2>& lead) const;

  urdf::RobotModel model_;
  std::array<LegLoad, 2> load_;
  double mass_kg_, com_height_m_;
  std::array<Eigen::Isometry3d, kMaxPoints> base_;
  std::array<Row, kMaxPoints> rows_;
  // What a batch goes on from.
  struct Past {
    std::array<Row, kBefore> rows;
    bool started = false;
    double share = 0.0;  // of the lead that is applied at the end of the last batch
  };
  Past past_, past_before_;  // of the next batch, and of the last one
};

}  // namespace gaitway::kinematics
