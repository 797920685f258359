// The conditions of an isolated plug-in, in service, lost, and on its way back; and calls between two steps.
#include "isolated_plugin.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gaitway/facts/facts.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::core {
namespace {

using facts::kMillisecond_ns;
constexpr std::int64_t kFarewell_ns = 1'000'000'000;
constexpr std::uint32_t kProven = 8;  // steps after which a restored state is not to blame for the next end

}  // namespace

IsolatedPlugin::IsolatedPlugin(const PluginEntry& entry, const PluginSource& source,
                               const IsolationOptions& options, EventLog& events)
    : ManagedPlugin(entry, source.configuration_file, events, source.robot_directory),
      settings_(entry.child),
      options_(options_for(entry.child, options)),
      containment_(entry.containment),
      restarts_(options_, settings_.local_sockets) {
  try {
    plan_.emplace(entry, source, options_);
    start();
    while (!attend_start(options_.start_limit_ns)) {
    }
  } catch (const PluginError& error) {
    throw PluginError(fmt::format("{}: {}", place_, error.what()));
  }
  parameters_.require_all_declared();
  condition_ = Condition::idle;
}

IsolatedPlugin::~IsolatedPlugin() {
  IsolatedPlugin::deactivate();
  static_cast<void>(end());
}

bool IsolatedPlugin::end() noexcept {
  if (condition_ != Condition::idle) {
    return false;
  }
  condition_ = Condition::given_up;
  child_->begin(ChildCall::end);
  if (!child_->process().has_ended(static_cast<int>(kFarewell_ns / kMillisecond_ns))) {
    set_fault("its process did not end within 1 s");
    return false;
  }
  child_->describe_end("its destructor", *this);
  set_fault(child_->text());
  return child_->process().ended_well();
}

void IsolatedPlugin::activate() {
  take_snapshots();
  child_->copy_in(ports_);
  if (!call(ChildCall::activate, options_.start_limit_ns)) {
    fail("activation failed");
  }
  condition_ = Condition::active;
}

void IsolatedPlugin::deactivate() noexcept {
  const bool settled = condition_ == Condition::active && settle(kFarewell_ns, tick_.now_ns);
  bool fine = take_settled();
  if (step_open_) {
    set_fault("its step did not end within 1 s: its process was ended");
    step_open_ = fine = false;
  }
  if (!fine) {
    events_.post(EventKind::error, name_, fault());  // no step comes that would tell
  }
  if (settled) {
    condition_ = Condition::idle;
    child_->copy_in(ports_);
    if (!call(ChildCall::deactivate, kFarewell_ns)) {
      events_.post(EventKind::error, name_, fault());
    }
  } else if (condition_ != Condition::idle) {
    start_.reset();
    child_.reset();
    condition_ = Condition::given_up;
  }
}

// --- Between two steps.

// A call between two steps, or at set-up. False: it failed, and fault() says why.
bool IsolatedPlugin::call(ChildCall what, std::int64_t limit_ns) noexcept {
  child_->begin(what);
  const Child::Result result = child_->finish(limit_ns, *this);
  if (result == Child::Result::pending) {
    format_into(text_, "{} in {}", child_->text(), child_->calling());
    lose(text_.data(), tick_.now_ns);
  } else if (result == Child::Result::lost) {
    lose(child_->text(), tick_.now_ns);
  } else {
    set_fault(child_->text());
  }
  return result == Child::Result::done;
}

bool IsolatedPlugin::save_state(PluginState& state) noexcept {
  state.size = state.version = 0;
  if (!require_child()) {
    return false;
  }
  if (!call(ChildCall::save_state, between_steps_limit_ns())) {
    return false;
  }
  if (!child_->take_state(state)) {
    set_fault("save_state claims more bytes than there is room for");
    return false;
  }
  return true;
}

bool IsolatedPlugin::restore_state(const PluginState& state) noexcept {
  set_fault("");
  if (state.version == 0) {
    return true;  // nothing was handed on
  }
  if (!require_child()) {
    return false;
  }
  child_->put_state(state);
  return call(ChildCall::restore_state, between_steps_limit_ns());
}

bool IsolatedPlugin::set_parameter(const char* name, const gaitway_value& value) noexcept {
  if (!require_child()) {
    return false;
  }
  if (!child_->put_parameter(name, value)) {
    set_fault("name or text is too long to be changed in a process of its own");
    return false;
  }
  return call(ChildCall::set_parameter, between_steps_limit_ns());
}

// --- Loss.

void IsolatedPlugin::lose(std::string_view what, std::int64_t now_ns) noexcept {
  if (start_) {
    child_ = start_->take_child();
    start_.reset();
  }
  if (child_) {
    child_->process().kill();
  }
  const bool ran = condition_ == Condition::active || condition_ == Condition::late;
  step_open_ = false;
  lost_ns_ = now_ns;
  restart_ns_ = now_ns + restarts_.delay_ns(now_ns, ran);
  lost_in_step_ = true;
  if (restarts_.gives_up(now_ns)) {
    condition_ = Condition::given_up;
    format_into(loss_text_, "its process was replaced {} times within {:g} s; last, {}",
                restarts_.recent(now_ns), static_cast<double>(options_.replacement_window_ns) * 1e-9, what);
  } else {
    condition_ = Condition::lost;
    format_into(loss_text_, "{}", what);
  }
  set_fault(loss_text_.data());
}

void IsolatedPlugin::restate_loss() noexcept {
  format_into(text_, "{} since {:.3f} s: {}",
              condition_ == Condition::given_up ? "out of service" : "is being replaced",
              static_cast<double>(lost_ns_) * 1e-9, std::string_view(loss_text_.data()));
  set_fault(text_.data());
}

