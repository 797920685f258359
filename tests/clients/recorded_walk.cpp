// Records five seconds of a simulated walk as the API does: FOLDER/walk.mcap, and beside it what was
// published, a JSON object a line, in FOLDER/published.jsonl. For recording_test.py.
#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "gaitway/api/feed.hpp"
#include "gaitway/api/json_codec.hpp"
#include "gaitway/api/plan_digest.hpp"
#include "gaitway/api/recorder.hpp"
#include "gaitway/api/ros_messages.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::api {
namespace {

constexpr std::int64_t kEnd_ns = 5'000'000'000;
constexpr std::int64_t kEventPeriod_ns = 500'000'000;

// Gives everything to the recorder, and writes it down.
class Witness {
 public:
  Witness(Recorder& recorder, const std::filesystem::path& file) : recorder_(recorder), out_(file) {}

  template <class Message>
  void take(Topic topic, const Message& message, std::int64_t robot_ns) {
    recorder_.publish(topic, message, robot_ns);
    line_ = fmt::format(R"({{"topic":"{}","robot_ns":{},"msg":)", row(topic).name, robot_ns);
    append_json(line_, message);
    out_ << line_ << "}\n";
  }

 private:
  Recorder& recorder_;
  std::ofstream out_;
  std::string line_;
};

ros::Log event(std::int64_t now_ns) {
  ros::Log log;
  log.stamp = ros_time(now_ns);
  log.name = "behaviour";
  log.msg = fmt::format("half a second has passed: “{}” \\ \" µ", now_ns);
  log.line = 7;
  return log;
}

void record(const std::filesystem::path& folder, const char* robot_folder, const char* configuration,
            const char* plugins) {
  const urdf::RobotModel robot = urdf::load_robot(robot_folder);
  simulator::CosimulationOptions options;
  options.main_controller.configuration = configuration;
  options.main_controller.plugin_path = {plugins};
  simulator::Cosimulation run(robot, options);
  run.apply({0.0, simulator::WalkEvent{.velocity_m_per_s = {0.15, 0.0}}});

  PlanDigest digest(run.client());
  Feed feed(run.client(), robot);
  // More than its disk takes meanwhile: the robot's time is not the computer's.
  Recorder recorder(folder, {.waiting_bytes = 1 << 30});
  recorder.start(1, "walk", 0);
  Witness witness(recorder, folder / "published.jsonl");
  GenericSink sink([](Topic) { return true; },
                   [&witness](Topic topic, const auto& message, std::int64_t robot_ns) {
                     witness.take(topic, message, robot_ns);
                   });
  sink.publish(Topic::commander, ros::String{"nobody"}, 0);  // which the hub's owner tells
  while (run.now_ns() < kEnd_ns) {
    run.advance_millisecond();
    digest.step(run.now_ns());
    feed.poll(run.now_ns(), sink);
    recorder.step(run.now_ns());
    if (run.now_ns() % kEventPeriod_ns == 0) {
      for (const Topic topic : {Topic::events, Topic::rosout}) {
        sink.publish(topic, event(run.now_ns()), feed.robot_ns());
      }
    }
  }
  recorder.stop(2);
  for (int answers = 0; answers < 2;) {
    recorder.take_result() ? static_cast<void>(++answers) : std::this_thread::yield();
  }
}

}  // namespace
}  // namespace gaitway::api

int main(int argc, char** argv) {
  if (argc != 5) {
    fmt::print(stderr, "Usage: recorded_walk FOLDER ROBOT CONFIGURATION PLUGINS\n");
    return 2;
  }
  try {
    gaitway::api::record(argv[1], argv[2], argv[3], argv[4]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "recorded_walk: {}\n", error.what());
    return 1;
  }
  return 0;
}
