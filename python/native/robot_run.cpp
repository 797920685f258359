// Lets the co-simulation run, and notes what comes from outside so that it can be done again.
#include "robot_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::python {
namespace {

using facts::kMillisecond_ns;
constexpr std::size_t kMostEvents = 10'000;
// How often a run pauses, and takes events, of which far fewer come meanwhile than the log holds.
constexpr std::int64_t kPause_ns = 80 * kMillisecond_ns;

msgclient::TopicDescriptor descriptor_of(std::size_t topic) {
  const StandardTopic& standard = kStandardTopics.at(topic);
  return {.name = std::string(standard.name),
          .type_name = std::string(standard.type->name),
          .type_hash = standard.type->hash,
          .size = standard.type->size};
}

bool restarts_controller(const simulator::ScenarioEvent& event) {
  const auto* const silent = std::get_if<simulator::MessageControllerSilentFault>(&event.action);
  return silent != nullptr && silent->restarts;
}

}  // namespace

RobotRun::RobotRun(std::shared_ptr<const RobotSetup> setup, std::uint64_t seed)
    : setup_(std::move(setup)), seed_(seed) {
  begin();
}

RobotRun::~RobotRun() {
  give_up();
}

// Topics that are written from outside are claimed before the plug-ins come, which ask who writes them.
void RobotRun::begin() {
  const std::scoped_lock lock(loading_lock());
  block_.emplace();
  client_.emplace(block_->local_client("python"));
  readers_.resize(kStandardTopics.size());
  writers_.resize(kStandardTopics.size());
  for (std::size_t topic = 0; topic < kStandardTopics.size(); ++topic) {
    if (std::ranges::find(setup_->writes(), kStandardTopics[topic].name) != setup_->writes().end()) {
      writer(topic);
    }
  }
  cosimulation_.emplace(setup_->robot(), setup_->options(seed_, *block_));
  cosimulation_->observe(this);
  ++runs_;
}

void RobotRun::give_up() noexcept {
  const std::scoped_lock lock(loading_lock());
  cosimulation_.reset();
  readers_.clear();
  writers_.clear();
  client_.reset();
  block_.reset();
  digest_ = {};
  journal_.clear();
  events_.clear();
  events_lost_ = events_taken_ = event_log_ = 0;
  loads_while_it_runs_ = false;
}

void RobotRun::restart(std::uint64_t seed) {
  give_up();
  seed_ = seed;
  std::erase_if(views_, [](const auto& view) { return view.use_count() == 1; });
  begin();
}

void RobotRun::advance(std::int64_t milliseconds, const Pause& pause) {
  for (; milliseconds > 0; --milliseconds) {
    if (loads_while_it_runs_) {
      const std::scoped_lock lock(loading_lock());
      cosimulation_->advance_millisecond();
    } else {
      cosimulation_->advance_millisecond();
    }
    if (now_ns() % kPause_ns == 0) {
      take_events();
      pause();
    }
  }
  take_events();
}

Snapshot RobotRun::snapshot() const {
  return {setup_, seed_, now_ns(), digest(), journal_};
}

void RobotRun::restore(const Snapshot& snapshot, const Pause& pause) {
  if (snapshot.setup != setup_) {
    throw std::invalid_argument("this snapshot is of a robot that was made otherwise. Restore it there");
  }
  const std::vector<JournalEntry> journal = snapshot.journal;  // it may be of this run
  restart(snapshot.seed);
  for (const JournalEntry& entry : journal) {
    advance((entry.at_ns - now_ns()) / kMillisecond_ns, pause);
    do_again(entry);
  }
  advance((snapshot.now_ns - now_ns()) / kMillisecond_ns, pause);
  if (digest() != snapshot.digest) {
    throw std::runtime_error(
        fmt::format("the run came out otherwise when it was made again (digest {:016x} instead of {:016x}): "
                    "some plug-in does not depend on its inputs alone",
                    digest(), snapshot.digest));
  }
}

void RobotRun::do_again(const JournalEntry& entry) {
  if (const auto* const event = std::get_if<simulator::ScenarioEvent>(&entry.what)) {
    apply(*event);
  } else {
    publish(std::get<TopicValue>(entry.what));
  }
}

void RobotRun::apply(const std::string& action) {
  apply(simulator::parse_action(action, "action", setup_->robot()));
}

void RobotRun::apply(const simulator::ScenarioEvent& event) {
  cosimulation_->apply(event);
  loads_while_it_runs_ = loads_while_it_runs_ || restarts_controller(event);
  journal_.push_back({now_ns(), event});
}

