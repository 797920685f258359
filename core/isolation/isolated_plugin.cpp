// The step of an isolated plug-in, and what its process's end looks like from here. Between a call and its
// answer nothing is allocated and nothing locked; the futex is the only system call while all goes well.
#include "gaitway/isolation/isolated_plugin.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <string.h>

#include <algorithm>

#include "child_link.hpp"
#include "gaitway/process/real_time.hpp"
#include "plugin_declarations.hpp"

namespace gaitway::core {
namespace {

constexpr std::int64_t kLook_ns = 500'000;  // between two looks whether the child still lives
constexpr std::int64_t kFarewell_ns = 1'000'000'000;
constexpr std::int64_t kLongestRestart_ns = 800'000'000;
constexpr std::uint32_t kMostDoublings = 8;
constexpr std::int64_t kBetweenSteps_ns = 10'000'000;  // real time: of a call that the tick waits for

std::string_view name_of(ChildCall call) noexcept {
  constexpr std::array<std::string_view, 7> kNames{"its step",         "activation",    "deactivation",
                                                   "save_state",       "restore_state", "set_parameter",
                                                   "between two steps"};
  return kNames[static_cast<std::size_t>(call)];
}

template <std::size_t size>
std::string_view bounded(const char (&text)[size]) noexcept {
  return {text, strnlen(text, size - 1)};
}

template <std::size_t size, class... Values>
void format_into(std::array<char, size>& text, fmt::format_string<Values...> form,
                 const Values&... values) noexcept {
  fmt::format_to_n(text.data(), size - 1, fmt::runtime(fmt::string_view(form)), values...).out[0] = '\0';
}

}  // namespace

IsolatedPlugin::~IsolatedPlugin() {
  IsolatedPlugin::deactivate();
  if (condition_ == Condition::idle && link_) {
    begin(ChildCall::end);
    static_cast<void>(link_->process.has_ended(static_cast<int>(kFarewell_ns / 1'000'000)));
  }
}

void IsolatedPlugin::activate() {
  take_snapshots();
  copy_inputs();
  if (!call(ChildCall::activate, options_.start_limit_ns)) {
    fail("activation failed");
  }
  condition_ = Condition::active;
}

void IsolatedPlugin::deactivate() noexcept {
  if (condition_ == Condition::active) {
    condition_ = Condition::idle;
    copy_inputs();
    if (!call(ChildCall::deactivate, kFarewell_ns)) {
      events_.post(EventKind::error, name_, fault());
    }
  } else if (condition_ != Condition::idle) {
    link_.reset();
    condition_ = Condition::given_up;
  }
}

void IsolatedPlugin::copy_inputs() noexcept {
  std::size_t i = 0;
  for (TopicPort& port : ports_) {
    if (port.use().access != Access::write) {
      const std::uint64_t before = samples_[i].sequence;
      port.read(link_->value(i), samples_[i]);
      if (samples_[i].sequence != before) {
        link_->port(i).sequence = samples_[i].sequence;
        link_->port(i).stamp_ns = samples_[i].stamp_ns;
      }
    }
    ++i;
  }
}

void IsolatedPlugin::begin(ChildCall call) noexcept {
  link_->exchange().request.call = call;
  link_->calling = call;
  ring(link_->exchange().call, ++link_->called);
}

IsolatedPlugin::Outcome IsolatedPlugin::await(std::int64_t limit_ns) noexcept {
  Doorbell& bell = link_->exchange().answer;
  const std::uint32_t before = link_->called - 1;
  const std::int64_t end_ns = process::monotonic_ns() + limit_ns;
  while (!link_->spin.sees_change(bell, before)) {
    const std::int64_t left_ns = end_ns - process::monotonic_ns();
    if (left_ns <= 0) {
      return Outcome::pending;
    }
    sleep_on(bell, before, std::min(left_ns, kLook_ns));
    if (bell.number.load() == before && link_->process.has_ended()) {
      return Outcome::ended;
    }
  }
  return Outcome::answered;
}

void IsolatedPlugin::take_reports() noexcept {
  const ChildReply& reply = link_->exchange().reply;
  const std::size_t count = std::min<std::size_t>(reply.reports, kExchangeReports);
  for (std::size_t i = 0; i < count; ++i) {
    const ChildReport& report = reply.report[i];
    const EventKind kind = report.severity == GAITWAY_INFO      ? EventKind::info
                           : report.severity == GAITWAY_WARNING ? EventKind::warning
                                                                : EventKind::error;
    events_.post(kind, name_, bounded(report.text).substr(0, kLongestReport));
  }
}

bool IsolatedPlugin::take_reply() noexcept {
  const ExchangeHeader& exchange = link_->exchange();
  if (exchange.answer.number.load() != link_->called || !link_->is_whole()) {
    set_fault("wrote over the memory that it shares with the manager");
    return false;
  }
  take_reports();
  status_ = exchange.reply.status;
  set_fault(status_ == GAITWAY_OK ? std::string_view() : bounded(exchange.reply.text));
  return true;
}

std::int64_t IsolatedPlugin::between_steps_limit_ns() const noexcept {
  if (options_.lock_step) {
    return options_.watchdog_ns;
  }
  // Whoever takes such a plug-in over must not have the ticks wait for it.
  return settings_.serves_network ? step_budget_ns(containment_, period_ == Period::batch) : kBetweenSteps_ns;
}

// A call between two steps, or at set-up. False: it failed, and fault() says why.
bool IsolatedPlugin::call(ChildCall what, std::int64_t limit_ns) noexcept {
  begin(what);
  const Outcome outcome = await(limit_ns);
  if (outcome == Outcome::answered && take_reply()) {
    return status_ == GAITWAY_OK;
  }
  if (outcome == Outcome::ended) {
    describe_end(what);
  } else if (outcome == Outcome::pending) {
    format_into(loss_text_, "did not answer within {:g} ms in {}", static_cast<double>(limit_ns) * 1e-6,
                name_of(what));
    set_fault(loss_text_.data());
  }
  std::array<char, 512> text{};
  format_into(text, "{}", fault());
  lose(text.data(), tick_.now_ns);
  return false;
}

bool IsolatedPlugin::run(const Tick& tick) noexcept {
  lost_in_step_ = false;
  if (condition_ == Condition::late && !resume_late(tick)) {
    return false;
  }
  if (condition_ != Condition::active) {
    restate_loss();
    return false;
  }
  copy_inputs();
  ChildRequest& request = link_->exchange().request;
  request.keep_state = 1;
  request.tick = {.now_ns = tick.now_ns,
                  .batch_start_ns = tick.batch_start_ns,
                  .batch_sequence = tick.batch_sequence,
                  .tick = tick.tick,
                  .batch = tick.batch ? 1U : 0U,
                  .reserved = 0};
  begin(ChildCall::step);
  const std::int64_t limit_ns =
      options_.lock_step ? options_.watchdog_ns : step_budget_ns(containment_, period_ == Period::batch);
  const Outcome outcome = await(limit_ns);
  if (outcome == Outcome::answered) {
    return finish_step(tick);
  }
  std::array<char, 512> text{};
  if (outcome == Outcome::pending) {
    format_into(text, "did not answer within {:g} ms{}", static_cast<double>(limit_ns) * 1e-6,
                options_.lock_step ? " of wall time: its process was ended" : "");
    if (!options_.lock_step) {
      condition_ = Condition::late;
      still_late_ = false;
      late_ns_ = tick.now_ns;
      set_fault(text.data());
      return false;
    }
  } else {
    describe_end(ChildCall::step);
    format_into(text, "{}", fault());
  }
  lose(text.data(), tick.now_ns);
  return false;
}

// What the late step did is of no use any more. True: the child is free for the next one.
bool IsolatedPlugin::resume_late(const Tick& tick) noexcept {
  std::array<char, 512> text{};
  if (link_->exchange().answer.number.load() != link_->called - 1) {
    condition_ = Condition::active;
    if (take_reply()) {
      return true;
    }
  } else if (link_->process.has_ended()) {
    describe_end(ChildCall::step);
  } else {
    format_into(text, "has not answered for {} ms", (tick.now_ns - late_ns_) / 1'000'000);
    set_fault(text.data());
    still_late_ = true;
    return false;
  }
  format_into(text, "{}", fault());
  lose(text.data(), tick.now_ns);
  return false;
}

bool IsolatedPlugin::finish_step(const Tick& tick) noexcept {
  std::array<char, 512> text{};
  if (!take_reply()) {
    format_into(text, "{}", fault());
    lose(text.data(), tick.now_ns);
    return false;
  }
  if (status_ != GAITWAY_OK) {
    const std::uint32_t exhausted = link_->exchange().reply.exhausted;
    format_into(text, "{}", fault());
    if (text[0] == '\0') {
      format_into(text, "step answered {} without a text", status_);
      set_fault(text.data());
    }
    if (exhausted == 1 || exhausted == 2) {
      std::array<char, 512> why{};
      format_into(why, "{} (its process has used up its {})", std::string_view(text.data()),
                  exhausted == 1 ? "memory" : "file descriptors");
      lose(why.data(), tick.now_ns);
    }
    return false;
  }
  std::size_t i = 0;
  for (TopicPort& port : ports_) {
    if (port.use().access == Access::write && link_->port(i).staged != 0) {
      port.stage(link_->value(i));
    }
    ++i;
  }
  keep_state(tick);
  ++steps_since_start_;
  return true;
}

void IsolatedPlugin::keep_state(const Tick& tick) noexcept {
  const ChildReply& reply = link_->exchange().reply;
  const std::uint32_t version = reply.state_version;
  const std::uint32_t size = reply.state_size;  // read once: the child may change it at any time
  state_->version = size <= PluginState::kCapacity ? version : 0;
  if (state_->version != 0) {
    state_->size = size;
    std::copy_n(link_->exchange().state, size, state_->bytes.begin());
    state_ns_ = tick.now_ns;
  }
}

void IsolatedPlugin::describe_end(ChildCall during) noexcept {
  take_reports();
  const LastWords words = link_->exchange().last_words;
  std::array<char, 160> where{};
  if (words.signal != 0 && words.signal < NSIG) {
    if (words.in_library == 1) {
      format_into(where, " (at {:#x}, from {}+{:#x})", words.address,
                  std::string_view(library_).substr(0, 80), words.offset);
    } else {
      format_into(where, " (at {:#x}, outside of its own library)", words.address);
    }
  }
  std::array<char, 400> text{};
  format_into(text, "its process {} in {}{}", link_->process.end(), name_of(during),
              std::string_view(where.data()));
  set_fault(text.data());
}

void IsolatedPlugin::lose(std::string_view what, std::int64_t now_ns) noexcept {
  if (link_) {
    link_->process.kill();
  }
  lost_ns_ = now_ns;
  restart_ns_ = now_ns + restart_delay_ns(now_ns);
  condition_ = Condition::lost;
  lost_in_step_ = true;
  std::array<char, 512> text{};
  format_into(text, "{}", what);
  loss_text_ = text;
  const std::uint64_t recent = recent_replacements(now_ns);
  if (!settings_.serves_network && recent >= options_.replacements) {
    condition_ = Condition::given_up;
    format_into(loss_text_, "its process was replaced {} times within {:g} s; last, {}", recent,
                static_cast<double>(options_.replacement_window_ns) * 1e-9, std::string_view(text.data()));
  }
  set_fault(loss_text_.data());
}

std::uint64_t IsolatedPlugin::recent_replacements(std::int64_t now_ns) const noexcept {
  std::uint64_t recent = 0;
  const std::uint64_t known = std::min<std::uint64_t>(replaced_, replaced_ns_.size());
  for (std::uint64_t i = 0; i < known; ++i) {
    recent += now_ns - replaced_ns_[i] < options_.replacement_window_ns ? 1U : 0U;
  }
  return recent;
}

// One that serves the network is always replaced, or whoever can end it could shut the door; but the oftener
// the later.
std::int64_t IsolatedPlugin::restart_delay_ns(std::int64_t now_ns) noexcept {
  if (!settings_.serves_network) {
    return options_.restart_delay_ns;
  }
  const bool ran = condition_ == Condition::active || condition_ == Condition::late;
  if (ran && now_ns - came_back_ns_ >= options_.replacement_window_ns) {
    losses_in_a_row_ = 0;
  }
  const std::int64_t delay_ns = options_.restart_delay_ns << std::min(losses_in_a_row_, kMostDoublings);
  ++losses_in_a_row_;
  return std::min(delay_ns, kLongestRestart_ns);
}

void IsolatedPlugin::restate_loss() noexcept {
  std::array<char, 700> text{};
  format_into(text, "{} since {:.3f} s: {}",
              condition_ == Condition::given_up ? "out of service" : "is being replaced",
              static_cast<double>(lost_ns_) * 1e-9, std::string_view(loss_text_.data()));
  set_fault(text.data());
}

bool IsolatedPlugin::save_state(PluginState& state) noexcept {
  state.size = 0;
  state.version = 0;
  if (condition_ != Condition::active && condition_ != Condition::idle) {
    restate_loss();
    return false;
  }
  if (!call(ChildCall::save_state, between_steps_limit_ns())) {
    return false;
  }
  const std::uint32_t size = link_->exchange().reply.state_size;
  const std::uint32_t version = link_->exchange().reply.state_version;
  if (size > PluginState::kCapacity) {
    set_fault("save_state claims more bytes than there is room for");
    return false;
  }
  std::copy_n(link_->exchange().state, size, state.bytes.begin());
  state.size = size;
  state.version = version;
  return true;
}

bool IsolatedPlugin::restore_state(const PluginState& state) noexcept {
  set_fault("");
  if (state.version == 0) {
    return true;  // nothing was handed on
  }
  if (condition_ != Condition::active && condition_ != Condition::idle) {
    restate_loss();
    return false;
  }
  std::copy_n(state.bytes.begin(), state.size, link_->exchange().state);
  link_->exchange().request.state_size = state.size;
  link_->exchange().request.state_version = state.version;
  return call(ChildCall::restore_state, between_steps_limit_ns());
}

bool IsolatedPlugin::set_parameter(const char* name, const gaitway_value& value) noexcept {
  if (condition_ != Condition::active && condition_ != Condition::idle) {
    restate_loss();
    return false;
  }
  ChildRequest& request = link_->exchange().request;
  const std::size_t text_bytes = value.text == nullptr ? 0 : strlen(value.text);
  if (strlen(name) >= sizeof request.parameter_name || text_bytes >= sizeof request.parameter_text) {
    set_fault("name or text is too long to be changed in a process of its own");
    return false;
  }
  request.parameter = value;
  request.parameter.text = nullptr;
  std::copy_n(name, strlen(name) + 1, request.parameter_name);
  std::copy_n(value.text == nullptr ? "" : value.text, text_bytes + 1, request.parameter_text);
  return call(ChildCall::set_parameter, between_steps_limit_ns());
}

}  // namespace gaitway::core
