// Fades the balance feedback's offsets into a batch and out of its safe tail.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/bow_curve.hpp"

namespace gaitway::kinematics {

struct BaseOffset {
  Eigen::Vector2d com_m = Eigen::Vector2d::Zero();         // added to the CoM reference, heading frame
  Eigen::Vector2d attitude_rad = Eigen::Vector2d::Zero();  // added roll, pitch of the base
  std::array<msgclient::Bow, 2> bow{};                     // added to that
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.com_m, self.attitude_rad, self.bow);
  }
};

// Over the batch's points the offset goes linearly from what the robot plays just before the batch to the new
// target, and the bow as bow_at() says. Over the first half of the tail it stays, over the second half it
// goes smoothly to zero, so that every tail ends in the nominal posture. A target that is farther away than
// the base may turn in a batch is approached over several.
class CorrectionFade {
 public:
  CorrectionFade() = default;
  // most_rad_per_s: of the base's attitude, bow included.
  explicit CorrectionFade(double most_rad_per_s) noexcept : most_rad_per_s_(most_rad_per_s) {}

  // Starts the batch `sequence`. A successor begins with what the last one has reached by then, in its batch
  // or in its tail; the same sequence again begins where it began before.
  void begin(std::uint32_t sequence, std::uint32_t batch_count, std::uint32_t tail_count,
             const BaseOffset& target) noexcept {
    if (sequence_ == 0 || sequence < sequence_) {
      start_ = BaseOffset{};
    } else if (sequence > sequence_) {
      start_ = at(std::uint64_t{sequence - sequence_} * batch_count_ - 1);
    }
    sequence_ = sequence;
    batch_count_ = batch_count;
    tail_count_ = tail_count;
    target_ = target;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto row = static_cast<Eigen::Index>(axis);
      const double most_rad = most_rad_per_s_ * batch_s();
      target_.attitude_rad[row] = std::clamp(target.attitude_rad[row], start_.attitude_rad[row] - most_rad,
                                             start_.attitude_rad[row] + most_rad);
      if (fastest_bow_rad_per_s(axis) > most_rad_per_s_) slow_down(axis);
    }
  }
  // Nothing is played any more.
  void forget() noexcept { *this = CorrectionFade(most_rad_per_s_); }

  // Offset at a point: 0 is the first of the batch; beyond the tail's end as at its end.
  [[nodiscard]] BaseOffset at(std::uint64_t point) const noexcept {
    if (batch_count_ == 0) return {};
    if (point < batch_count_) {
      const double share = static_cast<double>(point + 1) / static_cast<double>(batch_count_);
      return {start_.com_m + share * (target_.com_m - start_.com_m),
              start_.attitude_rad + share * (target_.attitude_rad - start_.attitude_rad), bow(point)};
    }
    const double share = msgclient::tail_share(point - batch_count_ + 1, tail_count_);
    std::array<msgclient::Bow, 2> fading = bow(point);
    for (msgclient::Bow& axis : fading) axis.angle_rad *= share;
    return {share * target_.com_m, share * target_.attitude_rad, fading};
  }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.sequence_, self.batch_count_, self.tail_count_, self.start_, self.target_);
  }

 private:
  [[nodiscard]] std::array<msgclient::Bow, 2> bow(std::uint64_t point) const noexcept {
    const double time_s = facts::kSlot_s * static_cast<double>(point + 1);
    return {msgclient::bow_at(start_.bow[0], target_.bow[0], time_s, batch_s()),
            msgclient::bow_at(start_.bow[1], target_.bow[1], time_s, batch_s())};
  }
  [[nodiscard]] double batch_s() const noexcept { return facts::kSlot_s * static_cast<double>(batch_count_); }
  // From one point of the batch to the next.
  [[nodiscard]] double fastest_bow_rad_per_s(std::size_t axis) const noexcept {
    double fastest = 0.0, before_rad = start_.bow[axis].angle_rad;
    for (std::uint32_t point = 0; point < batch_count_; ++point) {
      const double angle_rad = bow(point)[axis].angle_rad;
      fastest = std::max(fastest, std::abs(angle_rad - before_rad) / facts::kSlot_s);
      before_rad = angle_rad;
    }
    return fastest;
  }
  // With one acceleration through the batch.
  void slow_down(std::size_t axis) noexcept {
    const msgclient::Bow& from = start_.bow[axis];
    msgclient::Bow& to = target_.bow[axis];
    const double ends_rad_per_s = 2.0 * (to.angle_rad - from.angle_rad) / batch_s() - from.rate_rad_per_s;
    to.rate_rad_per_s = std::clamp(ends_rad_per_s, -most_rad_per_s_, most_rad_per_s_);
    to.angle_rad = from.angle_rad + 0.5 * (from.rate_rad_per_s + to.rate_rad_per_s) * batch_s();
  }

  std::uint32_t sequence_ = 0;  // 0: none yet
  std::uint32_t batch_count_ = 0, tail_count_ = 0;
  BaseOffset start_, target_;
  double most_rad_per_s_ = std::numeric_limits<double>::infinity();
};

}  // namespace gaitway::kinematics
