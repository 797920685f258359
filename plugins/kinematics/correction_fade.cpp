// Linear fade-in, smooth fade-out.
#include "gaitway/kinematics/correction_fade.hpp"

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

BaseOffset CorrectionFade::at(std::uint64_t point) const noexcept {
  if (point < batch_count_) {
    const double share = static_cast<double>(point + 1) / static_cast<double>(batch_count_);
    return {start_.com_m + share * (target_.com_m - start_.com_m),
            start_.attitude_rad + share * (target_.attitude_rad - start_.attitude_rad)};
  }
  const std::uint64_t tail_point = point - batch_count_ + 1;
  const std::uint64_t held = tail_count_ / 2;
  if (tail_count_ == 0 || tail_point <= held) return target_;
  if (tail_point >= tail_count_) return {};
  const double phase = static_cast<double>(tail_point - held) / static_cast<double>(tail_count_ - held);
  const double share = 1.0 - phase * phase * (3.0 - 2.0 * phase);
  return {share * target_.com_m, share * target_.attitude_rad};
}

}  // namespace gaitway::kinematics
