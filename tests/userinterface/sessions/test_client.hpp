// A client on a connection without a network, and the hub that it talks to.
#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gaitway/api/hub.hpp"
#include "gaitway/facts/facts.hpp"
#include "recorded_robot.hpp"
#include "recorded_simulation.hpp"

namespace gaitway::api {

using nlohmann::json;

using facts::kMillisecond_ns;
using facts::kSecond_ns;

class TestClient final : public Connection {
 public:
  TestClient(Hub& hub, const std::int64_t& now_ns, std::string peer, bool authorised = true)
      : now_ns_(now_ns), session_(hub.open(*this, std::move(peer), authorised, now_ns)) {}

  void wake() noexcept override { ++wakes; }
  void close(std::uint16_t code, std::string_view reason) noexcept override {
    closed = {code, std::string(reason)};
  }

  void shown_wrong_token() noexcept override { ++wrong_tokens; }

  [[nodiscard]] std::int64_t message_age_ns(std::int64_t /*wall_ns*/) const noexcept override {
    return age_ns;
  }
  std::int64_t age_ns = 0;  // of what it sends

  void send(const json& message) { send_text(message.dump()); }
  void send_text(std::string_view message, bool binary = false) { session_->take(message, binary, now_ns_); }
  // After a stop that came later.
  void send_overtaken(const json& message) { session_->take_overtaken(message.dump(), false, now_ns_); }
  [[nodiscard]] Urgency urgency(std::string_view message, bool binary = false) const {
    return session_->urgency(message, binary);
  }
  void disconnect() { session_.reset(); }
  [[nodiscard]] bool is_open() const { return session_ != nullptr; }

  std::optional<Frame> next_frame() { return session_->next_frame(now_ns_); }
  // All that waits, decoded.
  std::vector<json> receive() {
    std::vector<json> messages;
    while (const auto frame = next_frame()) {
      messages.push_back(frame->binary
                             ? json::from_cbor(*frame->bytes, true, true, json::cbor_tag_handler_t::ignore)
                             : json::parse(*frame->bytes));
    }
    return messages;
  }
  // The only message that waits; null and a failure when there are none or more.
  json receive_one() {
    const auto messages = receive();
    EXPECT_EQ(messages.size(), 1U) << json(messages).dump();
    return messages.size() == 1 ? messages.front() : json();
  }
  // What the robot answers to a message that it refuses.
  std::string refusal_of(const json& message) { return refusal_of_text(message.dump()); }
  std::string refusal_of_text(std::string_view message, bool binary = false) {
    send_text(message, binary);
    const json status = receive_one();
    EXPECT_EQ(status.value("op", ""), "status") << status.dump();
    EXPECT_EQ(status.value("level", ""), "error") << status.dump();
    return status.value("msg", "");
  }
  // The service_response.
  json call(std::string_view service, const json& arguments = json::object()) {
    send({{"op", "call_service"}, {"id", "c"}, {"service", service}, {"args", arguments}});
    const json response = receive_one();
    EXPECT_EQ(response.value("op", ""), "service_response") << response.dump();
    EXPECT_EQ(response.value("id", ""), "c");
    return response;
  }
  void drive(double forward_m_per_s, double turn_rad_per_s = 0.0) {
    send({{"op", "publish"},
          {"topic", "/cmd_vel"},
          {"msg", {{"linear", {{"x", forward_m_per_s}}}, {"angular", {{"z", turn_rad_per_s}}}}}});
  }
  void subscribe(std::string_view topic, json terms = json::object()) {
    terms["op"] = "subscribe";
    terms["topic"] = topic;
    send(terms);
  }

  int wakes = 0;
  int wrong_tokens = 0;
  std::optional<std::pair<std::uint16_t, std::string>> closed;

 private:
  const std::int64_t& now_ns_;
  std::unique_ptr<Session> session_;
};

// A hub with its robot and clock.
class HubTest : public testing::Test {
 protected:
  explicit HubTest(HubOptions options = {}, bool simulated = true)
      : hub(robot,
            with(std::move(options), simulated ? SimulationPorts{&simulation, &twin} : SimulationPorts{})) {}

  std::unique_ptr<TestClient> connect(std::string peer, bool authorised = true) {
    return std::make_unique<TestClient>(hub, now_ns, std::move(peer), authorised);
  }
  // Time passes in steps of 10 ms.
  void pass(std::int64_t duration_ns) {
    for (const std::int64_t end_ns = now_ns + duration_ns; now_ns < end_ns;) {
      now_ns += 10 * kMillisecond_ns;
      hub.step(now_ns);
    }
  }
  void step() { hub.step(now_ns); }

  std::int64_t now_ns = 1000 * kSecond_ns;
  RecordedRobot robot;
  RecordedSimulation simulation, twin;
  Hub hub;

 private:
  static HubOptions with(HubOptions options, const SimulationPorts& ports) {
    options.simulation = ports;
    return options;
  }
};

}  // namespace gaitway::api
