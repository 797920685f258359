// Absolute deadlines, which are given up when they are too far behind.
#include "gaitway/simulator/pace.hpp"

#include <algorithm>

#include "gaitway/facts/facts.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::simulator {
namespace {

using facts::kMillisecond_ns;

constexpr double kLongestLag_ns = 200.0 * static_cast<double>(kMillisecond_ns);  // then the pace begins anew

}  // namespace

Pace::Pace(double speed) : millisecond_ns_(static_cast<double>(kMillisecond_ns) / speed) {}

void Pace::set_speed(double speed) {
  millisecond_ns_ = static_cast<double>(kMillisecond_ns) / speed;
}

bool Pace::wait(std::span<pollfd> descriptors) {
  std::int64_t now_ns = process::monotonic_ns();
  double due_ns = started_ ? due_ns_ + millisecond_ns_ : static_cast<double>(now_ns);
  if (static_cast<double>(now_ns) - due_ns > kLongestLag_ns) {
    lost_ns_ += static_cast<double>(now_ns) - due_ns;
    due_ns = static_cast<double>(now_ns);
  }
  const auto deadline_ns = static_cast<std::int64_t>(due_ns);
  while (!process::stop_requested() && now_ns < deadline_ns) {
    process::wait_until(deadline_ns, descriptors);
    if (std::ranges::any_of(descriptors, [](const pollfd& one) { return one.revents != 0; })) return false;
    now_ns = process::monotonic_ns();
  }
  started_ = true;
  due_ns_ = due_ns;
  late_.add(std::max<std::int64_t>(now_ns - deadline_ns, 0));
  return !process::stop_requested();
}

}  // namespace gaitway::simulator
