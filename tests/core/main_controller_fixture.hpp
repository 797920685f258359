// A main controller with the plug-in `joint_planner`, and a message controller played by the test.
#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <memory>
#include <string>

#include "gaitway/core/main_controller.hpp"
#include "gaitway/msgclient/memory_block.hpp"

namespace gaitway::core {

class MainControllerFixture : public testing::Test {
 protected:
  MainControllerFixture() {
    states.joint_count = static_cast<std::uint32_t>(robot.joints.size());
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      states.reference_position[joint] = robot.joints[joint].home_rad;
    }
    network.mode = 2;
    publish();
  }
  void start(const std::string& defect, WallClock clock = &steady_clock_ns) {
    const auto file = std::filesystem::path(testing::TempDir()) /
                      (std::string("main_controller_") +
                       testing::UnitTest::GetInstance()->current_test_info()->name() + ".yaml");
    std::ofstream(file) << "plugins:\n  - {name: planner, library: joint_planner.so, parameters: {defect: "
                        << defect << "}}\n";
    MainControllerOptions options;
    options.configuration = file;
    options.plugin_path = {GAITWAY_TEST_PLUGINS};
    options.wall_clock = clock;
    controller = std::make_unique<MainController>(robot, client, emi.host(), options);
    std::filesystem::remove(file);
  }
  void publish() {
    states_writer.publish(states, now_ns);
    publish_network();
  }
  void publish_network() {
    network.stamp_ns = now_ns;
    network_writer.publish(network, now_ns);
  }
  // One tick; then the message side takes its mails.
  TickReport tick() {
    now_ns = next_tick_ns(now_ns);
    publish_network();  // the message controller lives
    const TickReport report = controller->step(now_ns);
    trim_taken = emi.message().take_trim(trim, now_ns + report.transfer_ns) == msgclient::TakeStatus::mail;
    batch_taken =
        emi.message().take_hand_over(*batch, now_ns + report.transfer_ns) == msgclient::TakeStatus::mail;
    return report;
  }
  TickReport batch_tick() {
    TickReport report;
    do {
      report = tick();
    } while (!report.batch);
    return report;
  }
  void answer(msgclient::Verdict verdict, msgclient::Reason reason = msgclient::Reason::none) {
    ASSERT_TRUE(emi.message().answer({.mail = msgclient::MailKind::hand_over,
                                      .sequence = batch->sequence,
                                      .verdict = verdict,
                                      .reason = reason,
                                      .joint = 3,
                                      .point = 0}));
  }

  urdf::RobotModel robot = urdf::load_robot(GAITWAY_TEST_ROBOT);
  msgclient::MemoryBlock block;
  msgclient::EmiAdapter emi{block};
  msgclient::Client client = block.local_client("main_controller");
  msgclient::Client message_client = block.local_client("message_controller");
  msgclient::Writer<JointStates> states_writer = message_client.write<JointStates>("joint_states");
  msgclient::Writer<NetworkState> network_writer = message_client.write<NetworkState>("network_state");
  JointStates states{};
  NetworkState network{};
  std::int64_t now_ns = 0;
  std::unique_ptr<MainController> controller;
  msgclient::TrimUpdate trim;
  std::unique_ptr<msgclient::HandOver> batch = std::make_unique<msgclient::HandOver>();
  bool trim_taken = false;
  bool batch_taken = false;
};

}  // namespace gaitway::core
