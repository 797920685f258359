// The steps of an isolated plug-in: those that the tick waits for, and those whose answer the next one takes.
#include <algorithm>
#include <utility>

#include "gaitway/facts/facts.hpp"
#include "gaitway/process/real_time.hpp"
#include "isolated_plugin.hpp"

namespace gaitway::core {

bool IsolatedPlugin::run(const Tick& tick) noexcept {
  lost_in_step_ = under_way_ = false;
  const bool at_once = std::exchange(answers_at_once_, false) || !settings_.answers_next_step;
  if (condition_ == Condition::late && !resume_late(tick)) {
    return false;
  }
  if (condition_ != Condition::active) {
    if (std::exchange(settled_, Settled::none) == Settled::good) {
      return true;  // what it published before it was lost, which the next step tells
    }
    restate_loss();
    return false;
  }
  if (!at_once) {
    return run_beside_tick(tick);
  }
  begin_step(tick);
  return finish_step(step_limit_ns(), tick.now_ns);
}

void IsolatedPlugin::begin_step(const Tick& tick) noexcept {
  child_->copy_in(ports_);
  child_->request().keep_state = 1;
  child_->request().tick = abi_tick(tick);
  child_->begin(ChildCall::step);
  step_began_ns_ = tick.now_ns;
  step_began_wall_ns_ = process::monotonic_ns();
}

bool IsolatedPlugin::finish_step(std::int64_t limit_ns, std::int64_t now_ns) noexcept {
  switch (child_->finish(limit_ns, *this)) {
    case Child::Result::done:
      child_->copy_out(ports_);
      static_cast<void>(child_->take_state(*state_));
      state_ns_ = step_began_ns_;
      ++steps_since_start_;
      set_fault("");
      return true;
    case Child::Result::failed:
      fail_step(now_ns);
      return false;
    case Child::Result::pending:
      if (!options_.lock_step) {
        condition_ = Condition::late;
        still_late_ = false;
        late_ns_ = step_began_ns_;
        format_into(text_, "did not answer within {:g} ms", static_cast<double>(step_limit_ns()) * 1e-6);
        set_fault(text_.data());
        return false;
      }
      format_into(text_, "{} of wall time: its process was ended", child_->text());
      lose(text_.data(), now_ns);
      return false;
    case Child::Result::lost:
      break;
  }
  lose(child_->text(), now_ns);
  return false;
}

// Takes the answer to the step before, and begins the next one. In real time a step that is still within its
// budget is left alone; in virtual time it is waited for, so that each run of one seed does the same.
bool IsolatedPlugin::run_beside_tick(const Tick& tick) noexcept {
  under_way_ = !step_open_ && settled_ == Settled::none;
  bool fine = take_settled();
  if (step_open_) {
    const bool may_take_longer = !options_.lock_step && tick.now_ns - step_began_ns_ < step_limit_ns();
    if (may_take_longer && !child_->has_answered() && !child_->process().has_ended()) {
      under_way_ = true;
      return true;
    }
    step_open_ = false;
    // Nothing is left where the robot's clock is the computer's; a simulator may run ahead of it.
    const std::int64_t left_ns = step_limit_ns() - (process::monotonic_ns() - step_began_wall_ns_);
    fine = finish_step(options_.lock_step ? options_.watchdog_ns : std::max<std::int64_t>(left_ns, 0),
                       tick.now_ns);
  }
  if (condition_ == Condition::active) {
    begin_step(tick);
    step_open_ = true;
  }
  return fine;
}

// Before another call: takes the answer to a step that no tick waited for; what it is, the next run() tells.
// False: there is no child that could be called.
bool IsolatedPlugin::settle(std::int64_t limit_ns, std::int64_t now_ns) noexcept {
  if (step_open_ && !options_.lock_step && !child_->wait(limit_ns)) {
    tell_under_way();
    return false;
  }
  if (step_open_) {
    step_open_ = false;
    settled_ = finish_step(limit_ns, now_ns) ? Settled::good : Settled::bad;
    format_into(settled_fault_, "{}", fault());
  }
  return condition_ == Condition::active || condition_ == Condition::idle;
}

bool IsolatedPlugin::take_settled() noexcept {
  if (std::exchange(settled_, Settled::none) == Settled::bad) {
    set_fault(settled_fault_.data());
    return false;
  }
  return true;
}

void IsolatedPlugin::take_answer() noexcept {
  static_cast<void>(settle(options_.lock_step ? options_.watchdog_ns : 0, tick_.now_ns));
}

void IsolatedPlugin::fail_step(std::int64_t now_ns) noexcept {
  const std::string_view exhausted = child_->exhausted();
  set_fault(child_->text().empty() ? "failed without a text" : child_->text());
  if (!exhausted.empty()) {
    format_into(text_, "{} (its process has used up its {})", fault(), exhausted);
    lose(text_.data(), now_ns);
  }
}

// What the late step did is of no use any more. True: the child is free for the next one.
bool IsolatedPlugin::resume_late(const Tick& tick) noexcept {
  switch (child_->finish(0, *this)) {
    case Child::Result::done:
    case Child::Result::failed:
      condition_ = Condition::active;
      return true;
    case Child::Result::pending:
      format_into(text_, "has not answered for {} ms", (tick.now_ns - late_ns_) / facts::kMillisecond_ns);
      set_fault(text_.data());
      still_late_ = true;
      return false;
    case Child::Result::lost:
      break;
  }
  lose(child_->text(), tick.now_ns);
  return false;
}

}  // namespace gaitway::core
