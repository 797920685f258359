// The page: the table, and what it does not show.
#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "tools/measure/gait_measurement.hpp"
#include "tools/run/svg_plot.hpp"

namespace gaitway::tools {
namespace {

constexpr std::string_view kStyle = R"(<style>
body{font:15px/1.45 system-ui,sans-serif;max-width:1000px;margin:2em auto;padding:0 1em;color:#222;background:#fff}
table{border-collapse:collapse;width:100%}
th,td{text-align:left;padding:.3em .6em;border-bottom:1px solid #ddd}
td.holds{color:#17692b}td.fails{color:#a11}
svg{max-width:100%;height:auto}svg text{font:11px system-ui,sans-serif;fill:#333}
svg .title{font-size:14px;font-weight:600}svg .grid{stroke:#e4e4e4}
figure{display:inline-block;margin:0 .5em 1em 0}
</style>)";

std::string colour_of(std::uint64_t seed) {
  constexpr double kGoldenAngle_deg = 137.5;
  return fmt::format("hsl({:.0f} 60% 42%)", std::fmod(kGoldenAngle_deg * static_cast<double>(seed), 360.0));
}

std::string table(const GaitMeasurement& measurement) {
  std::string html =
      "<table><tr><th>measure</th><th>floor</th><th>seeds at the floor</th><th>aim</th><th>limit (19 of 20 "
      "seeds)</th></tr>\n";
  for (const RowResult& result : measurement.rows) {
    html += fmt::format("<tr><td>{}</td><td>{}</td><td class=\"{}\">{}</td><td>{}</td><td>{}</td></tr>\n",
                        escape_html(result.row.measure), shown(result.row, result.row.floor),
                        result.floor_holds() ? "holds" : "fails", shown_floor(result),
                        shown(result.row, result.row.aim), escape_html(shown_limit(result)));
  }
  return html + "</table>\n";
}

// A tick for each trial, at what was asked for: per cent of it that were held. Falls stand at zero.
std::string speed_plot(const RowResult& result) {
  struct Mark {
    double x, held_percent;
    std::uint64_t seed;
    bool fell;
  };
  std::vector<Mark> marks;
  double low = 80.0, high = 120.0, from = 1e9, to = -1e9;
  for (const LevelResult& level : result.levels) {
    for (const SeedResult& seed : level.seeds) {
      for (std::size_t i = 0; i < seed.trials.size(); ++i) {
        const double wanted = seed.trials[i].commands.front().velocity.norm();
        const bool fell = seed.outcomes[i].fell;
        const double held = fell ? 0.0 : 100.0 * true_speed(seed.outcomes[i], seed.trials[i]) / wanted;
        const double x = result.row.has_levels() ? level.level : static_cast<double>(i);
        marks.push_back({x, held, seed.seed, fell});
        low = std::min(low, held - 5.0);
        high = std::max(high, held + 5.0);
        from = std::min(from, x);
        to = std::max(to, x);
      }
    }
  }
  const double width = std::max(to - from, 1e-3) / 40.0;
  const double height = (high - low) / 150.0;
  SvgPlot plot({.title = "Speed held, seed by seed (falls at 0)",
                .x_label = result.row.has_levels()
                               ? "command, " + result.row.unit
                               : "direction: counter-clockwise from ahead, then both turns",
                .y_label = "held, % of command",
                .x_min = from - 2.0 * width,
                .x_max = to + 2.0 * width,
                .y_min = low,
                .y_max = high});
  for (const Mark& mark : marks) {
    plot.box(mark.x - width / 2.0, mark.x + width / 2.0, mark.held_percent - height / 2.0,
             mark.held_percent + height / 2.0, mark.fell ? "#a11" : colour_of(mark.seed),
             fmt::format("seed {}: {}", mark.seed,
                         mark.fell ? "fell" : fmt::format("{:.1f} %", mark.held_percent)));
  }
  return plot.svg();
}

std::string heading_plot(const RowResult& result) {
  double largest_deg = 1.0, seconds = 1.0;
  for (const SeedResult& seed : result.levels.front().seeds) {
    for (const TrialOutcome& outcome : seed.outcomes) {
      seconds = std::max(seconds, static_cast<double>(outcome.heading_deg.size()));
      for (const float drift_deg : outcome.heading_deg) {
        largest_deg = std::max(largest_deg, static_cast<double>(std::abs(drift_deg)));
      }
    }
  }
  SvgPlot plot({.title = "Heading, seed by seed",
                .x_label = "time, s",
                .y_label = "heading, deg",
                .x_min = 0.0,
                .x_max = seconds,
                .y_min = -1.05 * largest_deg,
                .y_max = 1.05 * largest_deg});
  for (const SeedResult& seed : result.levels.front().seeds) {
    std::vector<Eigen::Vector2d> points;
    // The first second is the stand that the drift is measured against.
    const std::vector<float>& heading_deg = seed.outcomes.front().heading_deg;
    for (std::size_t second = 0; second < heading_deg.size(); ++second) {
      points.emplace_back(static_cast<double>(second + 1), heading_deg[second]);
    }
    plot.line(points, colour_of(seed.seed), "");
  }
  return plot.svg();
}

// Rows with a figure: a bar for each seed.
std::string figure_plot(const RowResult& result) {
  const GaitRow& row = result.row;
  const std::vector<SeedResult>& seeds = result.levels.front().seeds;
  double largest = 1.2 * row.floor * row.shown_scale;
  for (const SeedResult& seed : seeds) {
    largest = std::isfinite(seed.figure) ? std::max(largest, 1.05 * row.shown_scale * seed.figure) : largest;
  }
  const auto count = static_cast<double>(seeds.size());
  SvgPlot plot({.title = "Seed by seed (falls in red)",
                .x_label = "seed",
                .y_label = row.unit,
                .x_min = static_cast<double>(seeds.front().seed) - 0.5,
                .x_max = static_cast<double>(seeds.front().seed) + count - 0.5,
                .y_min = 0.0,
                .y_max = largest,
                .height_px = 220.0});
  for (const SeedResult& seed : seeds) {
    const bool fell = !std::isfinite(seed.figure);
    const double height = fell ? largest : seed.figure * row.shown_scale;
    const auto x = static_cast<double>(seed.seed);
    plot.box(x - 0.35, x + 0.35, 0.0, height, fell ? "#a11" : colour_of(seed.seed),
             fmt::format("seed {}: {}", seed.seed, shown(row, seed.figure)));
  }
  const std::array<Eigen::Vector2d, 2> floor{
      Eigen::Vector2d(static_cast<double>(seeds.front().seed) - 0.5, row.floor * row.shown_scale),
      Eigen::Vector2d(static_cast<double>(seeds.front().seed) + count - 0.5, row.floor * row.shown_scale)};
  plot.line(floor, "#555", "floor");
  return plot.svg();
}

// Rows whose seeds pass or do not.
std::string failed_seeds(const RowResult& result) {
  std::string failed;
  for (const SeedResult& seed : result.levels.front().seeds) {
    failed += seed.passed ? "" : fmt::format(" {}", seed.seed);
  }
  return fmt::format("<p>Seeds that fail:{}</p>\n", failed.empty() ? " none" : failed);
}

// Levels over seeds that passed them.
std::string survival_plot(const RowResult& result) {
  SvgPlot plot({.title = "Seeds that pass; a level is given up once it cannot hold any more",
                .x_label = result.row.unit,
                .y_label = "% of the seeds that count",
                .x_min = 0.0,
                .x_max = 1.05 * result.row.shown_scale * result.row.levels.back(),
                .y_min = 0.0,
                .y_max = 105.0,
                .height_px = 200.0});
  const double width = result.row.shown_scale * result.row.levels.back() / 80.0;
  for (const LevelResult& level : result.levels) {
    const double x = level.level * result.row.shown_scale;
    const double share =
        level.seeds.empty() ? 0.0 : 100.0 * level.passed / static_cast<double>(level.seeds.size());
    plot.box(x - width / 2.0, x + width / 2.0, 0.0, std::max(share, 1.0), level.holds ? "#2a7d46" : "#b5651d",
             fmt::format("{}: {} of {}", shown(result.row, level.level), level.passed, level.seeds.size()));
  }
  return plot.svg();
}

std::string push_maps(const RowResult& result) {
  std::string html =
      "<p>Sectors: where the push drives the robot. Rings, from the inside: instants of the gait cycle. "
      "Green: "
      "all survive, red: none, grey: not tried, since a seed ends with its first fall. In the middle: the "
      "impulse in N·s.</p>\n";
  for (const LevelResult& level : result.levels) {
    html += "<figure>" + push_map(result, level) + "</figure>\n";
  }
  return html;
}

std::string pictures_of(const RowResult& result) {
  std::string html = fmt::format("<h2>{}</h2>\n", escape_html(result.row.measure));
  if (result.row.has_levels()) {
    html += survival_plot(result);
  } else if (result.row.has_figure()) {
    html += figure_plot(result);
  } else {
    html += failed_seeds(result);
  }
  switch (result.row.picture) {
    case GaitRow::Picture::speeds:
      return html + speed_plot(result);
    case GaitRow::Picture::headings:
      return html + heading_plot(result);
    case GaitRow::Picture::pushes:
      return html + push_maps(result);
    case GaitRow::Picture::none:
      break;
  }
  return html;
}

}  // namespace

std::string gait_page(const GaitReportHead& head, const GaitMeasurement& measurement) {
  std::string html = fmt::format(
      "<!doctype html><html lang=\"en\"><head><meta "
      "charset=\"utf-8\"><title>Gait</title>{}</head><body>\n<h1>Gait</h1>\n"
      "<p>{}</p>\n",
      kStyle, escape_html(shown_head(head)));
  html += table(measurement);
  for (const RowResult& result : measurement.rows) {
    html += pictures_of(result);
  }
  return html + "</body></html>\n";
}

}  // namespace gaitway::tools
