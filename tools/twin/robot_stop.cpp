// One attempt after the other, each with a connection of its own.
#include "tools/twin/robot_stop.hpp"

#include <chrono>
#include <nlohmann/json.hpp>
#include <utility>

namespace gaitway::tools {
namespace {

constexpr double kStopAnswer_s = 1.0;  // to connect, and of the answer
constexpr std::chrono::seconds kTriedFor{3};
constexpr std::chrono::milliseconds kBetween{50};

}  // namespace

RobotStop::RobotStop(const ApiAddress& address)
    : address_(address.with_timeout(kStopAnswer_s)), thread_([this] { run(); }) {}

RobotStop::~RobotStop() {
  {
    const std::lock_guard lock(mutex_);
    ending_ = true;
  }
  asked_changed_.notify_all();
  thread_.join();
}

void RobotStop::stop() {
  {
    const std::lock_guard lock(mutex_);
    is_asked_ = true;
  }
  asked_changed_.notify_all();
}

RobotStop::Answer RobotStop::answer() const {
  const std::lock_guard lock(mutex_);
  return answer_;
}

void RobotStop::run() {
  std::unique_lock lock(mutex_);
  while (true) {
    asked_changed_.wait(lock, [this] { return is_asked_ || ending_; });
    if (!std::exchange(is_asked_, false)) return;
    lock.unlock();
    std::string why = try_to_stop();
    lock.lock();
    answer_ = {answer_.number + 1, std::move(why)};
  }
}

std::string RobotStop::try_to_stop() const {
  const auto end = std::chrono::steady_clock::now() + kTriedFor;
  std::string why;
  do {
    try {
      ApiClient client(address_);
      nlohmann::json values;
      const ApiClient::ServiceAnswer told = client.call("/stop", nlohmann::json::object(), values);
      if (told.result && values.value("success", false)) return {};
      why = told.result ? values.value("message", "") : told.problem;
    } catch (const std::exception& error) {
      why = error.what();
    }
    std::this_thread::sleep_for(kBetween);
  } while (std::chrono::steady_clock::now() < end);
  return why.empty() ? "it does not say why" : why;
}

}  // namespace gaitway::tools
