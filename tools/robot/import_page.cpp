// A table of findings, twice: plain and as HTML.
#include "tools/robot/import_page.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "gaitway/process/text_file.hpp"
#include "gaitway/simulator/camera.hpp"
#include "gaitway/simulator/plant.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "tools/run/svg_plot.hpp"

namespace gaitway::tools {
namespace {

constexpr int kPictureWidth_px = 640, kPictureHeight_px = 720;
constexpr std::size_t kNamed = 6;  // of a long list

using Finding = std::pair<std::string, std::string>;

std::string shortened(std::vector<std::string> names) {
  const std::size_t all = names.size();
  if (all > kNamed) names.resize(kNamed);
  return fmt::format("{}{}", fmt::join(names, ", "),
                     all > kNamed ? fmt::format(" and {} more", all - kNamed) : "");
}

std::string guessed_drives(const importer::ImportedRobot& imported) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < imported.drives.size(); ++i) {
    if (!imported.drives[i].guessed.empty()) names.push_back(imported.robot.joints[i].name);
  }
  return names.empty() ? "speed and torque of each motor are the URDF's"
                       : fmt::format("speed or torque guessed for {} of {}: {}", names.size(),
                                     imported.drives.size(), shortened(names));
}

double between_soles_m(const urdf::RobotModel& robot) {
  const urdf::ForwardKinematics home(robot);
  return home.sole_pose(urdf::Side::left).translation().y() -
         home.sole_pose(urdf::Side::right).translation().y();
}

// One text for both, where they are alike.
std::string soles_text(const std::array<importer::FoundSole, 2>& soles) {
  const auto text = [](const importer::FoundSole& sole) {
    return fmt::format("{:.3f} x {:.3f} m, {}", sole.size_m.x(), sole.size_m.y(), sole.source);
  };
  const std::string left = text(soles[0]), right = text(soles[1]);
  return left == right ? left : fmt::format("left {}; right {}", left, right);
}

std::vector<Finding> findings(const ImportSummary& summary) {
  const importer::ImportedRobot& found = summary.imported;
  const auto leg = [&](std::size_t side) {
    return fmt::format("{} -> {}", fmt::join(found.plan.legs[side].joints, ", "), found.plan.legs[side].foot);
  };
  std::vector<Finding> all{
      {"robot", fmt::format("{}, {:.2f} kg, hips {:.3f} m above the soles", summary.robot.name,
                            summary.robot.total_mass_kg(), summary.robot.hip_height_m)},
      {"left leg", leg(0)},
      {"right leg", leg(1)},
      {"soles", soles_text(found.soles)},
      {"home posture",
       fmt::format("soles level, {:.3f} m apart, knees bent by {:.0f} deg", between_soles_m(summary.robot),
                   found.home.knee_bend_rad * 180.0 / std::numbers::pi)},
      {"IMU", fmt::format("{} on the link '{}'", found.imu.why, found.imu.link)},
      {"joints",
       fmt::format("{} move{}", found.robot.joints.size(),
                   found.held_still.empty() ? std::string()
                                            : fmt::format(", {} are held still: {}", found.held_still.size(),
                                                          shortened(found.held_still)))},
      {"motors", guessed_drives(found)},
      {"bus", summary.bus}};
  return all;
}

}  // namespace

std::string import_text(const ImportSummary& summary) {
  std::string text;
  for (const auto& [name, value] : findings(summary)) text += fmt::format("  {:<14}{}\n", name, value);
  for (const std::string& note : summary.imported.notes) text += fmt::format("  note: {}\n", note);
  return text;
}

urdf::RobotModel with_visible_colours(urdf::RobotModel robot) {
  constexpr double kDarkest = 0.25;  // of white
  const Eigen::Vector3d luminance(0.2126, 0.7152, 0.0722);
  for (urdf::Link& link : robot.links) {
    for (urdf::Shape& shape : link.visual) {
      auto colour = shape.rgba.head<3>();
      const double seen = luminance.dot(colour);
      if (seen < kDarkest) colour += (kDarkest - seen) / (1.0 - seen) * (Eigen::Vector3d::Ones() - colour);
    }
  }
  return robot;
}

std::string write_import_page(const ImportSummary& summary, const std::filesystem::path& folder) {
  std::string without_picture;
  try {
    const simulator::Plant plant(with_visible_colours(summary.robot), {.mismatch = 0.0});
    simulator::Camera camera(plant, kPictureWidth_px, kPictureHeight_px);
    const std::vector<simulator::Image> images{camera.render(plant.positions())};
    simulator::write_film_strip((folder / "robot.png").string(), images, 1);
  } catch (const std::runtime_error& error) {
    without_picture = error.what();
  }
  std::string page = fmt::format(
      "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>{0}</title><style>\n"
      "body{{font:15px/1.45 system-ui,sans-serif;max-width:1100px;margin:2em auto;padding:0 "
      "1em;color:#222;background:#fff}}\n"
      "main{{display:flex;gap:2em;flex-wrap:wrap}}img{{width:320px;height:auto;align-self:flex-start}}\n"
      "section{{flex:1 1 420px}}th,td{{text-align:left;vertical-align:top;padding:.3em "
      ".6em;border-bottom:1px solid #ddd;"
      "overflow-wrap:anywhere}}\n</style><h1>{0}</h1><main>{1}<section><table>\n",
      escape_html(summary.robot.name),
      without_picture.empty() ? "<img src=\"robot.png\" alt=\"the robot in its home posture\">" : "");
  for (const auto& [name, value] : findings(summary)) {
    page += fmt::format("<tr><th>{}</th><td>{}</td></tr>\n", escape_html(name), escape_html(value));
  }
  page += "</table><h2>What was done and guessed</h2><ul>\n";
  for (const std::string& note : summary.imported.notes)
    page += fmt::format("<li>{}</li>\n", escape_html(note));
  page +=
      "</ul><p>Every guess has a comment in <code>robot.yaml</code>: correct it where you know "
      "better.</p></section></main></html>\n";
  process::write_text_file(folder / "import.html", page);
  return without_picture;
}

}  // namespace gaitway::tools
