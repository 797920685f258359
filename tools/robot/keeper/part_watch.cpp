// Waits, starts, works, ends.
#include "tools/robot/keeper/part_watch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace gaitway::tools {

const char* name_of(PartState state) noexcept {
  switch (state) {
    case PartState::waits:
      return "waits";
    case PartState::starts:
      return "starts";
    case PartState::works:
      return "works";
    case PartState::ends:
      return "ends";
    case PartState::off:
      break;
  }
  return "off";
}

void PartWatch::enter(PartState state, std::int64_t now_ns) noexcept {
  state_ = state;
  since_ns_ = now_ns;
}

PartWatch::Wish PartWatch::step(std::int64_t now_ns, bool may_start) {
  if (state_ == PartState::waits) {
    return may_start && now_ns >= due_ns_ ? Wish::start : Wish::nothing;
  }
  if (state_ == PartState::works && now_ns - since_ns_ >= kGoodWork_ns) {
    failures_ = 0;
  }
  const bool watched = state_ == PartState::starts || state_ == PartState::works;
  if (!watched || now_ns - progress_ns_ <= limit_ns_) {
    return Wish::nothing;
  }
  hang_ = fmt::format("made no progress for {} ms and was ended", (now_ns - progress_ns_) / 1'000'000);
  enter(PartState::ends, now_ns);
  return Wish::kill;
}

std::int64_t PartWatch::due_ns() const noexcept {
  switch (state_) {
    case PartState::waits:
      return due_ns_;
    case PartState::starts:
    case PartState::works:
      return progress_ns_ + limit_ns_ + 1;
    default:
      return std::numeric_limits<std::int64_t>::max();
  }
}

void PartWatch::on_start(std::int64_t now_ns) {
  if (ended_ns_) {
    ++restarts_;
  }
  counted_ = false;
  hang_.clear();
  progress_ns_ = now_ns;
  limit_ns_ = patience_.start_ns;
  enter(PartState::starts, now_ns);
}

void PartWatch::on_taken_over(std::int64_t now_ns) {
  on_start(now_ns);
}

void PartWatch::on_end(const std::string& how, std::int64_t now_ns) {
  reason_ = hang_.empty() ? how : hang_;
  hang_.clear();
  due_ns_ = now_ns + pause_ns();
  ++failures_;
  last_end_ns_ = now_ns;
  ended_ns_ = ended_ns_.value_or(now_ns);
  enter(PartState::waits, now_ns);
}

std::int64_t PartWatch::pause_ns() const noexcept {
  constexpr std::uint64_t kMostDoublings = 10;
  if (failures_ == 0) {
    return 0;
  }
  return std::min(kFirstPause_ns << std::min(failures_ - 1, kMostDoublings), kLongestPause_ns);
}

bool PartWatch::on_progress(std::uint64_t count, std::int64_t now_ns) {
  if (state_ != PartState::starts && state_ != PartState::works) {
    return false;
  }
  // The first count says where it begins: a sign of work only where it has grown since.
  const bool grew = counted_ && count != count_;
  counted_ = true;
  count_ = count;
  if (!grew) {
    return false;
  }
  progress_ns_ = now_ns;
  limit_ns_ = patience_.hang_ns;
  if (state_ == PartState::works) {
    return false;
  }
  enter(PartState::works, now_ns);
  ended_ns_.reset();
  return true;
}

void PartWatch::on_unseen(std::int64_t now_ns) noexcept {
  progress_ns_ = now_ns;
}

void PartWatch::on_new_ground(std::int64_t within_ns, std::int64_t now_ns) {
  if (state_ != PartState::works) {
    return;  // it is about to begin there anyway
  }
  counted_ = false;
  progress_ns_ = now_ns;
  limit_ns_ = within_ns;
}

void PartWatch::on_inner_restart(const std::string& why, std::int64_t now_ns) {
  reason_ = why;
  last_end_ns_ = now_ns;
  ++restarts_;
}

}  // namespace gaitway::tools
