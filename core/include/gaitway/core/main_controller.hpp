// The main controller: plug-ins, and the hand-over of what they plan to the message controller. Passive: it
// is told the time at each tick of 10 ms.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gaitway/core/events.hpp"
#include "gaitway/core/joint_plan_check.hpp"
#include "gaitway/manager/plugin_manager.hpp"
#include "gaitway/msgclient/emi_adapter.hpp"
#include "gaitway/plugin/cycle.hpp"
#include "gaitway/process/duration_histogram.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::core {

struct MainControllerOptions : PluginManagerOptions {  // the robot's directory is its model's
  std::filesystem::path configuration;                 // YAML; see configuration.hpp
  std::optional<Configuration> plugins;                // instead of reading that file
};

// What a tick did.
struct TickReport {
  bool batch = false;            // it prepared a batch
  bool handed_over = false;      // and handed it over
  bool posted = false;           // some mail lies in the window and its doorbell rang
  std::int64_t transfer_ns = 0;  // from the tick until the last of them has crossed the bus
  // What injected faults made the tick cost, on top of what it is charged anyway.
  std::int64_t declared_cost_ns = 0;
};

struct MainControllerStatistics {
  std::uint64_t ticks = 0;
  std::uint64_t batches = 0;          // ticks that prepared one
  std::uint64_t handed_over = 0;      // batches that were posted
  std::uint64_t without_plan = 0;     // batch ticks at which no plug-in had a plan for that cycle
  std::uint64_t spoiled = 0;          // batches held back since a plug-in behind them failed
  std::uint64_t refused_locally = 0;  // plans that broke a rule of joint_plan_check.hpp
  std::uint64_t refused_points = 0;   // their points that did
  std::uint64_t not_posted = 0;  // hand-overs that the window did not take: occupied, or the bus is stuck
  std::uint64_t trims_posted = 0;
  std::uint64_t trims_not_posted = 0;
  std::array<std::uint64_t, 4> answers{};     // to hand-overs: [msgclient::Verdict]
  std::uint64_t events_missed = 0;            // in the stream `events`: there were too many at once
  std::string last_refusal;                   // of here or of the message controller, for people
  process::DurationSummary batch_compute_us;  // wall time of a whole tick that prepares a batch
  std::vector<PluginTiming> plugins;          // in the order of the steps
};

class MainController {
 public:
  // Loads the configuration's plug-ins. `host` outlives it. Throws ConfigurationError, PluginError, or
  // msgclient::TopicError when a topic of its own cannot be opened.
  MainController(const urdf::RobotModel& robot, msgclient::Client& client, msgclient::EmiHost& host,
                 const MainControllerOptions& options);
  MainController(const MainController&) = delete;
  MainController& operator=(const MainController&) = delete;

  // One tick: reads answers, steps the plug-ins, posts the trims if they are new and, at a batch tick, checks
  // the newest joint plan and hands it over. For the cycle: no allocation, lock or exception.
  TickReport step(std::int64_t now_ns) noexcept;
  // Off the tick, once after each: what must not delay one. Publishes new events in the stream `events`.
  void maintain(std::int64_t now_ns) noexcept;

  [[nodiscard]] MainControllerStatistics statistics() const;
  [[nodiscard]] const PluginManager& plugins() const noexcept { return manager_; }
  // For changes while the robot walks.
  [[nodiscard]] PluginManager& plugins() noexcept { return manager_; }
  // Faults, refusals and what plug-ins report.
  [[nodiscard]] const EventLog& events() const noexcept { return manager_.events(); }

 private:
  void take_answers(const Tick& tick) noexcept;
  void post_trim(const Tick& tick, TickReport& report) noexcept;
  enum class HandOverOutcome : std::uint8_t {
    posted,
    nothing,    // no plug-in has a plan for that cycle
    unusable,   // a plug-in behind the plan failed, or the plan breaks a rule
    not_taken,  // by the EMI
  };
  void prepare_batch(const Tick& tick, TickReport& report) noexcept;
  HandOverOutcome hand_over(const Tick& tick, TickReport& report) noexcept;
  HandOverOutcome post(const Tick& tick, TickReport& report) noexcept;
  [[nodiscard]] bool plan_is_usable(const Tick& tick) noexcept;
  // Where the joints' references are when the batch begins; empty: not known.
  [[nodiscard]] std::span<const double> start_reference(const Tick& tick) noexcept;
  void note_network(const Tick& tick) noexcept;
  void note_commander(const Tick& tick) noexcept;
  void note_refusal(const Tick& tick, std::string_view text) noexcept;

  JointPlanCheck check_;
  msgclient::EmiHost& host_;
  WallClock wall_clock_;
  EventPublisher event_publisher_;  // before the plug-ins come: none of them writes its stream
  PluginManager manager_;
  msgclient::Reader<JointPlan> joint_plan_reader_;
  msgclient::Reader<TrimCommand> trim_reader_;
  msgclient::Reader<JointStates> joint_states_reader_;
  msgclient::Reader<NetworkState> network_state_reader_;
  msgclient::Reader<NetworkHealth> network_health_reader_;
  msgclient::Reader<CommandState> command_reader_;
  std::uint64_t command_seen_ = 0;
  std::uint32_t commander_changes_ = 0;  // that were told
  std::size_t crossing_bytes_ = 0;       // of the topics that are read over the EMI in each tick

  // Large values: kept off the stack.
  std::unique_ptr<JointPlan> plan_ = std::make_unique<JointPlan>();
  bool had_plan_ = false;  // a good one, for the batch before
  std::unique_ptr<msgclient::HandOver> posted_ = std::make_unique<msgclient::HandOver>();  // sequence 0: none
  std::unique_ptr<msgclient::HandOver> accepted_ =
      std::make_unique<msgclient::HandOver>();  // sequence 0: none
  TrimCommand trim_{};
  std::uint64_t trim_sequence_ = 0;
  JointStates joint_states_{};
  NetworkState network_state_{};
  NetworkHealth network_health_{};
  NetworkEvents network_events_;
  SilenceEvents silence_events_;
  std::array<double, kMaxJoints> start_rad_{};

  MainControllerStatistics counts_;  // its texts and summaries stay empty: statistics() fills them in
  std::array<char, 256> last_refusal_{};
  const ManagedPlugin* spoiler_ = nullptr;  // of the batch with that sequence
  std::uint32_t spoiled_sequence_ = 0;
  process::DurationHistogram batch_wall_;
};

}  // namespace gaitway::core
