// A walking pattern and what it is told, planned batch by batch: the fixture of its tests.
#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cstdint>
#include <memory>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/walking_pattern.hpp"

namespace gaitway::trajectory {

using facts::kCycle_ns;

class PlannedWalk : public ::testing::Test {
 protected:
  // Plans so many batches of 80 ms.
  void run(int cycles, const Eigen::Vector2d& deviation_m = Eigen::Vector2d::Zero()) {
    for (int i = 0; i < cycles; ++i) {
      ++sequence;
      pattern.plan(sequence, sequence * kCycle_ns, command, correction, *plan, deviation_m);
    }
  }
  void command_walk(double forward, double left, double turn) {
    command.walk = 1;
    command.velocity[0] = forward;
    command.velocity[1] = left;
    command.turn_rate = turn;
  }

  GaitParameters parameters;
  WalkingPattern pattern{parameters};
  WalkCommand command{};
  Correction correction{};
  std::unique_ptr<MotionPlan> plan = std::make_unique<MotionPlan>();
  std::uint32_t sequence = 0;
};

}  // namespace gaitway::trajectory
