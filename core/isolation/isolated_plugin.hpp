// A plug-in in a process of its own: its crash, hang or leak is a fault of one step here, and its process is
// replaced off the tick.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

#include "child.hpp"
#include "child_start.hpp"
#include "gaitway/instance/loaded_plugin.hpp"
#include "gaitway/instance/managed_plugin.hpp"
#include "gaitway/isolation/settings.hpp"

namespace gaitway::core {

class IsolatedPlugin final : public ManagedPlugin {
 public:
  // Starts the child, which loads the library and constructs the plug-in. `events` outlives it. Errors are
  // those of a LoadedPlugin, and what keeps a child from starting.
  IsolatedPlugin(const PluginEntry& entry, const PluginSource& source, const IsolationOptions& options,
                 EventLog& events);
  ~IsolatedPlugin() override;

  void activate() override;
  void deactivate() noexcept override;
  // Off the tick: replaces a child that is lost. In lock-step at the same robot time in each run, and waits
  // for it to be there.
  void maintain(std::int64_t now_ns) noexcept override;
  bool save_state(PluginState& state) noexcept override;
  bool restore_state(const PluginState& state) noexcept override;
  bool set_parameter(const char* name, const gaitway_value& value) noexcept override;
  void answer_at_once() noexcept override { answers_at_once_ = true; }
  void take_answer() noexcept override;
  [[nodiscard]] bool is_under_way() const noexcept override { return under_way_; }

  // Of one that is not active: destroys the plug-in and ends its process. False: that failed, and fault()
  // says why.
  bool end() noexcept;

  [[nodiscard]] std::string_view version() const noexcept override { return library_.version; }
  [[nodiscard]] const LibraryDescription& library() const noexcept { return library_; }
  [[nodiscard]] Recovery recovery() const noexcept override {
    switch (condition_) {
      case Condition::idle:
      case Condition::active:
        return Recovery::not_needed;
      case Condition::late:
        return still_late_ ? Recovery::awaited : Recovery::not_needed;
      case Condition::given_up:
        return Recovery::given_up;
      default:
        return lost_in_step_ ? Recovery::lost : Recovery::under_way;
    }
  }

 private:
  static constexpr std::int64_t kBetweenSteps_ns =
      10'000'000;  // real time: of a call that the tick waits for

  enum class Condition : std::uint8_t {
    idle,        // constructed
    active,      // may be stepped
    late,        // real time: the answer to a step is still to come
    lost,        // the child has ended
    creating,    // a new one constructs the plug-in
    activating,  // and is activated
    restoring,   // and takes the last state over
    given_up     // it ended too often: no new one
  };

  bool run(const Tick& tick) noexcept override;
  void begin_step(const Tick& tick) noexcept;
  bool finish_step(std::int64_t limit_ns, std::int64_t now_ns) noexcept;
  bool run_beside_tick(const Tick& tick) noexcept;
  bool settle(std::int64_t limit_ns, std::int64_t now_ns) noexcept;
  bool take_settled() noexcept override;
  void fail_step(std::int64_t now_ns) noexcept;
  bool resume_late(const Tick& tick) noexcept;

  // What a child declares, the first and each later one.
  gaitway_port* open_topic(const gaitway_topic& topic, gaitway_access access) override;
  gaitway_value declare_parameter(const gaitway_parameter& parameter) override;
  void set_period(gaitway_period period) override {
    if (restarts_.has_started_again() && period_ != static_cast<Period>(period)) {
      throw PluginError("sets its period, unlike when it was first started");
    }
    ManagedPlugin::set_period(period);
  }

  void start();
  bool attend_start(std::int64_t wait_ns);  // true: constructed and attached
  bool advance(std::int64_t now_ns, std::int64_t wait_ns);
  void begin_activation(std::int64_t now_ns);
  void come_back(std::int64_t now_ns);

  [[nodiscard]] bool require_child() noexcept {  // false: fault() says since when there is none
    if (condition_ == Condition::active || condition_ == Condition::idle) {
      return settle(between_steps_limit_ns(), tick_.now_ns);
    }
    condition_ == Condition::late ? tell_under_way() : restate_loss();
    return false;
  }
  void tell_under_way() noexcept { set_fault("its step is under way. Try again"); }
  [[nodiscard]] std::int64_t step_limit_ns() const noexcept {
    return options_.lock_step ? options_.watchdog_ns : step_budget_ns(containment_, period_ == Period::batch);
  }
  [[nodiscard]] std::int64_t between_steps_limit_ns() const noexcept {
    if (options_.lock_step) {
      return options_.watchdog_ns;
    }
    // Whoever keeps such a plug-in busy over its sockets must not have the ticks wait for it.
    return settings_.local_sockets ? step_budget_ns(containment_, period_ == Period::batch)
                                   : kBetweenSteps_ns;
  }
  bool call(ChildCall call, std::int64_t limit_ns) noexcept;
  void lose(std::string_view what, std::int64_t now_ns) noexcept;
  void restate_loss() noexcept;

  const ChildSettings settings_;
  const IsolationOptions options_;
  const ContainmentSettings containment_;
  std::optional<ChildPlan> plan_;
  LibraryDescription library_;
  std::unique_ptr<Child> child_;
  std::optional<ChildStart> start_;  // of the child that is being started
  std::size_t declared_ports_ = 0;   // by it
  Condition condition_ = Condition::creating;
  bool still_late_ = false;       // the step that the last one found late
  bool lost_in_step_ = false;     // the last one
  bool answers_at_once_ = false;  // the next step
  bool step_open_ = false;        // a step that no tick waited for: its answer is still to be taken
  bool under_way_ = false;        // the last run() had no answer to tell
  enum class Settled : std::uint8_t { none, good, bad };
  Settled settled_ = Settled::none;  // an answer that settle() took

  std::unique_ptr<PluginState> state_ = std::make_unique<PluginState>();  // of the last good step
  std::int64_t state_ns_ = 0, step_began_ns_ = 0;
  std::int64_t step_began_wall_ns_ = 0;
  std::uint32_t steps_since_start_ = 0;
  bool restored_ = false;
  RestartRule restarts_;
  std::int64_t start_began_ns_ = 0;  // by the wall clock
  std::int64_t lost_ns_ = 0, restart_ns_ = 0, late_ns_ = 0;
  std::array<char, 768> text_{}, loss_text_{}, settled_fault_{};
};

}  // namespace gaitway::core
