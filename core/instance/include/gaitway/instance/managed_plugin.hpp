// A plug-in as its manager sees it, wherever it runs: its topics, its life, and its step, of which nothing is
// published unless all went well.
#pragma once

#include <array>
#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <string_view>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/instance/event_log.hpp"
#include "gaitway/instance/parameter_set.hpp"
#include "gaitway/instance/plugin_instance.hpp"
#include "gaitway/instance/topic_port.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/plugin/cycle.hpp"

namespace gaitway::core {

// Bytes that one version of a plug-in hands on to the next, in fixed memory.
struct PluginState {
  static constexpr std::size_t kCapacity = std::size_t{64} * 1024;
  std::array<std::byte, kCapacity> bytes{};
  std::uint32_t size = 0;
  std::uint32_t version = 0;  // 0: nothing is handed on
};

// What a plug-in does about its own last fault.
enum class Recovery : std::uint8_t {
  not_needed,
  awaited,    // the step that was late before is still not done
  lost,       // its process ended in this step
  under_way,  // and is being replaced
  given_up    // it was replaced too often
};

// Stays where it is: the plug-in holds pointers into it. What may throw throws PluginError
// (ConfigurationError for a parameter), with the plug-in's name and place.
class ManagedPlugin : protected PluginDeclarations {
 public:
  virtual ~ManagedPlugin() = default;
  ManagedPlugin(const ManagedPlugin&) = delete;
  ManagedPlugin& operator=(const ManagedPlugin&) = delete;

  // Opens the topics; of a successor all but the outputs that `predecessor` has, too.
  void bind(msgclient::Client& client, const ManagedPlugin* predecessor = nullptr);
  // Opens the inputs alone: of a plug-in that publishes nothing.
  void bind_inputs(msgclient::Client& client);
  // Moves those outputs over, here or back. For the cycle.
  void take_outputs(ManagedPlugin& predecessor) noexcept;

  virtual void activate() = 0;
  virtual void deactivate() noexcept = 0;
  // Off the tick, once after each: what can wait until then, such as a process that is to be started again.
  virtual void maintain(std::int64_t /*now_ns*/) noexcept {}

  [[nodiscard]] virtual Recovery recovery() const noexcept { return Recovery::not_needed; }

  // For the cycle.
  [[nodiscard]] bool is_due(const Tick& tick) const noexcept {
    return period_ == Period::batch ? tick.batch : tick.tick % schedule_.every_ticks == schedule_.phase_ticks;
  }
  void take_snapshots() noexcept;
  // Runs one step and checks what it staged; then commit() or discard(). False: a fault, and fault() says
  // why. `offset`, if not 0, is put onto the first number of each field of the outputs: an injected fault.
  bool prepare(const Tick& tick, double offset = 0.0) noexcept;
  void commit() noexcept;  // publishes what was staged
  void discard() noexcept;
  // Of one whose answer comes with the next step. Its next step answers in its own tick: for a trial.
  virtual void answer_at_once() noexcept {}
  // The last prepare() had no answer to tell: it says nothing of the plug-in, for better or worse.
  [[nodiscard]] virtual bool is_under_way() const noexcept { return false; }
  // Before it is replaced or removed: takes the answer of such a step, and once it is sure that it goes,
  // publishes what that gave. False: it was a fault, and fault() says why.
  virtual void take_answer() noexcept {}
  bool hand_in(const Tick& tick) noexcept;
  [[nodiscard]] std::string_view fault() const noexcept { return error_text_.data(); }
  void set_fault(std::string_view text) noexcept;
  // In the plug-in's place, through its own output: one writer a topic. False: it is none of its outputs.
  template <class T>
  bool publish_in_place(std::string_view topic, const T& value, std::int64_t stamp_ns) noexcept {
    return publish_in_place(topic, TopicType<T>::hash, &value, stamp_ns);
  }
  // The oldest value of a periodic topic that it read in its last step.
  [[nodiscard]] std::int64_t take_input_age_ns() noexcept;
  // Between two steps. False: refused or failed, and fault() says why.
  virtual bool save_state(PluginState& state) noexcept = 0;
  virtual bool restore_state(const PluginState& state) noexcept = 0;
  virtual bool set_parameter(const char* name, const gaitway_value& value) noexcept = 0;

  [[nodiscard]] const std::string& name() const noexcept { return name_; }
  [[nodiscard]] const std::string& place() const noexcept { return place_; }
  [[nodiscard]] const ParameterSet& parameters() const noexcept { return parameters_; }
  [[nodiscard]] ParameterSet& parameters() noexcept { return parameters_; }
  [[nodiscard]] Period period() const noexcept { return period_; }
  [[nodiscard]] virtual std::string_view version() const noexcept = 0;
  [[nodiscard]] DataFlowNode node() const;
  // Throws PluginError if the configuration gives a period to a plug-in that is stepped every batch.
  void check_schedule() const;
  [[nodiscard]] bool uses(std::string_view topic, Access access) const noexcept;

 protected:
  ManagedPlugin(const PluginEntry& entry, const std::filesystem::path& configuration_file, EventLog& events,
                const std::filesystem::path& robot_directory = {});

  // Runs one step of the plug-in's own code, which stages its outputs in the ports. False: error_text_ says
  // why.
  virtual bool run(const Tick& tick) noexcept = 0;
  // The answer that take_answer() or another call between two steps took before the step that would have told
  // it. False: error_text_ says why.
  virtual bool take_settled() noexcept { return true; }

  // Appends a port, which is also the answer.
  gaitway_port* open_topic(const gaitway_topic& topic, gaitway_access access) override;
  gaitway_value declare_parameter(const gaitway_parameter& parameter) override;
  void set_period(gaitway_period period) override { period_ = static_cast<Period>(period); }
  void report(gaitway_severity severity, std::string_view text) noexcept override;
  // With what its constructor says: throws ConfigurationError if it is a parameter's error, else PluginError.
  [[noreturn]] void fail_construction(std::string_view text) const;
  [[nodiscard]] gaitway_text error_text() noexcept;
  [[noreturn]] void fail(std::string_view what);

  std::string name_;
  std::string place_;  // "plug-in 'x' (walk.yaml:4)"
  ParameterSet parameters_;
  EventLog& events_;
  std::list<TopicPort> ports_;  // stable addresses: the plug-in holds them
  Period period_ = Period::tick;
  const StepSchedule schedule_;
  Tick tick_;

 private:
  template <class Wanted>
  void bind_ports(msgclient::Client& client, const Wanted& wanted);
  bool check_outputs() noexcept;
  bool publish_in_place(std::string_view topic, std::uint64_t type_hash, const void* value,
                        std::int64_t stamp_ns) noexcept;

  std::unique_ptr<ConfigurationError> parameter_error_;  // says more than what came back through the plug-in
  std::array<char, 1024> error_text_{};
};

}  // namespace gaitway::core
