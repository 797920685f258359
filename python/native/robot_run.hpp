// One simulated robot that an interpreter holds: the co-simulation with its digest, the journal of all that
// was asked of it, its events, and its topics for readers and writers outside. Knows nothing of Python.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/simulator/run_digest.hpp"
#include "robot_setup.hpp"
#include "topic_view.hpp"

namespace gaitway::python {

struct ToldEvent {
  double time_s = 0.0;
  std::string kind, source, text;
};

// What came from outside, and before which millisecond.
struct TopicValue {
  std::size_t topic = 0;  // index in kStandardTopics
  std::int64_t stamp_ns = 0;
  std::vector<std::byte> bytes;
};
struct JournalEntry {
  std::int64_t at_ns = 0;
  std::variant<simulator::ScenarioEvent, TopicValue> what;
};

// From which a run is made again to the bit: its seed and all that came from outside.
struct Snapshot {
  std::shared_ptr<const RobotSetup> setup;
  std::uint64_t seed = 0;
  std::int64_t now_ns = 0;
  std::uint64_t digest = 0;
  std::vector<JournalEntry> journal;
};

// Base position and roll, pitch, yaw; CoM; centre of pressure; all in the world: truth, for rewards and
// reports.
struct Whereabouts {
  std::array<double, 3> base_m{}, base_rpy_rad{}, com_m{}, cop_m{};
  double tilt_rad = 0.0;  // of the trunk against the vertical
};

// Called now and then while a run goes on, between two of its milliseconds. What it throws ends the call: the
// run is whole, and stands where it had come to.
using Pause = std::function<void()>;

// For one thread at a time.
class RobotRun final : public simulator::CosimulationObserver {
 public:
  // Throws what RobotSetup and Cosimulation throw.
  RobotRun(std::shared_ptr<const RobotSetup> setup, std::uint64_t seed);
  ~RobotRun() override;

  void advance(std::int64_t milliseconds, const Pause& pause);
  // Everything from the beginning, with another seed.
  void restart(std::uint64_t seed);
  [[nodiscard]] Snapshot snapshot() const;
  // Simulates from the snapshot's seed to its time. Throws std::runtime_error where the run comes out
  // otherwise, std::invalid_argument for the snapshot of another robot.
  void restore(const Snapshot& snapshot, const Pause& pause);

  // A scenario's action, in the millisecond that comes next. Throws input::InputError.
  void apply(const std::string& action);
  // `value`: as many bytes as the topic's type has. Throws std::invalid_argument for a number that is not
  // finite or beyond its limits, msgclient::TopicError where somebody else writes the topic.
  void write(std::size_t topic, std::span<const std::byte> value);

  // Sequence of the newest value, 0: none has been published.
  [[nodiscard]] std::uint64_t sequence(std::size_t topic);
  // Copies the newest value; its sequence, 0: none, and `value` is as it was.
  std::uint64_t read(std::size_t topic, std::span<std::byte> value);
  [[nodiscard]] std::int64_t stamp_ns(std::size_t topic);
  // Who writes a topic at the moment; empty: nobody.
  [[nodiscard]] std::string writer_of(const std::string& topic) const;
  // Memory with the newest value, which lives as long as somebody holds it.
  [[nodiscard]] std::shared_ptr<TopicView> view(std::size_t topic);
  // Brings all views up to date: empty where nothing has been published since the beginning. Whoever reads
  // them must not do so meanwhile; nothing else changes them.
  void refresh_views();

  [[nodiscard]] std::int64_t now_ns() const noexcept { return cosimulation_->now_ns(); }
  // Not, when restart() or restore() has thrown: then nothing else may be called.
  [[nodiscard]] bool is_whole() const noexcept { return cosimulation_.has_value(); }
  [[nodiscard]] std::uint64_t seed() const noexcept { return seed_; }
  [[nodiscard]] std::uint64_t digest() const noexcept { return digest_.value(); }
  [[nodiscard]] bool fallen() const noexcept { return cosimulation_->plant().fallen(); }
  [[nodiscard]] Whereabouts whereabouts() const;
  [[nodiscard]] const std::deque<ToldEvent>& events() const noexcept { return events_; }
  [[nodiscard]] std::uint64_t events_lost() const noexcept { return events_lost_; }
  [[nodiscard]] const simulator::Cosimulation& cosimulation() const noexcept { return *cosimulation_; }
  [[nodiscard]] const RobotSetup& setup() const noexcept { return *setup_; }

  void on_frame(const can::SimulatedBus::Delivery& delivery) override;
  void on_millisecond(std::int64_t now_ns) override;

 private:
  void begin();
  void give_up() noexcept;
  void do_again(const JournalEntry& entry);
  void apply(const simulator::ScenarioEvent& event);
  void publish(const TopicValue& value);
  msgclient::UntypedReader& reader(std::size_t topic);
  msgclient::UntypedWriter& writer(std::size_t topic);
  void take_events();

  std::shared_ptr<const RobotSetup> setup_;
  std::uint64_t seed_;
  std::optional<msgclient::MemoryBlock> block_;
  std::optional<msgclient::Client> client_;
  std::vector<std::optional<msgclient::UntypedReader>> readers_;  // [index in kStandardTopics]
  std::vector<std::optional<msgclient::UntypedWriter>> writers_;
  std::vector<std::shared_ptr<TopicView>> views_;
  std::optional<simulator::Cosimulation> cosimulation_;
  simulator::RunDigest digest_;
  std::vector<JournalEntry> journal_;
  std::deque<ToldEvent> events_;
  std::uint64_t runs_ = 0;  // begun so far
  std::uint64_t events_lost_ = 0, events_taken_ = 0, event_log_ = 0;
  bool loads_while_it_runs_ = false;  // a controller that is to be started again loads its plug-ins then
};

}  // namespace gaitway::python
