// Truth, noise, and a queue.
#include "gaitway/simulator/localization.hpp"

#include <cmath>

namespace gaitway::simulator {

Localization::Localization(msgclient::Client& client, const LocalizationOptions& options, std::uint64_t seed)
    : options_(options),
      writer_(client.write<PoseMeasurement>("pose_measurement")),
      random_(seed ^ 0x10CA'0000'0000'0001ULL) {}

void Localization::step(std::int64_t now_ns, const Plant& plant) {
  if (now_ns % options_.period_ns == 0) {
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
  while (!seen_.empty() && now_ns >= seen_.front().stamp_ns + options_.delay_ns) {
    writer_.publish(seen_.front(), now_ns);
    seen_.pop_front();
  }
}

}  // namespace gaitway::simulator
