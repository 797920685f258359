// Blocking clients, each in a thread of its own.
#include "tools/campaign/real_time/person.hpp"

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <utility>

#include "gaitway/process/real_time.hpp"

namespace gaitway::tools {
namespace {

using OrderJson = nlohmann::json;
using Clock = std::chrono::steady_clock;

constexpr double kPatience_s = 1.0;  // for an answer; then the connection is given up
constexpr std::chrono::milliseconds kBetweenRenewals{100}, kBetweenTries{50};
constexpr std::chrono::seconds kStopIsAskedFor{8};

ApiAddress address_of(const std::string& url) {
  ApiAddress address;
  address.url = url;
  return address.with_timeout(kPatience_s);
}

OrderJson twist_ahead(double speed_m_per_s) {
  return {{"linear", {{"x", speed_m_per_s}, {"y", 0.0}, {"z", 0.0}}},
          {"angular", {{"x", 0.0}, {"y", 0.0}, {"z", 0.0}}}};
}

}  // namespace

Person::Person(std::string url, double speed_m_per_s)
    : url_(std::move(url)),
      speed_m_per_s_(speed_m_per_s),
      thread_([this](const std::stop_token& end) { run(end); }) {}

void Person::connect() {
  client_ = std::make_unique<ApiClient>(address_of(url_));
  client_->advertise("/cmd_vel", "geometry_msgs/msg/Twist");
  lease_.clear();
}

void Person::renew() {
  OrderJson values;
  if (lease_.empty()) {
    const auto answer = client_->call("/command/acquire", {{"name", "gaitway campaign"}}, values);
    if (!answer.result || !values.value("success", false)) return;  // somebody has it still
    lease_ = values.value("lease", "");
  }
  if (walks_) client_->publish("/cmd_vel", twist_ahead(speed_m_per_s_));
  const auto answer = client_->call("/command/keep_alive", {{"lease", lease_}}, values);
  if (!answer.result || !values.value("success", false)) lease_.clear();
  client_->throw_reported_errors();
}

void Person::run(const std::stop_token& end) {
  while (!end.stop_requested()) {
    Clock::time_point next = Clock::now() + kBetweenRenewals;
    try {
      if (falls_silent_.exchange(false)) silent_ = std::move(client_);
      if (!client_) connect();
      renew();
    } catch (const std::exception&) {  // whatever it is: begins anew
      client_.reset();
      next = Clock::now() + kBetweenTries;
    }
    std::this_thread::sleep_until(next);
  }
}

StopAsker::StopAsker(std::string url, std::int64_t at_ns)
    : url_(std::move(url)), thread_([this, at_ns](const std::stop_token& end) { run(end, at_ns); }) {}

void StopAsker::run(const std::stop_token& end, std::int64_t at_ns) {
  std::unique_ptr<ApiClient> client;
  std::int64_t next_ns = at_ns;
  const std::int64_t until_ns = at_ns + std::chrono::nanoseconds(kStopIsAskedFor).count();
  while (!end.stop_requested() && process::monotonic_ns() < until_ns) {
    try {
      if (!client) client = std::make_unique<ApiClient>(address_of(url_));
      std::this_thread::sleep_until(Clock::time_point(std::chrono::nanoseconds(next_ns)));
      if (asked_ns_ == 0) asked_ns_ = process::monotonic_ns();
      OrderJson values;
      const auto answer = client->call("/stop", OrderJson::object(), values);
      if (answer.result && values.value("success", false)) return;
    } catch (const std::exception&) {
      client.reset();
      if (asked_ns_ == 0 && process::monotonic_ns() >= at_ns) asked_ns_ = process::monotonic_ns();
    }
    next_ns = std::max(at_ns, process::monotonic_ns() + std::chrono::nanoseconds(kBetweenTries).count());
    std::this_thread::sleep_until(Clock::time_point(std::chrono::nanoseconds(next_ns)));
  }
}

}  // namespace gaitway::tools
