// A small chart as inline SVG: axes with round ticks, lines, bars, polygons, a legend. Enough for reports
// that open everywhere and carry no script.
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gaitway::tools {

struct PlotFrame {
  std::string title, x_label, y_label;
  double x_min = 0.0, x_max = 1.0, y_min = 0.0, y_max = 1.0;
  double width_px = 960.0, height_px = 300.0;
  double left_px = 64.0;     // room for the labels of the y ticks
  bool equal_scale = false;  // one metre is as long in x as in y: the y range grows to fit
};

class SvgPlot {
 public:
  explicit SvgPlot(const PlotFrame& frame);

  // Points with a NaN break the line.
  void line(std::span<const Eigen::Vector2d> points, std::string_view colour, std::string_view name,
            double width_px = 1.5);
  void polygon(std::span<const Eigen::Vector2d> corners, std::string_view stroke, std::string_view fill);
  // Below everything else, and cut off at the frame.
  void background(std::span<const Eigen::Vector2d> corners, std::string_view stroke, std::string_view fill,
                  std::string_view tooltip);
  // A filled box in data coordinates, with a tooltip.
  void box(double x0, double x1, double y0, double y1, std::string_view colour, std::string_view tooltip);
  void y_tick(double y, std::string_view label);  // instead of the numbers
  [[nodiscard]] std::string svg() const;

 private:
  [[nodiscard]] double px(double x) const;
  [[nodiscard]] double py(double y) const;
  void draw_axes(std::string& out) const;

  PlotFrame frame_;
  std::string background_;
  std::string body_;
  std::string legend_;
  double legend_x_px_ = 0.0;
  std::vector<std::pair<double, std::string>> y_ticks_;
};

// Escapes text for HTML and SVG.
std::string escape_html(std::string_view text);

}  // namespace gaitway::tools
