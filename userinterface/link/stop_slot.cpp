// Counts of three kinds, each treated alike.
#include "gaitway/link/stop_slot.hpp"

#include <algorithm>
#include <array>

namespace gaitway::link {
namespace {

constexpr std::array kCounts{&StopCounts::stops, &StopCounts::holds, &StopCounts::softs};

// How far `count` is beyond `other`; 0: not at all. Counts go round.
std::uint32_t ahead(std::uint32_t count, std::uint32_t other) noexcept {
  const std::uint32_t difference = count - other;
  return static_cast<std::int32_t>(difference) > 0 ? difference : 0;
}

// Obeyed is what lies from what was obeyed to what is asked, however far these are apart; true: it has grown.
bool follow(std::uint32_t count, std::uint32_t& obeyed, std::uint32_t asked) noexcept {
  const std::uint32_t grown = count - obeyed;
  if (grown > asked - obeyed) {
    return false;  // older news
  }
  obeyed = count;
  return grown != 0;
}

}  // namespace

void StopAsker::ask(StopKind kind) noexcept {
  ++(asked_.*kCounts[static_cast<std::size_t>(kind)]);
  said_ns_.reset();
}

void StopAsker::on_answer(const StopAnswer& answer) noexcept {
  for (const auto count : kCounts) {
    follow(answer.obeyed.*count, obeyed_.*count, asked_.*count);
  }
}

std::optional<StopMessage> StopAsker::next(std::int64_t now_ns) noexcept {
  if (asked_ == obeyed_ || (said_ns_ && now_ns - *said_ns_ < repeat_ns_)) {
    return std::nullopt;
  }
  said_ns_ = now_ns;
  return StopMessage{asked_, obeyed_};
}

void StopListener::meet(std::uint64_t boot) noexcept {
  if (boot != boot_) {
    boot_ = 0;
    heard_ = {};
  }
}

void StopListener::on_stop(const StopMessage& stop, std::uint64_t boot) noexcept {
  if (boot != boot_) {
    // What is settled with a module that nobody knows an earlier run of this end has obeyed.
    boot_ = boot;
    heard_ = answered_ = stop.settled;
  }
  for (const auto count : kCounts) {
    heard_.*count += ahead(stop.settled.*count, heard_.*count);
    const std::uint32_t fresh = ahead(stop.asked.*count, heard_.*count);
    asked_.*count += fresh;
    heard_.*count += fresh;
  }
  answer_due_ = true;
}

void StopListener::obeyed(const StopCounts& obeyed) noexcept {
  for (const auto count : kCounts) {
    answer_due_ = follow(obeyed.*count, obeyed_.*count, asked_.*count) || answer_due_;
  }
}

std::optional<StopAnswer> StopListener::next() noexcept {
  if (!answer_due_) {
    return std::nullopt;
  }
  answer_due_ = false;
  for (const auto count : kCounts) {
    // Those of other modules may be open, too: what was answered once stays so.
    const std::uint32_t open = asked_.*count - obeyed_.*count;
    answered_.*count = heard_.*count - std::min(open, heard_.*count - answered_.*count);
  }
  return StopAnswer{answered_};
}

}  // namespace gaitway::link
