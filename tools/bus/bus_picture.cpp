// Bars for frames, over time.
#include "tools/bus/bus_measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>

#include "gaitway/can/frame.hpp"
#include "tools/run/svg_plot.hpp"

namespace gaitway::tools {
namespace {

using can::MessageKind;
using Frames = std::vector<can::TimedFrame>;

constexpr std::array<std::string_view, can::kMessageKinds> kColours{
    "#dc2626", "#be185d", "#7c3aed", "#ea580c", "#2563eb",
    "#b45309", "#059669", "#0891b2", "#94a3b8", "#65a30d"};
constexpr std::string_view kBoundColour = "#dc2626", kEdgeColour = "#64748b";
constexpr double kRow_px = 17.0, kAxes_px = 86.0;
constexpr double kSlot_ms = 10.0;

std::string_view colour_of(MessageKind kind) {
  return kColours[static_cast<std::size_t>(kind)];
}

double ms_since(std::int64_t time_ns, std::int64_t origin_ns) {
  return static_cast<double>(time_ns - origin_ns) * 1e-6;
}

// A file of its own needs a name space and a style, which a report's page has for all.
std::string stand_alone(const std::string& inline_svg) {
  constexpr std::string_view kOpening = "<svg ";
  const std::size_t end_of_tag = inline_svg.find('>') + 1;
  return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" " +
         inline_svg.substr(kOpening.size(), end_of_tag - kOpening.size()) +
         "\n<style>text{font:11px sans-serif;fill:#475569}.title{font-size:13px;font-weight:600;fill:#0f172a}"
         ".grid{stroke:#e2e8f0}</style>\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>" +
         inline_svg.substr(end_of_tag);
}

// One box for each message that is drawn stands in the legend.
class Legend {
 public:
  void add(SvgPlot& plot, MessageKind kind) {
    if (std::ranges::find(shown_, kind) == shown_.end()) {
      shown_.push_back(kind);
      plot.line({}, colour_of(kind), can::layout(kind).name);
    }
  }

 private:
  std::vector<MessageKind> shown_;
};

Frames slot_frames(const BusMeasurement& measurement, std::int64_t slot_start_ns) {
  Frames frames;
  std::copy_if(measurement.cycle().begin(), measurement.cycle().end(), std::back_inserter(frames),
               [&](const can::TimedFrame& frame) {
                 return frame.end_ns > slot_start_ns && frame.start_ns < slot_start_ns + facts::kSlot_ns;
               });
  return frames;
}

std::int64_t fullest_slot_ns(const BusMeasurement& measurement) {
  std::int64_t fullest_ns = measurement.cycle_start_ns();
  std::size_t most = 0;
  for (std::int64_t slot_ns = fullest_ns; slot_ns < measurement.cycle_start_ns() + facts::kCycle_ns;
       slot_ns += facts::kSlot_ns) {
    const std::size_t frames = slot_frames(measurement, slot_ns).size();
    if (frames > most) {
      most = frames;
      fullest_ns = slot_ns;
    }
  }
  return fullest_ns;
}

// When the frames of one slot were released, as far as the bus shows it.
class Releases {
 public:
  Releases(const BusRobot& robot, std::int64_t slot_start_ns)
      : robot_(robot), slot_start_ns_(slot_start_ns) {}

  std::optional<std::int64_t> of(const can::TimedFrame& frame, const can::Identified& message) {
    const bool synchronised = robot_.profile.has(MessageKind::sync);
    if (message.kind == MessageKind::sync) {
      answered_from_ns_ = frame.end_ns;
      return slot_start_ns_;
    }
    if (message.kind == MessageKind::trajectory) {
      if (!synchronised) {
        trajectory_end_ns_[message.node] = frame.end_ns;
        return slot_start_ns_ % facts::kCycle_ns == 0 ? std::optional(slot_start_ns_) : std::nullopt;
      }
      batch_start_ns_ = batch_start_ns_.value_or(frame.start_ns);
      return batch_start_ns_;
    }
    if (message.kind != MessageKind::feedback) {
      return std::nullopt;
    }
    const auto trajectory = trajectory_end_ns_.find(message.node);
    return synchronised                             ? answered_from_ns_
           : trajectory != trajectory_end_ns_.end() ? std::optional(trajectory->second)
                                                    : std::nullopt;
  }

