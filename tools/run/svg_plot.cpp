// Draws charts as SVG text.
#include "tools/run/svg_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gaitway::tools {
namespace {

constexpr double kRight_px = 16.0, kTop_px = 44.0, kBottom_px = 42.0;

// 1, 2 or 5 times a power of ten, so that about `wanted` ticks fit the range.
double tick_step(double range, double wanted) {
  const double raw = range / wanted;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (raw <= factor * power) {
      return factor * power;
    }
  }
  return 10.0 * power;
}

std::string tick_label(double value, double step) {
  const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  return fmt::format("{:.{}f}", std::abs(value) < step * 1e-6 ? 0.0 : value, decimals);
}

}  // namespace

std::string escape_html(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      default:
        result += c;
    }
  }
  return result;
}

SvgPlot::SvgPlot(const PlotFrame& frame) : frame_(frame) {
  if (frame_.x_max <= frame_.x_min) {
    frame_.x_max = frame_.x_min + 1e-3;
  }
  if (frame_.y_max <= frame_.y_min) {
    frame_.y_max = frame_.y_min + 1e-3;
  }
  if (frame_.equal_scale) {
    const double metres_per_px =
        (frame_.x_max - frame_.x_min) / (frame_.width_px - frame_.left_px - kRight_px);
    const double needed_px = (frame_.y_max - frame_.y_min) / metres_per_px;
    frame_.height_px = std::clamp(needed_px, 120.0, 700.0) + kTop_px + kBottom_px;
    const double grow =
        (frame_.height_px - kTop_px - kBottom_px) * metres_per_px - (frame_.y_max - frame_.y_min);
    frame_.y_min -= grow / 2;
    frame_.y_max += grow / 2;
  }
}

double SvgPlot::px(double x) const {
  return frame_.left_px +
         (x - frame_.x_min) / (frame_.x_max - frame_.x_min) * (frame_.width_px - frame_.left_px - kRight_px);
}

double SvgPlot::py(double y) const {
  return frame_.height_px - kBottom_px -
         (y - frame_.y_min) / (frame_.y_max - frame_.y_min) * (frame_.height_px - kTop_px - kBottom_px);
}

void SvgPlot::line(std::span<const Eigen::Vector2d> points, std::string_view colour, std::string_view name,
                   double width_px) {
  std::string path;
  bool pen_down = false;
  for (const Eigen::Vector2d& point : points) {
    if (!point.allFinite()) {
      pen_down = false;
      continue;
    }
    path += fmt::format("{}{:.1f} {:.1f}", pen_down ? "L" : "M", px(point.x()), py(point.y()));
    pen_down = true;
  }
  body_ += fmt::format(
      "<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"/>\n", path,
      colour, width_px);
  if (!name.empty()) {
    const double x = frame_.left_px + legend_x_px_;
    legend_ += fmt::format(
        "<line x1=\"{0:.0f}\" x2=\"{1:.0f}\" y1=\"32\" y2=\"32\" stroke=\"{2}\" stroke-width=\"3\"/>"
        "<text x=\"{3:.0f}\" y=\"36\">{4}</text>\n",
        x, x + 18, colour, x + 24, escape_html(name));
    legend_x_px_ += 40.0 + 6.8 * static_cast<double>(name.size());
  }
}

void SvgPlot::polygon(std::span<const Eigen::Vector2d> corners, std::string_view stroke,
                      std::string_view fill) {
  std::string points;
  for (const Eigen::Vector2d& corner : corners) {
    points += fmt::format("{:.1f},{:.1f} ", px(corner.x()), py(corner.y()));
  }
  body_ += fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"{}\"/>\n", points, fill, stroke);
}

void SvgPlot::background(std::span<const Eigen::Vector2d> corners, std::string_view stroke,
                         std::string_view fill, std::string_view tooltip) {
  std::string points;
  for (const Eigen::Vector2d& corner : corners) {
    points += fmt::format("{:.1f},{:.1f} ", px(corner.x()), py(corner.y()));
  }
  background_ += fmt::format("<polygon points=\"{}\" fill=\"{}\" stroke=\"{}\"><title>{}</title></polygon>\n",
                             points, fill, stroke, escape_html(tooltip));
}

void SvgPlot::box(double x0, double x1, double y0, double y1, std::string_view colour,
                  std::string_view tooltip) {
  body_ += fmt::format(
      "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" "
      "fill=\"{}\"><title>{}</title></rect>\n",
      px(x0), py(y1), std::max(px(x1) - px(x0), 0.5), py(y0) - py(y1), colour, escape_html(tooltip));
}

void SvgPlot::y_tick(double y, std::string_view label) {
  y_ticks_.emplace_back(y, label);
}

void SvgPlot::draw_axes(std::string& out) const {
  const double bottom = frame_.height_px - kBottom_px, right = frame_.width_px - kRight_px;
  const double x_step = tick_step(frame_.x_max - frame_.x_min, 10.0);
  for (double x = std::ceil(frame_.x_min / x_step) * x_step; x <= frame_.x_max + 1e-9 * x_step; x += x_step) {
    out += fmt::format(
        "<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{0:.1f}\" y1=\"{1:.1f}\" y2=\"{2:.1f}\"/>"
        "<text x=\"{0:.1f}\" y=\"{3:.1f}\" text-anchor=\"middle\">{4}</text>\n",
        px(x), kTop_px, bottom, bottom + 15, tick_label(x, x_step));
  }
  auto ticks = y_ticks_;
  if (ticks.empty()) {
    const double y_step = tick_step(frame_.y_max - frame_.y_min, (bottom - kTop_px) / 45.0);
    for (double y = std::ceil(frame_.y_min / y_step) * y_step; y <= frame_.y_max + 1e-9 * y_step;
         y += y_step) {
      ticks.emplace_back(y, tick_label(y, y_step));
    }
  }
  for (const auto& [y, label] : ticks) {
    out += fmt::format(
        "<line class=\"grid\" x1=\"{0:.1f}\" x2=\"{1:.1f}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\"/>"
        "<text x=\"{3:.1f}\" y=\"{4:.1f}\" text-anchor=\"end\">{5}</text>\n",
        frame_.left_px, right, py(y), frame_.left_px - 6, py(y) + 4, escape_html(label));
  }
  out += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n",
                     (frame_.left_px + right) / 2, frame_.height_px - 6, escape_html(frame_.x_label));
  out +=
      fmt::format("<text transform=\"translate(14 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                  (kTop_px + bottom) / 2, escape_html(frame_.y_label));
}

std::string SvgPlot::svg() const {
  std::string out = fmt::format("<svg viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" role=\"img\">\n",
                                frame_.width_px, frame_.height_px);
  out += fmt::format("<text class=\"title\" x=\"{:.0f}\" y=\"16\">{}</text>\n", frame_.left_px,
                     escape_html(frame_.title));
  if (!background_.empty()) {  // an inner picture of the frame's size cuts off what is beyond
    out += fmt::format(
        "<svg x=\"{0:.1f}\" y=\"{1:.1f}\" width=\"{2:.1f}\" height=\"{3:.1f}\" viewBox=\"{0:.1f} {1:.1f} "
        "{2:.1f} {3:.1f}\">\n{4}</svg>\n",
        frame_.left_px, kTop_px, frame_.width_px - frame_.left_px - kRight_px,
        frame_.height_px - kTop_px - kBottom_px, background_);
  }
  draw_axes(out);
  out += body_ + legend_ + "</svg>\n";
  return out;
}

}  // namespace gaitway::tools
