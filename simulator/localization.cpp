// Truth, noise, and a queue.
#include "gaitway/simulator/localization.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace gaitway::simulator {
namespace {

constexpr double kSamePlace_m = 0.01;  // and rad

bool same_places(const Obstacles& a, const Obstacles& b) {
  const auto near = [](const double(&x)[3], const double(&y)[3]) {
    return std::ranges::equal(x, y, [](double p, double q) { return std::abs(p - q) < kSamePlace_m; });
  };
  for (std::uint32_t i = 0; a.count == b.count && i < a.count; ++i) {
    if (!near(a.place[i], b.place[i]) || !near(a.size[i], b.size[i])) return false;
  }
  return a.count == b.count;
}

}  // namespace

Obstacles boxes_around(std::span<const world::Solid> solids) {
  constexpr double kOverhead_m = 1.5;  // what begins higher is in nobody's way
  Obstacles boxes{};
  for (const world::Solid& solid : solids) {
    const auto [least_m, greatest_m] = solid.bounds_m();
    if (least_m.z() > kOverhead_m || boxes.count == kMaxObstacles) continue;
    const Eigen::Matrix3d turn = solid.pose.linear();
    const bool upright = turn(2, 2) > 0.999 && solid.shape == world::Solid::Shape::box;
    const Eigen::Vector3d size_m = upright ? solid.size_m : Eigen::Vector3d(greatest_m - least_m);
    const Eigen::Vector3d middle_m = (greatest_m + least_m) / 2.0;
    const std::array<double, 3> place{middle_m.x(), middle_m.y(),
                                      upright ? std::atan2(turn(1, 0), turn(0, 0)) : 0.0};
    const std::array<double, 3> size{size_m.x(), size_m.y(), greatest_m.z()};
    std::ranges::copy(place, boxes.place[boxes.count]);
    std::ranges::copy(size, boxes.size[boxes.count]);
    ++boxes.count;
  }
  return boxes;
}

Localization::Localization(msgclient::Client& client, const LocalizationOptions& options, std::uint64_t seed)
    : client_(client),
      options_(options),
      writer_(client.write<PoseMeasurement>("pose_measurement")),
      random_(seed ^ 0x10CA'0000'0000'0001ULL) {}

void Localization::step(std::int64_t now_ns, const Plant& plant) {
  if (now_ns % options_.period_ns == 0) {
    see_robot(now_ns, plant);
    see_obstacles(now_ns, plant);
  }
  while (!seen_.empty() && now_ns >= seen_.front().stamp_ns + options_.delay_ns) {
    writer_.publish(seen_.front(), now_ns);
    seen_.pop_front();
  }
}

void Localization::see_robot(std::int64_t now_ns, const Plant& plant) {
  std::normal_distribution<double> noise;
  const Eigen::Isometry3d base = plant.truth().base;
  PoseMeasurement& one = seen_.emplace_back();
  one.stamp_ns = now_ns;
  one.base[0] = base.translation().x() + options_.deviation_m * noise(random_);
  one.base[1] = base.translation().y() + options_.deviation_m * noise(random_);
  one.base[2] =
      std::atan2(base.linear()(1, 0), base.linear()(0, 0)) + options_.deviation_rad * noise(random_);
  one.deviation[0] = options_.deviation_m;
  one.deviation[1] = options_.deviation_rad;
}

void Localization::see_obstacles(std::int64_t now_ns, const Plant& plant) {
  const std::vector<world::Solid> solids = plant.put_solids();
  if (others_see_obstacles_ || (solids.empty() && !obstacles_)) return;
  if (!obstacles_) {
    try {
      obstacles_.emplace(client_.write<Obstacles>("obstacles"));
    } catch (const msgclient::TopicError&) {
      others_see_obstacles_ = true;  // a robot with eyes of its own
      return;
    }
  }
  const Obstacles seen = boxes_around(solids);
  if (same_places(seen, told_)) return;
  told_ = seen;
  told_.stamp_ns = now_ns;
  obstacles_->publish(told_, now_ns);
}

}  // namespace gaitway::simulator
