// Recording beside the disk: what is published is in the file, and nobody waits for it.
#include "gaitway/api/recorder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "gaitway/api/ros_messages.hpp"
#include "mcap_outline.hpp"
#include "stalled_disk.hpp"

namespace gaitway::api {
namespace {

namespace fs = std::filesystem;
using test::McapOutline;
using ::testing::HasSubstr;

class RecorderTest : public ::testing::Test {
 protected:
  RecorderTest() {
    std::string pattern = (fs::temp_directory_path() / "gaitway_recordings_XXXXXX").string();
    folder = ::mkdtemp(pattern.data());
  }
  ~RecorderTest() override { fs::remove_all(folder); }

  static void clocks(Recorder& recorder, int count) {
    for (int i = 0; i < count; ++i) {
      const std::int64_t now_ns = std::int64_t{i} * 10'000'000;
      recorder.publish(Topic::clock, ros::Clock{ros_time(now_ns)}, now_ns);
    }
  }
  // The next answer, whenever the recorder's thread has it.
  static OrderResult answer(Recorder& recorder) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(20);
    while (std::chrono::steady_clock::now() < end) {
      if (auto result = recorder.take_result()) return *result;
      std::this_thread::yield();
    }
    throw std::runtime_error("the recorder has not answered");
  }
  static void start(Recorder& recorder, const std::string& name) {
    recorder.start(1, name, 0);
    const OrderResult result = answer(recorder);
    EXPECT_TRUE(result.done) << result.text;
  }
  static OrderResult stop(Recorder& recorder) {
    recorder.stop(2);
    return answer(recorder);
  }
  // Once it is answered, all that was published before has been worked off.
  static RecordingList list(Recorder& recorder) {
    recorder.list(3, 10);
    return answer(recorder).recordings;
  }
  static void descriptions(Recorder& recorder, int count) {
    for (int i = 0; i < count; ++i) {
      recorder.publish(Topic::robot_description, ros::String{std::string(100'000, 'x')}, i);
    }
  }
  // A recording that has ended since its disk has stalled: what is reported then.
  std::string stall(Recorder& recorder) const {
    start(recorder, "stalled");
    descriptions(recorder, 15);  // more than a chunk
    stalled.await_stall();
    descriptions(recorder, 25);
    return recorder.take_report().value_or("none");
  }
  [[nodiscard]] RecorderOptions on_stalled_disk() const {
    return {.disk = stalled.disk(), .waiting_bytes = 2'000'000};
  }

  fs::path folder;
  StalledDisk stalled;
};

TEST_F(RecorderTest, RecordsWhatIsPublishedFromStartToStop) {
  Recorder recorder(folder);
  EXPECT_FALSE(recorder.wants(Topic::joint_states));
  clocks(recorder, 7);
  recorder.start(5, "walk-1", 5);
  EXPECT_TRUE(recorder.wants(Topic::joint_states));
  clocks(recorder, 250);
  recorder.stop(6);
  EXPECT_FALSE(recorder.wants(Topic::joint_states));
  clocks(recorder, 7);
  for (const std::uint32_t number : {5U, 6U}) {
    const OrderResult result = answer(recorder);
    EXPECT_EQ(result.number, number);
    EXPECT_TRUE(result.done);
    EXPECT_EQ(result.text, (folder / "walk-1.mcap").string());
  }
  const McapOutline outline(folder / "walk-1.mcap");
  EXPECT_TRUE(outline.complete());
  EXPECT_EQ(outline.messages("/clock"), 250U);
  EXPECT_FALSE(recorder.take_report());
  ASSERT_EQ(list(recorder).newest.size(), 1U);
}

TEST_F(RecorderTest, BeginsWithTheLastMessageOfEachLatchedTopic) {
  Recorder recorder(folder);
  EXPECT_TRUE(recorder.wants(Topic::robot_description));
  recorder.publish(Topic::robot_description, ros::String{"<robot/>"}, 0);
  recorder.publish(Topic::footsteps, ros::PoseArray{}, 0);
  recorder.publish(Topic::footsteps, ros::PoseArray{}, 1);
  recorder.publish(Topic::clock, ros::Clock{}, 1);
  start(recorder, "a");
  stop(recorder);
  const McapOutline outline(folder / "a.mcap");
  EXPECT_EQ(outline.messages("/robot_description"), 1U);
  EXPECT_EQ(outline.messages("/footsteps"), 1U);
  EXPECT_EQ(outline.messages("/clock"), 0U);
}

TEST_F(RecorderTest, ARefusedStartOrStopIsAnsweredAndChangesNothing) {
  Recorder recorder(folder);
  EXPECT_FALSE(stop(recorder).done);
  recorder.start(1, "../a", 0);
  EXPECT_THAT(answer(recorder).text, HasSubstr("no name for a recording"));
  list(recorder);
  EXPECT_FALSE(recorder.wants(Topic::joint_states));
  start(recorder, "a");
  recorder.start(1, "b", 0);
  EXPECT_THAT(answer(recorder).text, HasSubstr("a.mcap"));
  clocks(recorder, 3);
  EXPECT_TRUE(stop(recorder).done);
  EXPECT_EQ(McapOutline(folder / "a.mcap").messages("/clock"), 3U);
}

TEST_F(RecorderTest, WritesWhatWaitsOnceASecond) {
  Recorder recorder(folder);
  start(recorder, "live");
  recorder.step(0);
  clocks(recorder, 10);
  recorder.step(900'000'000);
  list(recorder);
  EXPECT_EQ(McapOutline(folder / "live.mcap").messages("/clock"), 0U);
  recorder.step(1'000'000'000);
  list(recorder);
  EXPECT_EQ(McapOutline(folder / "live.mcap").messages("/clock"), 10U);
}

TEST_F(RecorderTest, ItsEndWritesWhatWaits) {
  {
    Recorder recorder(folder);
    recorder.start(1, "last", 0);
    clocks(recorder, 1000);
  }
  const McapOutline outline(folder / "last.mcap");
  EXPECT_TRUE(outline.complete());
  EXPECT_EQ(outline.messages("/clock"), 1000U);
}

TEST_F(RecorderTest, ARecordingThatEndsByItselfIsReported) {
  Recorder recorder(folder, {.limits = {.file_bytes = 300'000}});
  start(recorder, "limited");
  for (int i = 0; i < 50; ++i) clocks(recorder, 200);
  list(recorder);
  clocks(recorder, 1);
  EXPECT_FALSE(stop(recorder).done);
  EXPECT_THAT(recorder.take_report().value_or("none"), HasSubstr("limit of 300000 bytes"));
  EXPECT_FALSE(recorder.wants(Topic::clock));
}

TEST_F(RecorderTest, ADiskThatTakesNothingEndsTheRecordingAndHoldsNobodyUp) {
  Recorder recorder(folder, on_stalled_disk());
  EXPECT_THAT(stall(recorder), HasSubstr("'stalled' takes nothing more: its disk is too slow"));
  EXPECT_FALSE(recorder.wants(Topic::clock));
  EXPECT_THROW(recorder.start(1, "next", 0), std::runtime_error);
  const std::string file = stalled.recover();
  EXPECT_TRUE(file.ends_with("\x89MCAP0\r\n")) << "what waited is written, and the file is whole";
  EXPECT_GT(file.size(), 1'800'000U);
  list(recorder);
  EXPECT_THAT(stop(recorder).text, HasSubstr("nothing is being recorded"));
  EXPECT_THAT(recorder.take_report().value_or("none"), HasSubstr("stalled.mcap' has ended with"));
}

TEST_F(RecorderTest, OrdersThatWaitForADiskAreBounded) {
  Recorder recorder(folder, on_stalled_disk());
  stall(recorder);
  int orders = 0;
  try {
    for (; orders < 10'000; ++orders) recorder.list(7, 10);
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("too many orders"));
  }
  EXPECT_LT(orders, 100);
  static_cast<void>(stalled.recover());
  for (; orders > 0; --orders) EXPECT_EQ(answer(recorder).number, 7U);
}

TEST_F(RecorderTest, ADiskThatTakesNothingDelaysTheEndByABoundedTime) {
  auto recorder = std::make_unique<Recorder>(folder, on_stalled_disk());
  stall(*recorder);
  recorder.reset();  // would hang
  EXPECT_TRUE(stalled.recover().ends_with("\x89MCAP0\r\n"));
}

}  // namespace
}  // namespace gaitway::api
