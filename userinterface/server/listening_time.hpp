// Time in which clients were listened to: a computer that is busy elsewhere makes nobody silent.
#pragma once

#include <algorithm>
#include <cstdint>

namespace gaitway::api {

class ListeningTime {
 public:
  // `longest_ns`: what counts at most from one tick to the next; the rest of a longer pause is left out.
  ListeningTime(std::int64_t begin_ns, std::int64_t longest_ns) noexcept
      : ticked_ns_(begin_ns), longest_ns_(longest_ns) {}

  void tick(std::int64_t wall_ns) noexcept {
    listened_ns_ += std::clamp<std::int64_t>(wall_ns - ticked_ns_, 0, longest_ns_);
    ticked_ns_ = wall_ns;
  }
  // As of the latest tick.
  [[nodiscard]] std::int64_t now_ns() const noexcept { return listened_ns_; }

 private:
  std::int64_t ticked_ns_;
  std::int64_t longest_ns_;
  std::int64_t listened_ns_ = 0;
};

}  // namespace gaitway::api
