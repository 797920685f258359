// An emergency stop while the disk of a recording takes nothing.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <variant>

#include "gaitway/api/feed.hpp"
#include "gaitway/api/link_robot_port.hpp"
#include "gaitway/api/recorder.hpp"
#include "linked_robot.hpp"
#include "simulation.hpp"
#include "stalled_disk.hpp"
#include "test_client.hpp"

namespace gaitway::api {
namespace {

using ::testing::HasSubstr;

class RecordingSink final : public PublicationSink {
 public:
  explicit RecordingSink(Recorder& recorder) : recorder_(recorder) {}
  [[nodiscard]] bool wants(Topic topic) const override { return recorder_.wants(topic); }
  void take(Topic topic, AnyMessage message, std::int64_t robot_ns) override {
    std::visit([&](const auto* known) { recorder_.publish(topic, *known, robot_ns); }, message);
  }

 private:
  Recorder& recorder_;
};

class RecordingStallTest : public ::testing::Test {
 protected:
  void pass_a_millisecond() {
    run_.advance_millisecond();
    now_ns_ = run_.now_ns() + kSecond_ns;
    linked_.pass_millisecond(now_ns_ - kMillisecond_ns);
    port_.observe(now_ns_);
    feed_.poll(now_ns_, sink_);
    recorder_.step(now_ns_);
    hub_.step(now_ns_);
  }
  json answer_within(int most_ms) {
    for (int ms = 0; ms < most_ms; ++ms) {
      pass_a_millisecond();
      for (const json& message : client_.receive()) {
        if (message["op"] == "service_response") return message;
      }
    }
    return json::object();
  }
  void call(const std::string& service, const json& arguments) {
    client_.send({{"op", "call_service"}, {"service", service}, {"args", arguments}});
  }

  StalledDisk stalled_;
  const urdf::RobotModel robot_ =
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
  simulator::Cosimulation run_{robot_, served_walk()};
  Recorder recorder_{std::filesystem::temp_directory_path(),
                     {.disk = stalled_.disk(), .waiting_bytes = 500'000}};
  test::LinkedRobot linked_{run_.client(), robot_, test::Line::socket};
  LinkRobotPort port_{linked_.link, robot_, &recorder_};
  msgclient::Client topics_ = linked_.link.topics("feed");
  Feed feed_{topics_, robot_};
  RecordingSink sink_{recorder_};
  Hub hub_{port_, {}};
  std::int64_t now_ns_ = kSecond_ns;
  TestClient client_{hub_, now_ns_, "client"};
};

TEST_F(RecordingStallTest, AStopIsDoneAtOnceWhileTheDiskTakesNothing) {
  call("/recording/start", {{"name", "stalled"}});
  // The recording's thread is in no step with the robot's time.
  ASSERT_TRUE(answer_within(20'000).value("values", json::object()).value("success", false));
  // The disk takes nothing more long before this.
  std::string report;
  for (int ms = 0; ms < 60'000 && report.empty(); ++ms) {
    pass_a_millisecond();
    report = recorder_.take_report().value_or("");
  }
  EXPECT_THAT(report, HasSubstr("'stalled' takes nothing more: its disk is too slow"));
  stalled_.await_stall();
  call("/recording/stop", json::object());
  call("/emergency_stop", {{"data", false}});
  EXPECT_EQ(answer_within(5)["service"], "/emergency_stop");
  EXPECT_EQ(run_.message_controller().mode(), msgcontroller::Mode::emergency_stop);
  EXPECT_TRUE(stalled_.recover().ends_with("\x89MCAP0\r\n"));
  EXPECT_THAT(answer_within(20'000)["values"].value("message", ""), HasSubstr("nothing is being recorded"));
}

}  // namespace
}  // namespace gaitway::api
