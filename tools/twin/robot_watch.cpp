// One connection after the other.
#include "tools/twin/robot_watch.hpp"

#include <fmt/format.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <utility>

#include "gaitway/process/real_time.hpp"
#include "gaitway/urdf/description_text.hpp"
#include "tools/twin/compatibility.hpp"

namespace gaitway::tools {
namespace {

using nlohmann::json;

constexpr double kAnswer_s = 2.0;  // to connect, and of each answer
constexpr double kSilent_s = 3.0;  // without a word: the connection is no good
constexpr std::chrono::milliseconds kAgain{500};
constexpr std::size_t kMostPoints = 2000;

}  // namespace

double monotonic_s() {
  return static_cast<double>(process::monotonic_ns()) * 1e-9;
}

// What does not change by trying again.
class RobotWatch::Refused : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

RobotWatch::RobotWatch(const ApiAddress& address, const urdf::RobotModel& robot)
    : address_(address.with_timeout(kAnswer_s)),
      reader_(robot),
      description_(urdf::description_text(robot.directory / "robot.urdf")),
      thread_([this] { run(); }) {}

RobotWatch::~RobotWatch() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

RobotWatch::Status RobotWatch::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

std::deque<ArrivedPoint> RobotWatch::take_points() {
  const std::lock_guard lock(mutex_);
  return std::exchange(points_, {});
}

void RobotWatch::reconnect() {
  {
    const std::lock_guard lock(mutex_);
    reconnect_ = true;
  }
  changed_.notify_all();
}

bool RobotWatch::ending() const {
  const std::lock_guard lock(mutex_);
  return ending_;
}

void RobotWatch::set(State state, std::string text) {
  const std::lock_guard lock(mutex_);
  status_.state = state;
  status_.text = shortened(std::move(text));
}

bool RobotWatch::pause(State state) {
  std::unique_lock lock(mutex_);
  if (state == State::refused) {
    changed_.wait(lock, [this] { return ending_ || reconnect_; });
  } else {
    changed_.wait_for(lock, kAgain, [this] { return ending_ || reconnect_; });
  }
  reconnect_ = false;
  return !ending_;
}

void RobotWatch::run() {
  State state = State::connecting;
  do {
    try {
      watch();
      return;
    } catch (const Refused& refused) {
      state = State::refused;
      set(state, refused.what());
    } catch (const NotLetIn& refused) {
      state = State::refused;
      set(state, refused.what());
    } catch (const std::exception& error) {
      state = State::lost;
      set(state, error.what());
    }
  } while (pause(state));
}

// Returns when it is to end.
void RobotWatch::watch() {
  is_described_ = false;
  ApiClient client(address_);
  if (const std::string why = release_difference(client.server(), GAITWAY_VERSION); !why.empty()) {
    throw Refused(why);
  }
  client.subscribe("/robot_description");
  for (const RobotReader::Topic& topic : RobotReader::topics()) client.subscribe(topic.name, topic.period_ms);
  double heard_s = monotonic_s();
  while (!ending()) {
    const auto message = client.next_message();
    if (!message) {
      if (monotonic_s() - heard_s > kSilent_s) {
        throw NoAnswer(fmt::format("{}: nothing has come for {:g} s", address_.url, kSilent_s));
      }
      continue;
    }
    heard_s = monotonic_s();
    take(*message);
  }
}

void RobotWatch::take(const json& message) {
  const std::string topic = message.value("topic", "");
  if (topic == "/robot_description") {
    const std::string why =
        description_difference(message.at("msg").at("data").get<std::string>(), description_);
    if (!why.empty()) throw Refused(why);
    is_described_ = true;
    return;
  }
  const std::lock_guard lock(mutex_);
  try {
    if (auto point = reader_.take(topic, message.at("msg"), status_.news)) {
      points_.push_back({std::move(*point), monotonic_s()});
      if (points_.size() > kMostPoints) points_.pop_front();
      if (!is_described_) return;  // it may be another robot
      status_.state = State::connected;
      status_.text.clear();
    }
  } catch (const json::exception& error) {
    throw Refused(fmt::format("{}: the robot's message is not understood ({}): is it of another release?",
                              topic, error.what()));
  }
}

}  // namespace gaitway::tools
