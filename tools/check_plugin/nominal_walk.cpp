// Stands for half a second, walks forward, sideways and turning, and stops: every topic moves.
#include "tools/check_plugin/nominal_record.hpp"

#include <stdexcept>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/plugin/cycle.hpp"
#include "gaitway/simulator/cosimulation.hpp"

namespace gaitway::plugin_check {
namespace {

constexpr std::uint32_t kTicks = 480;  // 4.8 s: 60 cycles
constexpr std::int64_t kWalk_ns = 6 * facts::kCycle_ns;
constexpr std::int64_t kStand_ns = 45 * facts::kCycle_ns;

struct Follower {  // one topic of the run
  RecordedTopic* topic;
  msgclient::UntypedReader reader;
  std::uint64_t sequence = 0;
  std::vector<std::byte> value;

  void look(std::uint32_t tick) {
    if (reader.newest_sequence() == sequence) {
      return;
    }
    if (const msgclient::ReadResult result = reader.read(value.data())) {
      sequence = result.sequence;
      topic->add(tick, value, result.stamp_ns);
    }
  }
};

std::vector<Follower> follow_all(NominalRecord& record, msgclient::Client& client) {
  for (const StandardTopic& topic : kStandardTopics) {
    if (topic.name != "plugin_statistics") {
      record.add_topic(std::string(topic.name), *topic.type);
    }
  }
  std::vector<Follower> followers;
  for (RecordedTopic& topic : record.topics()) {
    const msgclient::TopicDescriptor descriptor{topic.name, std::string(topic.type->name), topic.type->hash,
                                                topic.type->size};
    followers.push_back(
        {&topic, client.read_untyped(descriptor), 0, std::vector<std::byte>(topic.type->size)});
  }
  return followers;
}

// The message controller says nothing of joints that it does not know yet, for a slot or more. What a plug-in
// does without inputs is for the checks of values alone: here the first ones are there from the start.
void bring_forward(RecordedTopic& topic) {
  if (topic.stamp_ns.empty()) return;
  for (std::uint32_t& newest : topic.newest_at) {
    if (newest != 0) return;
    newest = 1;
  }
}

}  // namespace

NominalRecord record_nominal_walk(const std::filesystem::path& robot, const std::filesystem::path& config,
                                  const std::vector<std::filesystem::path>& plugin_path, std::uint64_t seed) {
  const urdf::RobotModel model = urdf::load_robot(robot);
  simulator::CosimulationOptions options;
  options.plant.seed = seed;
  options.main_controller.configuration = config;
  options.main_controller.plugin_path = plugin_path;
  simulator::Cosimulation run(model, options);
  NominalRecord record(kTicks);
  std::vector<Follower> followers = follow_all(record, run.client());
  for (std::uint32_t tick = 0; tick < kTicks;) {
    const std::int64_t now_ns = run.now_ns();
    if (now_ns == kWalk_ns) {
      run.apply({0.0, simulator::WalkEvent{{0.12, 0.02}, 0.1, true}});
    } else if (now_ns == kStand_ns) {
      run.apply({0.0, simulator::WalkEvent{{0.0, 0.0}, 0.0, false}});
    }
    run.advance_millisecond();
    if (core::is_tick(now_ns)) {
      for (Follower& follower : followers) {
        follower.look(tick);
      }
      ++tick;
    }
  }
  for (RecordedTopic& topic : record.topics()) {
    if (topic.name == "joint_states" || topic.name == "foot_forces" || topic.name == "imu")
      bring_forward(topic);
  }
  if (run.plant().fallen()) {
    throw std::runtime_error("the robot fell in the walk that gives the inputs");
  }
  return record;
}

}  // namespace gaitway::plugin_check
