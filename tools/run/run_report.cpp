// Lays out report.html: summary, film strip, the walk from above, joints, one cycle of the bus, compute
// times.
#include "tools/run/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <numbers>

#include "gaitway/can/profile.hpp"
#include "gaitway/geometry/convex_hull.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/process/text_file.hpp"
#include "tools/run/svg_plot.hpp"

namespace gaitway::tools {
namespace {

using Points = std::vector<Eigen::Vector2d>;

constexpr std::string_view kBlue = "#2563eb", kOrange = "#ea580c", kGreen = "#059669", kGrey = "#94a3b8",
                           kRed = "#dc2626";

constexpr std::string_view kStyle = R"(
:root{color-scheme:light dark;--ink:#0f172a;--soft:#64748b;--line:#e2e8f0;--paper:#fff}
@media(prefers-color-scheme:dark){:root{--ink:#e2e8f0;--soft:#94a3b8;--line:#334155;--paper:#0f172a}}
body{font:15px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--paper);max-width:980px;margin:2rem auto;padding:0 1rem}
h1{font-size:1.5rem;margin:0}h2{font-size:1.1rem;margin:2rem 0 .5rem}p{color:var(--soft);margin:.2rem 0 .6rem}
pre{font:13px/1.6 ui-monospace,monospace;border:1px solid var(--line);border-radius:6px;padding:.7rem 1rem;overflow:auto}
img,svg{max-width:100%;height:auto}svg text{font:11px system-ui,sans-serif;fill:var(--soft)}
svg .title{font-size:13px;font-weight:600;fill:var(--ink)}svg .grid{stroke:var(--line)}
)";

std::string base64(const std::vector<unsigned char>& bytes) {
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = static_cast<unsigned>(bytes[i]) << 16U;
    group |= left > 1 ? static_cast<unsigned>(bytes[i + 1]) << 8U : 0U;
    group |= left > 2 ? static_cast<unsigned>(bytes[i + 2]) : 0U;
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= left ? kAlphabet[(group >> (18U - 6U * k)) & 63U] : '=';
    }
  }
  return text;
}

template <class Project>
Points series(std::span<const RunSample> samples, Project project) {
  Points points;
  points.reserve(samples.size());
  std::ranges::transform(samples, std::back_inserter(points), project);
  return points;
}

// A foot stands when its sole is on the ground and its cells bear load; its outline is drawn once a stance.
void draw_footprints(SvgPlot& plot, const urdf::RobotModel& robot, std::span<const RunSample> samples) {
  constexpr double kStandingForce_N = 10.0;
  for (std::size_t side = 0; side < 2; ++side) {
    bool standing = false;
    for (const RunSample& sample : samples) {
      double force = 0.0;
      for (const double cell : sample.force_N[side]) {
        force += cell;
      }
      if (!standing && force > 2 * kStandingForce_N) {
        standing = true;
        const Eigen::Vector4d& foot = sample.foot[side];
        plot.polygon(robot.feet[side].corners_m({foot[0], foot[1], foot[3]}), side == 0 ? kBlue : kOrange,
                     "none");
      } else if (standing && force < kStandingForce_N) {
        standing = false;
      }
    }
  }
}

// As seen from above; what is round has sixteen corners.
Points outline(const world::Solid& solid) {
  Points points;
  const Eigen::Vector3d half = solid.size_m / 2.0;
  const bool is_box = solid.shape == world::Solid::Shape::box;
  for (int i = 0; is_box && i < 8; ++i) {
    const Eigen::Vector3d corner((i & 1) != 0 ? half.x() : -half.x(), (i & 2) != 0 ? half.y() : -half.y(),
                                 (i & 4) != 0 ? half.z() : -half.z());
    points.push_back((solid.pose * corner).head<2>());
  }
  for (int i = 0; !is_box && i < 16; ++i) {
    const double angle = i * std::numbers::pi / 8.0;
    points.push_back(solid.pose.translation().head<2>() +
                     half.x() * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  const geometry::ConvexHull<Eigen::Vector2d, 16> hull(points);
  return {hull.corners().begin(), hull.corners().end()};
}

void draw_world(SvgPlot& plot, const std::vector<world::Solid>& solids) {
  constexpr double kClearance_m = 0.05;
  for (const world::Solid& solid : solids) {
    const bool hangs = solid.bounds_m().first.z() > kClearance_m;  // one walks below it
    const std::string_view fill = hangs                              ? "none"
                                  : world::is_ground(solid.kind)     ? "#94a3b826"
                                  : solid.kind == world::Kind::thing ? "#2563eb40"
                                                                     : "#b4530959";
    plot.background(outline(solid), kGrey, fill, fmt::format("{} '{}'", world::name(solid.kind), solid.name));
  }
}

std::string from_above(const ReportInput& input) {
  const std::span<const RunSample> samples = input.recorder.samples();
  PlotFrame frame{.title = "The walk from above: feet, centre of mass, ZMP",
                  .x_label = "x [m]",
                  .y_label = "y [m]",
                  .equal_scale = true};
  frame.x_min = frame.y_min = 1e9;
  frame.x_max = frame.y_max = -1e9;
  for (const RunSample& sample : samples) {
    frame.x_min = std::min(frame.x_min, sample.com_m.x() - 0.12);
    frame.x_max = std::max(frame.x_max, sample.com_m.x() + 0.12);
    frame.y_min = std::min(frame.y_min, sample.com_m.y() - 0.15);
    frame.y_max = std::max(frame.y_max, sample.com_m.y() + 0.15);
  }
  SvgPlot plot(frame);
  draw_world(plot, input.solids);
  draw_footprints(plot, input.robot, samples);
  plot.line(series(samples, [](const RunSample& s) { return s.reference_zmp_m; }), kGrey, "reference ZMP");
  plot.line(series(samples, [](const RunSample& s) { return s.measured_zmp_m; }), kGreen, "measured ZMP",
            1.0);
  plot.line(series(samples, [](const RunSample& s) -> Eigen::Vector2d { return s.com_m.head<2>(); }), kRed,
            "CoM", 2.0);
  return plot.svg();
}

// Four seconds in the middle of the run, where walking is steady.
std::span<const RunSample> steady_part(std::span<const RunSample> samples, std::size_t wanted) {
  const std::size_t count = std::min(wanted, samples.size());
  return samples.subspan((samples.size() - count) / 2, count);
}

std::string zmp_over_time(const ReportInput& input, int axis) {
  const auto samples = steady_part(input.recorder.samples(), 400);
  if (samples.empty()) {
    return {};
  }
  PlotFrame frame{.title = axis == 0 ? "ZMP and CoM forward" : "ZMP and CoM sideways",
                  .x_label = "time [s]",
                  .y_label = axis == 0 ? "x [m]" : "y [m]",
                  .x_min = samples.front().time_s,
                  .x_max = samples.back().time_s,
                  .height_px = 260.0};
  frame.y_min = 1e9;
  frame.y_max = -1e9;
  for (const RunSample& sample : samples) {
    for (const double value :
         {sample.com_m[axis], sample.measured_zmp_m[axis], sample.reference_zmp_m[axis]}) {
      if (std::isfinite(value)) {
        frame.y_min = std::min(frame.y_min, value - 0.01);
        frame.y_max = std::max(frame.y_max, value + 0.01);
      }
    }
  }
  SvgPlot plot(frame);
  const auto over_time = [axis](auto member) {
    return [axis, member](const RunSample& s) { return Eigen::Vector2d(s.time_s, (s.*member)[axis]); };
  };
  plot.line(series(samples, over_time(&RunSample::reference_zmp_m)), kGrey, "reference ZMP");
  plot.line(series(samples, over_time(&RunSample::measured_zmp_m)), kGreen, "measured ZMP");
  plot.line(series(samples, over_time(&RunSample::reference_com_m)), kBlue, "reference CoM");
  plot.line(series(samples, over_time(&RunSample::com_m)), kRed, "CoM");
  return plot.svg();
}

std::string joint_tracking(const ReportInput& input, std::size_t joint) {
  const auto samples = steady_part(input.recorder.samples(), 200);
  if (samples.empty()) {
    return {};
  }
  constexpr double kDegrees = 57.29577951;
  PlotFrame frame{.title = input.robot.joints[joint].name,
                  .x_label = "time [s]",
                  .y_label = "angle [deg]",
                  .x_min = samples.front().time_s,
                  .x_max = samples.back().time_s,
                  .width_px = 480.0,
                  .height_px = 200.0};
  frame.y_min = 1e9;
  frame.y_max = -1e9;
  for (const RunSample& sample : samples) {
    for (const float value : {sample.joint_position_rad[joint], sample.joint_reference_rad[joint]}) {
      frame.y_min = std::min(frame.y_min, value * kDegrees - 1.0);
      frame.y_max = std::max(frame.y_max, value * kDegrees + 1.0);
    }
  }
  SvgPlot plot(frame);
  plot.line(series(samples,
                   [&](const RunSample& s) {
                     return Eigen::Vector2d(s.time_s, s.joint_reference_rad[joint] * kDegrees);
                   }),
            kGrey, "reference", 2.0);
  plot.line(series(samples,
                   [&](const RunSample& s) {
                     return Eigen::Vector2d(s.time_s, s.joint_position_rad[joint] * kDegrees);
                   }),
            kBlue, "measured");
  return plot.svg();
}

std::string bus_timeline(const ReportInput& input) {
  constexpr std::array<std::string_view, 9> kColours{kRed,      "#be185d", "#7c3aed", kOrange, kBlue,
                                                     "#b45309", kGreen,    "#0891b2", kGrey};
  const auto& cycle = input.recorder.cycle();
  if (cycle.empty()) {
    return "<p>No batch was played in this run.</p>";
  }
  const double start_ms = std::floor(static_cast<double>(cycle.front().start_ns) * 1e-6 / 80.0) * 80.0;
  PlotFrame frame{
      .title = fmt::format("{} frames of one cycle, from t = {:.3f} s", cycle.size(), start_ms * 1e-3),
      .x_label = "time in the cycle [ms]; slots are 10 ms long",
      .y_label = "",
      .x_min = 0.0,
      .x_max = 80.0,
      .y_min = 0.0,
      .y_max = 9.0,
      .height_px = 330.0,
      .left_px = 130.0};
  SvgPlot plot(frame);
  const can::Profile profile = msgcontroller::network_profile(input.robot);
  for (const can::MessageLayout& message : can::kMessageLayouts) {
    const auto row = static_cast<double>(message.kind);
    plot.y_tick(8.5 - row, message.name);
  }
  for (const auto& delivery : cycle) {
    const auto identified = profile.identify(delivery.frame.id);
    if (!identified) {
      continue;
    }
    const auto row = static_cast<std::size_t>(identified->kind);
    const double from = static_cast<double>(delivery.start_ns) * 1e-6 - start_ms;
    const double to = static_cast<double>(delivery.end_ns) * 1e-6 - start_ms;
    plot.box(from, to, 8.15 - static_cast<double>(row), 8.85 - static_cast<double>(row),
             kColours[row % kColours.size()],
             fmt::format("0x{:03X} node {} · {:.3f} ms · {} bits", delivery.frame.id, identified->node, from,
                         delivery.bits));
  }
  return plot.svg();
}

std::string compute_times(const ReportInput& input) {
  std::string rows;
  for (const core::PluginTiming& plugin : input.main_controller.plugins) {
    rows +=
        fmt::format("{:<16}{:>9}{:>10.1f}{:>10.1f}{:>10.1f}{:>8}\n", escape_html(plugin.name), plugin.steps,
                    plugin.step_us.p50, plugin.step_us.p99, plugin.step_us.max, plugin.faults);
  }
  const auto& batch = input.main_controller.batch_compute_us;
  return fmt::format(
      "<pre>{:<16}{:>9}{:>10}{:>10}{:>10}{:>8}\n{}{:<16}{:>9}{:>10.1f}{:>10.1f}{:>10.1f}</pre>\n", "plug-in",
      "steps", "p50 [us]", "p99 [us]", "max [us]", "faults", rows, "whole batch", "", batch.p50, batch.p99,
      batch.max);
}

std::string film_strip(const std::filesystem::path& file) {
  std::ifstream picture(file, std::ios::binary);
  if (!picture) {
    return {};
  }
  const std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(picture), {}};
  return fmt::format(
      "<h2>Pictures</h2>\n<img alt=\"the robot during the run\" src=\"data:image/png;base64,{}\">\n",
      base64(bytes));
}

std::string behaviour(const ReportInput& input) {
  const std::string timeline =
      input.recorder.mission().timeline(input.summary["virtual_seconds"].get<double>());
  if (timeline.empty()) return {};
  return "<h2>The behaviour</h2>\n<p>Green: success, red: failure, grey: halted, blue: it still runs.</p>\n" +
         timeline;
}

}  // namespace

void write_report(const std::filesystem::path& file, const ReportInput& input) {
  std::string joints;
  for (const urdf::Leg& leg : input.robot.legs) {
    for (const int joint : leg.joints) {
      joints += joint_tracking(input, static_cast<std::size_t>(joint));
    }
  }
  const std::string page = fmt::format(
      "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Gaitway run: {0}</title>"
      "<meta name=\"viewport\" content=\"width=device-width\"><style>{1}</style></head><body>\n"
      "<h1>{0}: a run of {2:.1f} s, seed {3}</h1>\n<pre>{4}</pre>\n{5}{12}"
      "<h2>The walk</h2>\n<p>Blue: left foot, orange: right foot. References are laid out from the true "
      "support foot.</p>\n{6}{7}{8}"
      "<h2>Joint tracking</h2>\n<p>Two seconds from the middle of the run; the legs.</p>\n{9}"
      "<h2>One 80 ms cycle of the bus</h2>\n<p>Hover over a frame for its identifier, node, time and "
      "length.</p>\n{10}"
      "<h2>Compute times</h2>\n<p>Wall time of each step, measured on this "
      "machine.</p>\n{11}</body></html>\n",
      escape_html(input.robot.name), kStyle, input.summary["virtual_seconds"].get<double>(),
      input.summary["seed"].get<std::uint64_t>(), escape_html(summary_table(input.summary)),
      film_strip(input.film_strip), from_above(input), zmp_over_time(input, 0), zmp_over_time(input, 1),
      joints, bus_timeline(input), compute_times(input), behaviour(input));
  process::replace_text_file(file, page);
}

}  // namespace gaitway::tools
