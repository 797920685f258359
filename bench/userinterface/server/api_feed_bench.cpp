// Cost of the feed's poll: with nothing new, and in each slot of 10 ms with everything new and wanted, by
// nobody's encoder, by CDR, and by a recording.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "gaitway/api/cdr_codec.hpp"
#include "gaitway/api/feed.hpp"
#include "gaitway/api/plan_digest.hpp"
#include "gaitway/api/recorder.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/memory_block.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::api {
namespace {

using facts::kSlot_ns;
constexpr int kSlotsPerPlan = facts::kSlotsPerCycle;

const urdf::RobotModel& humanoid() {
  static const urdf::RobotModel robot =
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
  return robot;
}

// Publishes what a walking robot's topics hold: every slot the sensors and the estimate, every eighth a plan.
class Robot {
 public:
  explicit Robot(msgclient::MemoryBlock& block) : block_(block), client_(block.local_client("robot")) {
    for (std::size_t i = 0; i < humanoid().joints.size(); ++i) {
      joints_.position[i] = humanoid().joints[i].home_rad;
    }
    plan_->footstep_count = 4;
  }
  void slot() {
    now_ns_ += kSlot_ns;
    block_.beat(now_ns_);
    joints_.stamp_ns = forces_.stamp_ns = imu_.stamp_ns = estimate_.stamp_ns = now_ns_ + 3'000'000;
    joints_.position[3] += 1e-5;
    joints_writer_.publish(joints_, now_ns_);
    forces_writer_.publish(forces_, now_ns_);
    imu_writer_.publish(imu_, now_ns_);
    estimate_writer_.publish(estimate_, now_ns_);
    if (now_ns_ / kSlot_ns % kSlotsPerPlan != 0) return;
    ++plan_->sequence;
    plan_->start_ns = now_ns_;
    for (int i = 0; i < 4; ++i) plan_->footstep_landing_ns[i] = now_ns_ + (i + 1) * 400'000'000;
    network_.accepted_sequence = plan_->sequence;
    network_writer_.publish(network_, now_ns_);
    plan_writer_.publish(*plan_, now_ns_);
  }
  [[nodiscard]] std::int64_t now_ns() const { return now_ns_; }

 private:
  msgclient::MemoryBlock& block_;
  msgclient::Client client_;
  msgclient::Writer<JointStates> joints_writer_ = client_.write<JointStates>("joint_states");
  msgclient::Writer<FootForces> forces_writer_ = client_.write<FootForces>("foot_forces");
  msgclient::Writer<gaitway::Imu> imu_writer_ = client_.write<gaitway::Imu>("imu");
  msgclient::Writer<NetworkState> network_writer_ = client_.write<NetworkState>("network_state");
  msgclient::Writer<Estimate> estimate_writer_ = client_.write<Estimate>("estimate");
  msgclient::Writer<MotionPlan> plan_writer_ = client_.write<MotionPlan>("motion_plan");
  JointStates joints_{};
  FootForces forces_{};
  gaitway::Imu imu_{};
  Estimate estimate_{};
  NetworkState network_{};
  std::unique_ptr<MotionPlan> plan_ = std::make_unique<MotionPlan>();
  std::int64_t now_ns_ = 0;
};

// The poll alone, without what the robot does in between.
void poll_slots(benchmark::State& state, PublicationSink& sink) {
  msgclient::MemoryBlock block;
  Robot robot(block);
  msgclient::Client client = block.local_client("api");
  PlanDigest digest(client);
  Feed feed(client, humanoid());
  for (auto _ : state) {
    robot.slot();
    const auto begin = std::chrono::steady_clock::now();
    digest.step(robot.now_ns());
    feed.poll(robot.now_ns(), sink);
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
}

void PollWithNothingNew(benchmark::State& state) {
  msgclient::MemoryBlock block;
  Robot robot(block);
  msgclient::Client client = block.local_client("api");
  Feed feed(client, humanoid());
  GenericSink sink([](Topic) { return true; }, [](Topic, const auto&, std::int64_t) {});
  robot.slot();
  for (auto _ : state) feed.poll(robot.now_ns(), sink);
}
BENCHMARK(PollWithNothingNew);

void PollASlotThatNobodyWants(benchmark::State& state) {
  GenericSink sink([](Topic) { return false; }, [](Topic, const auto&, std::int64_t) {});
  poll_slots(state, sink);
}
BENCHMARK(PollASlotThatNobodyWants)->UseManualTime();

void PollASlotWithAllWanted(benchmark::State& state) {
  GenericSink sink([](Topic) { return true; },
                   [](Topic, const auto& message, std::int64_t) { benchmark::DoNotOptimize(&message); });
  poll_slots(state, sink);
}
BENCHMARK(PollASlotWithAllWanted)->UseManualTime();

void PollASlotAndEncodeAllAsCdr(benchmark::State& state) {
  std::string bytes;
  GenericSink sink([](Topic) { return true; },
                   [&bytes](Topic, const auto& message, std::int64_t) {
                     bytes.clear();
                     append_cdr(bytes, message);
                     benchmark::DoNotOptimize(bytes.data());
                   });
  poll_slots(state, sink);
}
BENCHMARK(PollASlotAndEncodeAllAsCdr)->UseManualTime();

void PollASlotAndRecordAll(benchmark::State& state) {
  std::string folder = (std::filesystem::temp_directory_path() / "gaitway_bench_XXXXXX").string();
  if (::mkdtemp(folder.data()) == nullptr) {
    state.SkipWithError("no temporary folder");
    return;
  }
  {
    // More than its disk takes meanwhile: the robot's time is not the computer's.
    Recorder recorder(folder, {.waiting_bytes = 1 << 30});
    recorder.start(1, "bench", 0);
    GenericSink sink([](Topic) { return true; },
                     [&recorder](Topic topic, const auto& message, std::int64_t robot_ns) {
                       recorder.publish(topic, message, robot_ns);
                     });
    poll_slots(state, sink);
    recorder.stop(2);
    for (int answers = 0; answers < 2;) {
      recorder.take_result() ? static_cast<void>(++answers) : std::this_thread::yield();
    }
  }
  state.counters["bytes_per_slot"] =
      static_cast<double>(std::filesystem::file_size(std::filesystem::path(folder) / "bench.mcap")) /
      static_cast<double>(state.iterations());
  std::filesystem::remove_all(folder);
}
BENCHMARK(PollASlotAndRecordAll)->UseManualTime();

}  // namespace
}  // namespace gaitway::api
