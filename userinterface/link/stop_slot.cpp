// Counts of three kinds, each treated alike.
#include "gaitway/link/stop_slot.hpp"

#include <algorithm>
#include <array>

namespace gaitway::link {
namespace {

constexpr std::array kCounts{&StopCounts::stops, &StopCounts::holds, &StopCounts::softs};

}  // namespace

void StopAsker::ask(StopKind kind) noexcept {
  ++(asked_.*kCounts[static_cast<std::size_t>(kind)]);
  said_ns_.reset();
}

void StopAsker::on_answer(const StopAnswer& answer) noexcept {
  for (const auto count : kCounts) {
    obeyed_.*count = std::clamp(answer.obeyed.*count, obeyed_.*count, asked_.*count);
  }
}

std::optional<StopMessage> StopAsker::next(std::int64_t now_ns) noexcept {
  if (asked_ == obeyed_ || (said_ns_ && now_ns - *said_ns_ < repeat_ns_)) {
    return std::nullopt;
  }
  said_ns_ = now_ns;
  return StopMessage{asked_, obeyed_};
}

void StopListener::on_stop(const StopMessage& stop, std::uint64_t boot) noexcept {
  if (boot != boot_) {
    boot_ = boot;
    heard_ = stop.settled;
  }
  for (const auto count : kCounts) {
    // Settled counts more than heard: this end was started again, and an earlier run has obeyed them.
    const std::uint32_t known = std::max(heard_.*count, stop.settled.*count);
    if (stop.asked.*count > known) {
      asked_.*count += stop.asked.*count - known;
    }
    heard_.*count = std::max(known, stop.asked.*count);
  }
  answer_due_ = true;
}

void StopListener::obeyed(const StopCounts& obeyed) noexcept {
  for (const auto count : kCounts) {
    const std::uint32_t grown = std::clamp(obeyed.*count, obeyed_.*count, asked_.*count);
    answer_due_ = answer_due_ || grown != obeyed_.*count;
    obeyed_.*count = grown;
  }
}

std::optional<StopAnswer> StopListener::next() noexcept {
  if (!answer_due_) {
    return std::nullopt;
  }
  answer_due_ = false;
  StopAnswer answer;
  for (const auto count : kCounts) {
    const std::uint32_t open = asked_.*count - obeyed_.*count;
    answer.obeyed.*count = heard_.*count - std::min(open, heard_.*count);
  }
  return answer;
}

}  // namespace gaitway::link