// --- The way back.

void IsolatedPlugin::maintain(std::int64_t now_ns) noexcept {
  const bool runs = condition_ == Condition::active || condition_ == Condition::late;
  if (runs && !options_.lock_step && child_->process().has_ended()) {
    if (!step_open_ || settle(0, now_ns)) {  // what its last step gave, or how it ended
      child_->describe_end(child_->has_answered() ? "between two steps" : child_->calling(), *this);
      lose(child_->text(), now_ns);
    }
  } else if (condition_ == Condition::late && now_ns - late_ns_ > options_.hang_ns) {
    format_into(text_, "has not answered for {} ms: its process was ended",
                (now_ns - late_ns_) / kMillisecond_ns);
    lose(text_.data(), now_ns);
  }
  try {
    // Real time: a process that the kernel still keeps is not waited for.
    const bool gone = options_.lock_step || !child_ || child_->process().has_ended();
    if (condition_ == Condition::lost && now_ns >= restart_ns_ && gone) {
      restarts_.note_start(now_ns);
      condition_ = Condition::creating;
      start();
    }
    while ((condition_ == Condition::creating || condition_ == Condition::activating ||
            condition_ == Condition::restoring) &&
           advance(now_ns, options_.lock_step ? options_.start_limit_ns : kMillisecond_ns)) {
    }
  } catch (const std::exception& error) {
    lose(fmt::format("its process cannot be replaced: {}", error.what()), now_ns);
    events_.add(now_ns, tick_.tick, EventKind::error, name_, fault());
  }
}

// The next part of a start, if it comes within `wait_ns`.
bool IsolatedPlugin::advance(std::int64_t now_ns, std::int64_t wait_ns) {
  if (condition_ == Condition::creating) {
    if (!attend_start(wait_ns)) {
      return false;
    }
    begin_activation(now_ns);
    return true;
  }
  const Child::Result result = child_->finish(wait_ns, *this);
  if (result == Child::Result::pending) {
    if (process::monotonic_ns() - start_began_ns_ > options_.start_limit_ns) {
      throw PluginError("it was not activated in time");
    }
    return false;
  }
  if (result != Child::Result::done) {
    throw PluginError(std::string(child_->text()));
  }
  if (condition_ == Condition::activating && restored_) {
    child_->put_state(*state_);
    condition_ = Condition::restoring;
    child_->begin(ChildCall::restore_state);
  } else {
    come_back(now_ns);
  }
  return true;
}

void IsolatedPlugin::start() {
  child_.reset();
  declared_ports_ = 0;
  start_began_ns_ = process::monotonic_ns();
  start_.emplace(*plan_, static_cast<PluginDeclarations&>(*this));
}

bool IsolatedPlugin::attend_start(std::int64_t wait_ns) {
  switch (start_->attend(wait_ns)) {
    case ChildStart::Progress::waits:
      return false;
    case ChildStart::Progress::constructed:
      if (declared_ports_ != ports_.size()) {
        throw PluginError("opens fewer topics than when it was first started");
      }
      start_->child().attach(ports_);
      return attend_start(wait_ns);
    case ChildStart::Progress::failed:
      fail_construction(start_->text());
    case ChildStart::Progress::attached:
      library_ = start_->library();
      child_ = start_->take_child();
      start_.reset();
      return true;
  }
  return false;
}

gaitway_port* IsolatedPlugin::open_topic(const gaitway_topic& topic, gaitway_access access) {
  const std::size_t number = declared_ports_++;
  if (!restarts_.has_started_again()) {
    return ManagedPlugin::open_topic(topic, access);
  }
  const auto port = std::next(ports_.begin(), static_cast<std::ptrdiff_t>(std::min(number, ports_.size())));
  if (port == ports_.end() || port->use().topic != topic.name || port->use().type_hash != topic.type_hash ||
      port->use().size != topic.size || port->use().access != static_cast<Access>(access)) {
    throw PluginError(fmt::format("opens topic '{}', unlike when it was first started", topic.name));
  }
  return nullptr;  // the child has its own
}

// What was changed while it ran is not in the configuration: a new child gets the value in use.
gaitway_value IsolatedPlugin::declare_parameter(const gaitway_parameter& parameter) {
  if (!restarts_.has_started_again()) {
    return ManagedPlugin::declare_parameter(parameter);
  }
  const auto& known = parameters_.declared();
  const auto is_it = [&](const Parameter& other) { return other.name == parameter.name; };
  if (std::ranges::none_of(known, is_it)) {
    throw PluginError(
        fmt::format("declares parameter '{}', unlike when it was first started", parameter.name));
  }
  return parameters_.redeclare(parameter);
}

void IsolatedPlugin::begin_activation(std::int64_t now_ns) {
  const bool recent = state_->version != 0 && now_ns - state_ns_ < facts::kCycle_ns;
  restored_ = recent && !(restored_ && steps_since_start_ < kProven);
  steps_since_start_ = 0;
  child_->copy_in(ports_);
  condition_ = Condition::activating;
  child_->begin(ChildCall::activate);
}

void IsolatedPlugin::come_back(std::int64_t now_ns) {
  condition_ = Condition::active;
  restarts_.note_return(now_ns);
  events_.add(now_ns, tick_.tick, EventKind::info, name_,
              fmt::format("runs in a new process, {}, after {} ms",
                          restored_ ? "from the state of its last good step" : "started afresh",
                          (now_ns - lost_ns_) / kMillisecond_ns));
}

}  // namespace gaitway::core
