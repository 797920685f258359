// A client that subscribes, and what the robot publishes for it, for tests.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "test_client.hpp"

namespace gaitway::api {

inline HubOptions small_boxes() {
  HubOptions options;
  options.limits.waiting_bytes = 4096;
  options.limits.subscriptions = 3;
  options.limits.queue_length = 10;
  return options;
}

class SubscriptionTest : public HubTest {
 protected:
  explicit SubscriptionTest(HubOptions options = {}) : HubTest(std::move(options)) {}

  // /zmp with this x.
  void publish(double x) {
    ros::PointStamped message;
    message.header.frame_id = "odom";
    message.point.x = x;
    hub.publish(Topic::zmp, message);
  }
  void publish_com(double x) {
    ros::PointStamped message;
    message.point.x = x;
    hub.publish(Topic::com, message);
  }
  void publish_description(std::string urdf) {
    hub.publish(Topic::robot_description, ros::String{std::move(urdf)});
  }
  static std::vector<double> xs(const std::vector<json>& messages) {
    std::vector<double> values;
    for (const json& message : messages) {
      EXPECT_EQ(message["op"], "publish") << message.dump();
      values.push_back(message["msg"]["point"]["x"].get<double>());
    }
    return values;
  }

  std::unique_ptr<TestClient> client = connect("anna");
};

class SmallBoxTest : public SubscriptionTest {
 protected:
  SmallBoxTest() : SubscriptionTest(small_boxes()) {}
};

}  // namespace gaitway::api
