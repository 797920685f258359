// What it costs to bring a message to its subscribers: /joint_states of 22 joints, published once and taken
// by every client, without a network. Target: 200 subscribers at 100 Hz in at most half a core, sockets
// included. Also the way of a velocity command from its text to the robot.
#include <benchmark/benchmark.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/api/hub.hpp"

namespace gaitway::api {
namespace {

constexpr std::size_t kJoints = 22;

class DeafRobot final : public RobotPort {
 public:
  [[nodiscard]] std::string_view activity() const override { return "stands"; }
  std::uint64_t walks = 0;

  [[nodiscard]] std::int64_t now_ns() const override { return 0; }
  [[nodiscard]] bool connected() const override { return true; }
  [[nodiscard]] std::string_view silent_part() const override { return {}; }
  std::optional<std::uint32_t> walk(const Velocity&, std::int64_t, std::int64_t) override {
    ++walks;
    return std::nullopt;
  }
  void stand() override {}
  std::optional<std::uint32_t> stop() override { return std::nullopt; }
  std::optional<std::uint32_t> emergency_stop(bool) override { return std::nullopt; }
  std::optional<std::uint32_t> release(std::int64_t) override { return std::nullopt; }
  [[nodiscard]] bool emergency_stopped() const override { return false; }
  std::optional<std::uint32_t> move_joint(int, double, double, std::int64_t) override { return std::nullopt; }
  std::optional<std::uint32_t> play_motion(std::string_view, std::int64_t) override { return std::nullopt; }
  std::optional<std::uint32_t> walk_to(const Goal&, std::int64_t) override { return std::nullopt; }
  std::optional<std::uint32_t> leave_way(std::int64_t) override { return std::nullopt; }
  std::optional<std::uint32_t> look(const Look&, std::int64_t) override { return std::nullopt; }
  std::optional<std::uint32_t> take_command(std::int64_t) override { return std::nullopt; }
  std::optional<std::uint32_t> let_command_go(std::int64_t) override { return std::nullopt; }
  std::optional<std::uint32_t> mission(MissionVerb, std::string_view, std::int64_t) override {
    return std::nullopt;
  }
  std::optional<std::uint32_t> order(const PluginOrder&) override { return std::nullopt; }
  std::optional<OrderResult> take_result() override { return std::nullopt; }
  [[nodiscard]] const std::vector<JointLimits>& joints() const override { return joints_; }
  [[nodiscard]] std::vector<PluginStatus> plugins() const override { return {}; }
  std::uint32_t start_recording(std::string_view) override { return 1; }
  std::uint32_t stop_recording() override { return 1; }
  std::uint32_t list_recordings(std::size_t) override { return 1; }

 private:
  std::vector<JointLimits> joints_;
};

struct Client final : Connection {
  void wake() noexcept override { awake = true; }
  void shown_wrong_token() noexcept override {}
  void close(std::uint16_t, std::string_view) noexcept override {}
  std::unique_ptr<Session> session;
  bool awake = false;
};

ros::JointState joint_state() {
  ros::JointState state;
  state.header.stamp = {1234, 560'000'000};
  for (std::size_t i = 0; i < kJoints; ++i) {
    const double angle_rad = 0.1234567 * static_cast<double>(i) - 1.0;
    state.name.push_back("some_joint_" + std::to_string(i));
    state.position.push_back(angle_rad);
    state.velocity.push_back(angle_rad * 0.77);
    state.effort.push_back(angle_rad * 3.3);
  }
  return state;
}

// Argument: subscribers. Each waits for the message to be written before it is woken again.
void joint_states_to_subscribers(benchmark::State& bench, const std::string& subscribe) {
  DeafRobot robot;
  HubOptions options;
  options.limits.messages_per_s = 1e9;
  Hub hub(robot, options);
  std::int64_t now_ns = 0;
  std::vector<Client> clients(static_cast<std::size_t>(bench.range(0)));
  for (Client& client : clients) {
    client.session = hub.open(client, "client", true, now_ns);
    client.session->take(subscribe, false, now_ns);
  }
  ros::JointState state = joint_state();
  std::size_t frames = 0;
  for (auto _ : bench) {
    now_ns += 10'000'000;
    ++state.header.stamp.nanosec;
    hub.publish(Topic::joint_states, state);
    for (Client& client : clients) {
      while (client.awake) {
        const auto frame = client.session->next_frame(now_ns);
        client.awake = frame.has_value();
        frames += client.awake ? 1 : 0;
      }
    }
  }
  if (frames != static_cast<std::size_t>(bench.iterations()) * clients.size()) {
    bench.SkipWithError("not every client got every message");
  }
  bench.SetItemsProcessed(static_cast<std::int64_t>(frames));
}
BENCHMARK_CAPTURE(joint_states_to_subscribers, json, R"({"op":"subscribe","topic":"/joint_states"})")
    ->Arg(1)
    ->Arg(200);
BENCHMARK_CAPTURE(joint_states_to_subscribers, cbor,
                  R"({"op":"subscribe","topic":"/joint_states","compression":"cbor"})")
    ->Arg(200);

void step_of_idle_clients(benchmark::State& bench) {
  DeafRobot robot;
  Hub hub(robot, {});
  std::vector<Client> clients(static_cast<std::size_t>(bench.range(0)));
  for (Client& client : clients) {
    client.session = hub.open(client, "client", true, 0);
    client.session->take(R"({"op":"subscribe","topic":"/joint_states","throttle_rate":100})", false, 0);
  }
  for (auto _ : bench) {
    hub.step(0);
  }
}
BENCHMARK(step_of_idle_clients)->Arg(200);

void velocity_command(benchmark::State& bench) {
  DeafRobot robot;
  HubOptions options;
  options.limits.messages_per_s = 1e9;
  Hub hub(robot, options);
  Client client;
  client.session = hub.open(client, "client", true, 0);
  const std::string text =
      R"({"op":"publish","id":"publish:/cmd_vel:7","topic":"/cmd_vel","msg":{"linear":{"x":0.2,"y":0,"z":0},)"
      R"("angular":{"x":0,"y":0,"z":-0.4}},"latch":false})";
  for (auto _ : bench) {
    client.session->take(text, false, 0);
  }
  if (robot.walks != static_cast<std::uint64_t>(bench.iterations())) {
    bench.SkipWithError("not every command reached the robot");
  }
}
BENCHMARK(velocity_command);

}  // namespace
}  // namespace gaitway::api
