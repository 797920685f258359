// A humanoid for every number: most of what it is lies where humanoids lie, and something of it at the edge.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "generated_humanoid.hpp"

namespace gaitway::importer::test {

// Draws what a body is like; the same for the same number, with every compiler.
class RandomHumanoid {
 public:
  explicit RandomHumanoid(std::uint64_t seed) : engine_(seed) {}

  Humanoid draw() {
    Humanoid body;
    body.hip_height_m = between(0.25, 1.3);
    // The density of humanoids, half of it to twice of it.
    body.mass_kg = 80.0 * std::pow(body.hip_height_m, 3) * between(0.5, 2.0);
    draw_build(body);
    draw_shape(body);
    draw_masses(body);
    draw_limits(body);
    draw_drives(body);
    return body;
  }

 private:
  double between(double least, double most) {
    return least + (most - least) * static_cast<double>(engine_() >> 11U) * 0x1p-53;
  }
  bool maybe() { return (engine_() & 1U) != 0; }
  // Mostly from `usual`, one time in five from all of `sane`.
  struct Bounds {
    double least, most;
  };
  double trait(Bounds usual, Bounds sane) {
    const Bounds& bounds = engine_() % 5U == 0 ? sane : usual;
    return between(bounds.least, bounds.most);
  }
  template <std::size_t kCount>
  void shuffle(std::array<int, kCount>& order) {
    for (std::size_t i = kCount - 1; i > 0; --i) std::swap(order[i], order[engine_() % (i + 1)]);
  }

  // What the joints are like, and how it is written.
  void draw_build(Humanoid& body) {
    shuffle(body.hip);
    shuffle(body.ankle);
    body.turned_axes = static_cast<std::uint32_t>(engine_() % 64U);
    for (std::uint64_t quarter = engine_() % 4U; quarter > 0; --quarter) {
      Eigen::Matrix3d turn;
      turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
      body.base_in_root = turn * body.base_in_root;
    }
    body.plain_names = maybe();
    body.fixed_joints = maybe();
    body.massless_hip_links = maybe();
    body.arm_joints = static_cast<int>(engine_() % 8U);
    body.toes = maybe();
    body.imu_frame = maybe();
    body.unsound_inertia = maybe();
  }
  // Of the hip height.
  void draw_shape(Humanoid& body) {
    body.half_hip_width = trait({0.08, 0.12}, {0.05, 0.16});
    body.hip_offset = maybe() ? trait({-0.05, 0.05}, {-0.08, 0.08}) : 0.0;
    body.hip_aside = maybe() ? trait({-0.01, 0.03}, {-0.02, 0.06}) : 0.0;
    body.hip_drop = maybe() ? trait({0.0, 0.05}, {0.0, 0.10}) : 0.0;
    body.thigh = trait({0.40, 0.52}, {0.28, 0.62});
    body.foot = static_cast<FootShape>(engine_() % 4U);
    body.foot_length = trait({0.20, 0.32}, {0.12, 0.40});
    body.foot_width = trait({0.09, 0.16}, {0.05, 0.20});
    body.foot_ahead = trait({0.0, 0.06}, {-0.03, 0.10});
  }
  // Legs of 80 % of the mass at most; the rest is base, chest and arms.
  void draw_masses(Humanoid& body) {
    body.leg_share = 0.5 * trait({0.30, 0.50}, {0.20, 0.80});
    const double above = 1.0 - 2.0 * body.leg_share;
    body.base_share = above * trait({0.15, 0.40}, {0.05, 0.70});
    body.arm_share = above * trait({0.03, 0.12}, {0.01, 0.14});
    body.gyration = trait({0.04, 0.08}, {0.03, 0.12});
  }
  void draw_limits(Humanoid& body) {
    const auto both_ways = [](double range) { return Range{-range, range}; };
    body.hip_range = {both_ways(trait({0.5, 0.9}, {0.1, 1.2})),
                      {-trait({0.4, 0.8}, {0.15, 1.0}), trait({0.4, 0.8}, {0.15, 1.0})},
                      {-trait({1.4, 2.0}, {0.5, 2.2}), trait({0.5, 1.5}, {0.1, 2.0})}};
    body.most_knee_rad = trait({1.8, 2.4}, {0.6, 2.6});
    body.ankle_range = {Range{-trait({0.8, 1.2}, {0.3, 1.4}), trait({0.6, 1.2}, {0.2, 1.4})},
                        both_ways(trait({0.35, 0.7}, {0.1, 0.9}))};
  }
  // A walk of humanoid22's kind takes 0.25 and 1.5.
  void draw_drives(Humanoid& body) {
    if (maybe()) {
      for (Rating& rating : body.rating) rating.torque = trait({0.25, 0.6}, {0.05, 1.0});
    }
    if (maybe()) {
      for (Rating& rating : body.rating) rating.speed = trait({1.3, 3.0}, {0.5, 5.0});
    }
  }

  std::mt19937_64 engine_;
};

}  // namespace gaitway::importer::test
