// Who may begin and end a recording, and how it may be named.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "test_client.hpp"

namespace gaitway::api {
namespace {

using testing::HasSubstr;

class RecordingServiceTest : public HubTest {
 protected:
  json call(TestClient& by, const std::string& service, const json& arguments = json::object()) {
    by.send({{"op", "call_service"}, {"service", service}, {"args", arguments}});
    step();
    return by.receive_one()["values"];
  }
  json start(TestClient& by, const std::string& name = "walk") {
    return call(by, "/recording/start", {{"name", name}});
  }
  json stop(TestClient& by) { return call(by, "/recording/stop"); }

  std::unique_ptr<TestClient> client = connect("anna"), watcher = connect("watcher");
};

TEST_F(RecordingServiceTest, AnEmptyNameIsNamedByTheTime) {
  EXPECT_EQ(start(*client, "")["success"], true);
  EXPECT_EQ(stop(*client)["success"], true);
}

TEST_F(RecordingServiceTest, WhoeverIsLetInMayRecordWhileAnotherCommands) {
  client->call("/command/acquire");
  EXPECT_EQ(start(*watcher)["success"], true);
  EXPECT_EQ(hub.statistics().commander, "anna") << "a recording is no command";
  EXPECT_EQ(stop(*watcher)["success"], true);
}

TEST_F(RecordingServiceTest, AStrangerRecordsNothing) {
  const auto stranger = connect("stranger", false);
  stranger->send({{"op", "call_service"}, {"service", "/recording/start"}, {"args", {{"name", "walk"}}}});
  step();
  EXPECT_FALSE(robot.recording);
}

TEST_F(RecordingServiceTest, GoesOnWhenItsBeginnerGoesBeItBeforeTheAnswer) {
  client->send({{"op", "call_service"}, {"service", "/recording/start"}, {"args", {{"name", "walk"}}}});
  client->disconnect();
  step();
  EXPECT_TRUE(robot.recording);
  EXPECT_EQ(stop(*watcher)["success"], true);
}

TEST_F(RecordingServiceTest, AWatcherEndsNobodysRecording) {
  start(*client);
  const json denied = stop(*watcher);
  EXPECT_EQ(denied["success"], false);
  EXPECT_THAT(denied["message"], HasSubstr("the recording is of \"anna\""));
  EXPECT_TRUE(robot.recording);
  EXPECT_EQ(stop(*client)["success"], true);
}

TEST_F(RecordingServiceTest, WhoCommandsEndsEveryRecording) {
  start(*client);
  watcher->call("/command/acquire");
  EXPECT_EQ(stop(*watcher)["success"], true);
  EXPECT_FALSE(robot.recording);
}

TEST_F(RecordingServiceTest, ARecordingWhoseBeginnerHasGoneIsEndedByAnybody) {
  start(*client);
  client->disconnect();
  EXPECT_EQ(stop(*watcher)["success"], true);
}

TEST_F(RecordingServiceTest, WhoIsToldThatOneIsUnderWayDoesNotOwnIt) {
  start(*client);
  EXPECT_EQ(start(*watcher)["success"], false);
  EXPECT_EQ(stop(*watcher)["success"], false);
}

}  // namespace
}  // namespace gaitway::api