 private:
  const BusRobot& robot_;
  std::int64_t slot_start_ns_;
  std::optional<std::int64_t> answered_from_ns_, batch_start_ns_;
  std::map<can::NodeId, std::int64_t> trajectory_end_ns_;
};

std::optional<std::int64_t> bound_ns(const BusRobot& robot, std::uint32_t id) {
  const auto message = robot.profile.identify(id);
  const std::uint32_t analysed = robot.profile.id_of(message->kind, message->node);  // both toggles are one
  for (std::size_t i = 0; i < robot.proof.messages.size(); ++i) {
    if (robot.proof.messages[i].id == analysed) {
      return robot.proof.responses[i].worst_response_ns;
    }
  }
  return std::nullopt;
}

// Rows from the top in order of priority.
std::map<std::uint32_t, double> rows_of(const Frames& frames, const can::Profile& profile) {
  std::map<std::uint32_t, double> rows;
  for (const can::TimedFrame& frame : frames) {
    if (profile.identify(frame.frame.id)) {
      rows[frame.frame.id] = 0.0;
    }
  }
  double row = static_cast<double>(rows.size());
  for (auto& [id, y] : rows) {
    y = row -= 1.0;
  }
  return rows;
}

std::string row_label(const can::Profile& profile, std::uint32_t id) {
  const can::Identified message = *profile.identify(id);
  const std::string_view name = can::layout(message.kind).name;
  return message.node == 0 ? fmt::format("0x{:03X} {}", id, name)
                           : fmt::format("0x{:03X} {} {}", id, name, message.node);
}

void draw_frame(SvgPlot& plot, const can::TimedFrame& frame, const can::Identified& message, double row,
                std::int64_t origin_ns) {
  plot.box(ms_since(frame.start_ns, origin_ns), ms_since(frame.end_ns, origin_ns), row + 0.12, row + 0.88,
           colour_of(message.kind),
           fmt::format("0x{:03X} node {}, {:.3f}..{:.3f} ms, {} bits", frame.frame.id, message.node,
                       ms_since(frame.start_ns, origin_ns), ms_since(frame.end_ns, origin_ns),
                       can::frame_bits(frame.frame)));
}

void vertical(SvgPlot& plot, double x, double y0, double y1, std::string_view colour, std::string_view name,
              double width_px) {
  const std::array<Eigen::Vector2d, 2> points{Eigen::Vector2d(x, y0), Eigen::Vector2d(x, y1)};
  plot.line(points, colour, name, width_px);
}

// Of each identifier whose release the bus shows, since the slot's edge.
std::map<std::uint32_t, double> latest_arrivals_ms(const Frames& frames, const BusRobot& robot,
                                                   std::int64_t slot_start_ns) {
  std::map<std::uint32_t, double> latest_ms;
  Releases releases(robot, slot_start_ns);
  for (const can::TimedFrame& frame : frames) {
    const auto message = robot.profile.identify(frame.frame.id);
    const auto released_ns = message ? releases.of(frame, *message) : std::nullopt;
    const auto longest_ns = message ? bound_ns(robot, frame.frame.id) : std::nullopt;
    if (released_ns && longest_ns) {
      latest_ms[frame.frame.id] = ms_since(*released_ns + *longest_ns, slot_start_ns);
    }
  }
  return latest_ms;
}

}  // namespace

std::string slot_picture(const BusMeasurement& measurement, const BusRobot& robot) {
  if (measurement.cycle().empty()) {
    return {};
  }
  const std::int64_t start_ns = fullest_slot_ns(measurement);
  const Frames frames = slot_frames(measurement, start_ns);
  const auto rows = rows_of(frames, robot.profile);
  const auto marks_ms = latest_arrivals_ms(frames, robot, start_ns);
  double last_ms = kSlot_ms;
  for (const auto& [id, mark_ms] : marks_ms) {
    last_ms = std::max(last_ms, std::ceil(mark_ms));
  }
  SvgPlot plot({.title = fmt::format("One time slot on the bus, profile {}: {} frames from t = {:.2f} s",
                                     robot.profile.name, frames.size(), static_cast<double>(start_ns) * 1e-9),
                .x_label = "time since the slot's edge [ms]",
                .y_label = "",
                .x_min = 0.0,
                .x_max = last_ms,
                .y_min = 0.0,
                .y_max = static_cast<double>(rows.size()),
                .height_px = kAxes_px + kRow_px * static_cast<double>(rows.size()),
                .left_px = 136.0});
  vertical(plot, kSlot_ms, 0.0, static_cast<double>(rows.size()), kEdgeColour, "", 0.7);
  Legend legend;
  for (const auto& [id, row] : rows) {
    plot.y_tick(row + 0.5, row_label(robot.profile, id));
    legend.add(plot, robot.profile.identify(id)->kind);
  }
  plot.line({}, kBoundColour, "latest arrival that the analysis allows");
  for (const can::TimedFrame& frame : frames) {
    if (const auto message = robot.profile.identify(frame.frame.id)) {
      draw_frame(plot, frame, *message, rows.at(frame.frame.id), start_ns);
    }
  }
  for (const auto& [id, mark_ms] : marks_ms) {
    vertical(plot, mark_ms, rows.at(id) + 0.1, rows.at(id) + 0.9, kBoundColour, "", 2.0);
  }
  return stand_alone(plot.svg());
}

std::string cycle_picture(const BusMeasurement& measurement, const BusRobot& robot) {
  if (measurement.cycle().empty()) {
    return {};
  }
  const std::int64_t start_ns = measurement.cycle_start_ns();
  std::map<MessageKind, double> rows;
  for (const can::MessageLayout& message : can::kMessageLayouts) {
    if (robot.profile.has(message.kind)) {
      rows[message.kind] = 0.0;
    }
  }
  double y = static_cast<double>(rows.size());
  const double top = y;
  SvgPlot plot({.title = fmt::format("One cycle on the bus, profile {}: {} frames from t = {:.2f} s",
                                     robot.profile.name, measurement.cycle().size(),
                                     static_cast<double>(start_ns) * 1e-9),
                .x_label = "time in the cycle [ms]; slots are 10 ms long",
                .y_label = "",
                .x_min = 0.0,
                .x_max = 80.0,
                .y_min = 0.0,
                .y_max = top,
                .height_px = kAxes_px + 2.0 * kRow_px * top,
                .left_px = 136.0});
  for (auto& [kind, row] : rows) {
    row = y -= 1.0;
    plot.y_tick(row + 0.5, can::layout(kind).name);
  }
  for (int slot = 1; slot < 8; ++slot) {
    vertical(plot, 10.0 * slot, 0.0, top, kEdgeColour, "", 0.7);
  }
  for (const can::TimedFrame& frame : measurement.cycle()) {
    if (const auto message = robot.profile.identify(frame.frame.id)) {
      draw_frame(plot, frame, *message, rows.at(message->kind), start_ns);
    }
  }
  return stand_alone(plot.svg());
}

}  // namespace gaitway::tools
