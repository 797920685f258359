// Watches the simulated robot for its summary and log: distance, falls, a row every ten milliseconds.
#include "walk_watch.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <string>

#include "gaitway/facts/facts.hpp"
#include "gaitway/process/text_file.hpp"

namespace gaitway::simulator {
namespace {

constexpr std::int64_t kLogPeriod_ns = 10 * facts::kMillisecond_ns;

}  // namespace

WalkWatch::WalkWatch(const Plant& plant, bool log_wanted, std::int64_t start_ns)
    : log_wanted_(log_wanted), start_ns_(start_ns), start_m_(plant.truth().base.translation()) {}

void WalkWatch::look(const Plant& plant, std::int64_t now_ns) {
  if (!fell_at_s_ && plant.fallen()) {
    fell_at_s_ = time_s(now_ns);
    fmt::print(stderr, "virtual_robot: fell after {:.2f} s\n", *fell_at_s_);
  }
  if (log_wanted_ && (now_ns - start_ns_) % kLogPeriod_ns == 0) {
    const PlantTruth truth = plant.truth();
    log_.push_back({time_s(now_ns), truth.base.translation(), truth.trunk_tilt_rad});
  }
}

double WalkWatch::distance_m(const Plant& plant) const {
  return (plant.truth().base.translation() - start_m_).head<2>().norm();
}

void WalkWatch::write_log(const std::filesystem::path& file) const {
  std::string text = "time_s,base_x_m,base_y_m,base_z_m,trunk_tilt_rad\n";
  for (const Row& row : log_) {
    text += fmt::format("{:.3f},{:.5f},{:.5f},{:.5f},{:.5f}\n", row.time_s, row.base_m.x(), row.base_m.y(),
                        row.base_m.z(), row.trunk_tilt_rad);
  }
  process::write_text_file(file, text);
}

}  // namespace gaitway::simulator
