// A plug-in in a process of its own: its crash, hang or leak is a fault of one step here, and its process is
// replaced off the tick.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/isolation/settings.hpp"
#include "gaitway/manager/loaded_plugin.hpp"
#include "gaitway/manager/managed_plugin.hpp"

namespace gaitway::core {

class ChildLink;
enum class ChildCall : std::uint32_t;

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

  [[nodiscard]] std::string_view version() const noexcept override { return version_; }
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
  // Construction, the first and each later one.
  void start();
  bool attend_start(std::int64_t wait_ns);  // true: constructed and attached
  bool take_message();
  void take_topic(class PacketReader& packet);
  void take_parameter(class PacketReader& packet);
  template <class Function>
  void grant(const Function& function);
  void attach();
  bool advance(std::int64_t now_ns, std::int64_t wait_ns);
  void begin_activation(std::int64_t now_ns);
  void restore();
  void reapply_parameters();
  void come_back(std::int64_t now_ns);

  // Calls over the segment.
  void copy_inputs() noexcept;
  void begin(ChildCall call) noexcept;
  [[nodiscard]] std::int64_t between_steps_limit_ns() const noexcept;
  enum class Outcome : std::uint8_t { answered, pending, ended };
  Outcome await(std::int64_t limit_ns) noexcept;
  bool take_reply() noexcept;  // false: the segment holds what no child writes
  bool call(ChildCall call, std::int64_t limit_ns) noexcept;
  bool finish_step(const Tick& tick) noexcept;
  void take_reports() noexcept;
  void keep_state(const Tick& tick) noexcept;
  bool resume_late(const Tick& tick) noexcept;
  void describe_end(ChildCall during) noexcept;
  void lose(std::string_view what, std::int64_t now_ns) noexcept;
  [[nodiscard]] std::int64_t restart_delay_ns(std::int64_t now_ns) noexcept;
  [[nodiscard]] std::uint64_t recent_replacements(std::int64_t now_ns) const noexcept;
  void restate_loss() noexcept;

  const ChildSettings settings_;
  const IsolationOptions options_;
  const ContainmentSettings containment_;
  std::string library_, base_, robot_directory_, memory_socket_, host_binary_, version_;
  SearchPath search_path_;
  std::unique_ptr<ChildLink> link_;
  std::vector<gaitway_sample> samples_;  // of the ports, as the child has them
  std::unique_ptr<ConfigurationError> parameter_error_;
  std::vector<std::pair<std::string, std::string>> live_values_;  // of the child before
  Condition condition_ = Condition::creating;
  std::size_t declared_ports_ = 0;  // by the child that is being started
  std::int64_t start_began_ns_ = 0;
  std::int32_t status_ = 0;    // of the last reply
  bool still_late_ = false;    // the step that the last one found late
  bool lost_in_step_ = false;  // the last one

  std::unique_ptr<PluginState> state_ = std::make_unique<PluginState>();  // of the last good step
  std::int64_t state_ns_ = 0;
  std::int64_t lost_ns_ = 0, restart_ns_ = 0, late_ns_ = 0;
  std::uint32_t steps_since_start_ = 0;
  std::array<std::int64_t, 8> replaced_ns_{};  // ring of the last ones
  std::uint64_t replaced_ = 0;
  std::int64_t came_back_ns_ = 0;      // the child that runs
  std::uint32_t losses_in_a_row_ = 0;  // that came soon after the one before
  bool restored_ = false;
  std::array<char, 512> loss_text_{};
};

}  // namespace gaitway::core
