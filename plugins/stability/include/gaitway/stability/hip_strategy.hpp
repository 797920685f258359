// The hip strategy: a standing robot that is pushed towards its toes or heels bows, and the trunk's angular
// momentum brings the rest of it back.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "gaitway/msgclient/bow_curve.hpp"
#include "gaitway/stability/balance_parameters.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::stability {

// While the DCM stays over the soles, ankles bring it back (the ankle strategy; Horak and Nashner, Central
// programming of postural movements, 1986). With the whole load at the toes they can do no more, and a body
// that does not bend tips over them like a block. A bow by `theta` about a CoM that stays where it is turns
// the trunk's inertia J, and gives what moves the DCM back by J theta / (m z) for a
// bow that is short against the pendulum's time (the flywheel of Pratt et al., Capture point, 2006).
class HipStrategy {
 public:
  HipStrategy(const urdf::RobotModel& model, const BalanceParameters& parameters);

  // Ahead of the soles' frames.
  struct Standing {
    double dcm_ahead_m = 0.0, com_ahead_m = 0.0;
  };
  // To be called every 10 ms; none while the robot does not stand, or nothing is known of it. A body that
  // only stands askew, as one on a slope that nobody told it of, is not pushed.
  void follow(const std::optional<Standing>& standing) noexcept;

  // What a batch does beside the bow.
  enum class Batching : std::uint8_t {
    stands,
    steps,     // the trunk comes to rest: the legs need their joints' speed for the step
    lies_down  // the joints go their own way: into the posture of a fall, or home. There is no bow
  };
  // Once for each batch, before it is planned with target(). A batch of the same number changes nothing.
  // accepted_sequence: the newest batch that the message controller took, if that is known. The bow goes on
  // from what that one plays: a batch that was refused has bowed nothing.
  void begin_batch(std::uint32_t sequence, Batching what, std::uint32_t tail_count,
                   std::optional<std::uint32_t> accepted_sequence = std::nullopt) noexcept;

  // At the newest batch's end.
  [[nodiscard]] const msgclient::Bow& target() const noexcept { return batches_[newest_].to; }
  // What a batch or its tail plays; nothing of one that is not remembered.
  [[nodiscard]] msgclient::Bow at(std::uint32_t sequence, double since_start_s) const noexcept;
  // Of the newest batch: whether it bows at all.
  [[nodiscard]] bool bows() const noexcept;

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.wanted_rad_, self.batches_, self.newest_);
  }

 private:
  struct Batch {
    std::uint32_t sequence = 0;  // 0: none
    std::uint32_t tail_count = 0;
    msgclient::Bow from, to;
  };
  static constexpr std::size_t kKept = 4;  // a batch is planned less than three cycles ahead

  [[nodiscard]] const Batch* played_before(std::uint32_t sequence,
                                           std::optional<std::uint32_t> accepted_sequence) const noexcept;

  const BalanceParameters& parameters_;
  double middle_m_;          // of the soles, ahead of their frames
  double most_rad_per_s_;    // of a bow, for the joints of the legs
  double wanted_rad_ = 0.0;  // forward is positive
  std::array<Batch, kKept> batches_{};
  std::size_t newest_ = 0;
};

}  // namespace gaitway::stability