void RobotRun::write(std::size_t topic, std::span<const std::byte> value) {
  check_value(kStandardTopics.at(topic), value);
  publish({topic, now_ns(), std::vector<std::byte>(value.begin(), value.end())});
}

void RobotRun::publish(const TopicValue& value) {
  writer(value.topic).publish(value.bytes.data(), value.stamp_ns);
  journal_.push_back({now_ns(), value});
}

msgclient::UntypedReader& RobotRun::reader(std::size_t topic) {
  std::optional<msgclient::UntypedReader>& reader = readers_.at(topic);
  if (!reader) reader.emplace(client_->read_untyped(descriptor_of(topic)));
  return *reader;
}

msgclient::UntypedWriter& RobotRun::writer(std::size_t topic) {
  std::optional<msgclient::UntypedWriter>& writer = writers_.at(topic);
  if (!writer) writer.emplace(client_->write_untyped(descriptor_of(topic)));
  return *writer;
}

std::uint64_t RobotRun::sequence(std::size_t topic) {
  return reader(topic).newest_sequence();
}

std::uint64_t RobotRun::read(std::size_t topic, std::span<std::byte> value) {
  return reader(topic).read(value.data()).sequence;
}

std::int64_t RobotRun::stamp_ns(std::size_t topic) {
  std::vector<std::byte> value(kStandardTopics.at(topic).type->size);
  const msgclient::ReadResult read = reader(topic).read(value.data());
  return read ? read.stamp_ns : -1;
}

std::string RobotRun::writer_of(const std::string& topic) const {
  const std::optional<msgclient::TopicInfo> info = client_->find(topic);
  return info ? info->writer : std::string();
}

std::shared_ptr<TopicView> RobotRun::view(std::size_t topic) {
  const auto known = std::ranges::find_if(views_, [topic](const auto& one) { return one->topic() == topic; });
  if (known != views_.end()) return *known;
  views_.push_back(std::make_shared<TopicView>(topic, kStandardTopics.at(topic).type->size));
  refresh_views();
  return views_.back();
}

void RobotRun::refresh_views() {
  for (const auto& view : views_) {
    const std::uint64_t newest = sequence(view->topic());
    if (view->run == runs_ && view->sequence == newest) continue;
    if (newest == 0) std::ranges::fill(view->value(), std::byte{});
    view->sequence = newest == 0 ? 0 : read(view->topic(), view->value());
    view->run = runs_;
  }
}

Whereabouts RobotRun::whereabouts() const {
  const simulator::PlantTruth truth = cosimulation_->plant().truth();
  const Eigen::Matrix3d rotation = truth.base.linear();
  Whereabouts where;
  Eigen::Map<Eigen::Vector3d>(where.base_m.data()) = truth.base.translation();
  where.base_rpy_rad = {std::atan2(rotation(2, 1), rotation(2, 2)),
                        std::asin(std::clamp(-rotation(2, 0), -1.0, 1.0)),
                        std::atan2(rotation(1, 0), rotation(0, 0))};
  Eigen::Map<Eigen::Vector3d>(where.com_m.data()) = truth.com_m;
  Eigen::Map<Eigen::Vector3d>(where.cop_m.data()) = truth.cop_m;
  where.tilt_rad = truth.trunk_tilt_rad;
  return where;
}

void RobotRun::on_frame(const can::SimulatedBus::Delivery& delivery) {
  digest_.add(delivery.frame, delivery.start_ns);
}

void RobotRun::on_millisecond(std::int64_t) {
  digest_.add(cosimulation_->plant().positions());
  digest_.add(cosimulation_->plant().velocities());
}

// A main controller that was started again has a log of its own.
void RobotRun::take_events() {
  const core::EventLog& log = cosimulation_->main_controller().events();
  if (log.serial() != event_log_) {
    event_log_ = log.serial();
    events_taken_ = 0;
  }
  events_lost_ += log.first() > events_taken_ ? log.first() - events_taken_ : 0;
  for (events_taken_ = std::max(events_taken_, log.first()); events_taken_ < log.total(); ++events_taken_) {
    const core::Event& event = log[events_taken_];
    events_.push_back({static_cast<double>(event.stamp_ns) * 1e-9,
                       std::string(core::event_kind_name(event.kind)), std::string(event.source()),
                       std::string(event.text())});
    if (events_.size() > kMostEvents) {
      events_.pop_front();
      ++events_lost_;
    }
  }
}

}  // namespace gaitway::python
