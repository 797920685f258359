// How many messages one client sends, against what it may: a bucket that fills with time.
#pragma once

#include <algorithm>
#include <cstdint>

namespace gaitway::api {

class MessageRate {
 public:
  enum class Verdict : std::uint8_t {
    fine,
    too_many,  // this one is refused
    goes_on    // a second's worth of messages has been refused by now: enough
  };

  // `now_ns`: when the client came. It may send a second's worth at once.
  MessageRate(double messages_per_s, std::int64_t now_ns) noexcept
      : per_s_(messages_per_s), left_(messages_per_s), filled_ns_(now_ns) {}

  Verdict count(std::int64_t now_ns) noexcept {
    const double passed_s = static_cast<double>(std::max<std::int64_t>(now_ns - filled_ns_, 0)) * 1e-9;
    filled_ns_ = std::max(now_ns, filled_ns_);
    left_ = std::min(left_ + passed_s * per_s_, per_s_);
    refused_ = std::max(refused_ - passed_s * per_s_ * kForgiven, 0.0);
    if (left_ >= 1.0) {
      left_ -= 1.0;
      return Verdict::fine;
    }
    refused_ += 1.0;
    return refused_ > per_s_ ? Verdict::goes_on : Verdict::too_many;
  }

 private:
  static constexpr double kForgiven =
      0.1;  // of the refusals: so many of the allowed rate are forgotten again

  double per_s_;
  double left_;
  double refused_ = 0.0;
  std::int64_t filled_ns_;
};

}  // namespace gaitway::api
