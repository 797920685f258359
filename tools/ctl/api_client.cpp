// Services, topics and their answers over one link.
#include "tools/ctl/api_client.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <nlohmann/json.hpp>
#include <thread>
#include <utility>

#include "gaitway/input/text.hpp"
#include "tools/ctl/api_link.hpp"

namespace gaitway::tools {

using json = nlohmann::json;

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kBetweenTries{100};

// The API is there, its robot is not.
constexpr std::string_view kAbsence = "the robot is not there: ";
// Of one that went away again before it was ordered.
constexpr std::string_view kPastAbsence = "the robot was not there for a while: ";

// What it says of that; empty: the robot is there.
std::string absence(const ApiClient::ServiceAnswer& answer, const json& values) {
  const std::string text = answer.result && values.is_object() ? values.value("message", "") : answer.problem;
  const bool done = answer.result && values.is_object() && values.value("success", false);
  return !done && text.starts_with(kAbsence) ? text : std::string();
}

Clock::time_point after(double time_s) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time_s));
}

}  // namespace

bool tells_of_lateness(std::string_view error) noexcept {
  return error.find("late: it may have been sent") != std::string_view::npos;
}

class ApiClient::Link : public ApiLink {
 public:
  using ApiLink::ApiLink;
  std::deque<json> waiting;  // messages of topics that came while an answer was awaited
  std::deque<std::string> problems;
};

ReturnWait::ReturnWait(double wait_s) : wait_s_(wait_s), end_(after(wait_s)) {}

bool ReturnWait::once_more(std::string_view reason) {
  if (Clock::now() >= end_) {
    return false;
  }
  if (!std::exchange(told_, true)) {
    fmt::print(stderr, "{} It is waited for, {:g} s at most\n", input::terminal_text(std::string(reason)),
               wait_s_);
  }
  std::this_thread::sleep_until(std::min(Clock::now() + kBetweenTries, end_));
  return true;
}

ApiClient::ApiClient(const ApiAddress& address)
    : address_(address), wait_(address.wait_s), timeout_s_(address.timeout_s) {
  connect();
}
void ApiClient::connect() {
  link_.reset();
  while (!link_) {
    try {
      link_ = std::make_unique<Link>(address_);
    } catch (const NobodyThere& error) {
      if (!wait_.once_more(error.what())) {
        throw;
      }
    }
  }
}
ApiClient::~ApiClient() = default;

ApiClient::ServiceAnswer ApiClient::call(const std::string& service, const json& arguments, json& values) {
  while (true) {
    ServiceAnswer answer = call_once(service, arguments, values);
    const std::string away = absence(answer, values);
    if (is_reached_ || away.empty() || !wait_.once_more(service + ": " + away + ".")) {
      is_reached_ = is_reached_ || away.empty();
      return answer;
    }
    connect();  // who has asked a robot that was away has to take the command anew
  }
}

bool ApiClient::await_return(const std::string& topic, std::string_view problem) {
  const bool away = problem.starts_with(kAbsence) || problem.starts_with(kPastAbsence);
  if (!away || !wait_.once_more(fmt::format("{}: {}.", topic, problem))) {
    return false;
  }
  connect();
  return true;
}

ApiClient::ServiceAnswer ApiClient::call_once(const std::string& service, const json& arguments,
                                              json& values) {
  const std::string id = fmt::format("call_{}", ++last_id_);
  constexpr double kForTheRobot = 0.9;  // of the time: then it says itself why it has not been done
  const ApiLink::Time deadline = link_->deadline();
  link_->write({{"op", "call_service"},
                {"id", id},
                {"service", service},
                {"args", arguments},
                {"timeout", kForTheRobot * timeout_s_}},
               deadline);
  while (const auto message = link_->read(deadline)) {
    const std::string op = message->value("op", "");
    if (op == "service_response" && message->value("id", "") == id) {
      values = message->value("values", json());
      const bool result = message->value("result", false);
      return {result, result ? "" : (values.is_string() ? values.get<std::string>() : values.dump())};
    }
    keep(*message);
  }
  if (link_->interrupted()) {
    return {false, "interrupted"};
  }
  link_->give_up();
  throw NoAnswer(fmt::format("{}: no answer within {:g} s", service, timeout_s_));
}

void ApiClient::keep(json message) {
  const std::string op = message.value("op", "");
  if (op == "publish") {
    link_->waiting.push_back(std::move(message));
  } else if (op == "status" && message.value("level", "") == "error") {
    link_->problems.push_back(message.value("msg", ""));
  }
}

void ApiClient::advertise(const std::string& topic, const std::string& type) {
  link_->write({{"op", "advertise"}, {"topic", topic}, {"type", type}}, link_->deadline());
}

void ApiClient::publish(const std::string& topic, const json& message) {
  link_->write({{"op", "publish"}, {"topic", topic}, {"msg", message}}, link_->deadline());
}

void ApiClient::subscribe(const std::string& topic, int period_ms) {
  link_->write({{"op", "subscribe"}, {"topic", topic}, {"queue_length", 1}, {"throttle_rate", period_ms}},
               link_->deadline());
}

const std::string& ApiClient::server() const noexcept {
  return link_->server();
}

std::optional<json> ApiClient::next_message() {
  const ApiLink::Time deadline = link_->deadline();
  while (link_->waiting.empty()) {
    auto message = link_->read(deadline);
    if (!message) {
      return std::nullopt;
    }
    keep(std::move(*message));
    throw_reported_errors();
  }
  json message = std::move(link_->waiting.front());
  link_->waiting.pop_front();
  return message;
}

void ApiClient::throw_reported_errors() {
  if (!link_->problems.empty()) {
    const std::string problem = link_->problems.front();
    link_->problems.clear();
    throw ApiError(problem);
  }
}

void ApiClient::rest(double seconds) {
  link_->wait(after(seconds));
  while (auto message = link_->read(Clock::now())) {
    keep(std::move(*message));
  }
}

void ApiClient::repeat(const std::function<void()>& work, double period_s, double seconds) {
  const ApiLink::Time end = after(seconds);
  link_->heed_signals(true);
  while (!link_->interrupted() && Clock::now() < end) {
    const ApiLink::Time next = std::min(after(period_s), end);
    work();
    link_->wait(next);
  }
  link_->heed_signals(false);
}

}  // namespace gaitway::tools
