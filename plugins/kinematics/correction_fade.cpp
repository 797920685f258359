// Linear fade-in, smooth fade-out.
#include "gaitway/kinematics/correction_fade.hpp"

#include "gaitway/facts/facts.hpp"

namespace gaitway::kinematics {

void CorrectionFade::begin(std::uint32_t sequence, std::uint32_t batch_count, std::uint32_t tail_count,
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
}

std::array<msgclient::Bow, 2> CorrectionFade::bow(std::uint64_t point) const noexcept {
  const double time_s = facts::kSlot_s * static_cast<double>(point + 1);
  const double batch_s = facts::kSlot_s * static_cast<double>(batch_count_);
  return {msgclient::bow_at(start_.bow[0], target_.bow[0], time_s, batch_s),
          msgclient::bow_at(start_.bow[1], target_.bow[1], time_s, batch_s)};
}

BaseOffset CorrectionFade::at(std::uint64_t point) const noexcept {
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

}  // namespace gaitway::kinematics
