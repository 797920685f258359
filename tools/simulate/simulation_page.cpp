// One HTML file: the page's script and style, and the figures as JSON, whose arrays are 32-bit floats in
// base 64.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>

#include "gaitway/facts/facts.hpp"
#include "gaitway/process/text_file.hpp"
#include "tools/simulate/simulation_report.hpp"

namespace gaitway::tools {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kMostRows = 12'000;  // two minutes of each; longer ones are shown in larger steps

std::string base64(std::span<const float> values) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes(values.size_bytes());
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) word = (word << 8U) | (k < left ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= left ? kDigits[(word >> (18 - 6 * k)) & 63U] : '=';
  }
  return text;
}

ordered_json pose_json(const Eigen::Isometry3d& pose) {
  ordered_json json = ordered_json::array();
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 4; ++column) json.push_back(pose(row, column));
  }
  return json;
}

ordered_json robot_json(const urdf::RobotModel& robot) {
  ordered_json json{{"name", robot.name}};
  for (const urdf::Joint& joint : robot.joints) {
    json["joints"].push_back(
        {{"name", joint.name},
         {"parent", joint.parent_link},
         {"child", joint.child_link},
         {"origin", pose_json(joint.origin)},
         {"axis", {joint.axis.x(), joint.axis.y(), joint.axis.z()}},
         {"lower", joint.lower_rad},
         {"upper", joint.upper_rad},
         {"speed", std::min(joint.motor.speed_limit_rad_per_s, joint.velocity_limit_rad_per_s)},
         {"torque", joint.motor.torque_limit_Nm}});
  }
  for (const urdf::Link& link : robot.links) {
    ordered_json shapes = ordered_json::array();
    for (const urdf::Shape& shape : link.collision)
      shapes.push_back({{"pose", pose_json(shape.pose)},
                        {"size", {shape.size_m.x(), shape.size_m.y(), shape.size_m.z()}},
                        {"round", shape.kind == urdf::Shape::Kind::sphere}});
    json["links"].push_back({{"name", link.name}, {"shapes", shapes}});
  }
  for (const urdf::Foot& foot : robot.feet) {
    ordered_json corners = ordered_json::array();
    for (const Eigen::Vector2d& corner : foot.corners_m()) {
      const Eigen::Vector3d place = foot.sole * Eigen::Vector3d(corner.x(), corner.y(), 0.0);
      corners.push_back({place.x(), place.y(), place.z()});
    }
    json["feet"].push_back({{"link", foot.link}, {"corners", corners}});
  }
  return json;
}

// Every `step`-th row of what has `width` numbers a row.
template <class Values>
std::string rows_of(const Values& values, std::size_t width, std::size_t rows, std::size_t step) {
  std::vector<float> floats;
  for (std::size_t row = 0; row < rows; row += step) {
    for (std::size_t i = 0; i < width; ++i) floats.push_back(static_cast<float>(values[row * width + i]));
  }
  return base64(floats);
}

std::vector<double> flat(const std::vector<Eigen::Isometry3d>& poses) {
  std::vector<double> numbers;
  for (const Eigen::Isometry3d& pose : poses) {
    const Eigen::Quaterniond turn(pose.linear());
    numbers.insert(numbers.end(), {pose.translation().x(), pose.translation().y(), pose.translation().z(),
                                   turn.w(), turn.x(), turn.y(), turn.z()});
  }
  return numbers;
}

template <class Vectors>
std::vector<double> flat_vectors(const Vectors& vectors) {
  std::vector<double> numbers;
  for (const auto& vector : vectors) numbers.insert(numbers.end(), vector.begin(), vector.end());
  return numbers;
}

ordered_json course_json(const Played& played) {
  const kinematic::Trajectory& trajectory = played.trajectory;
  const kinematic::Course& course = played.course;
  const std::size_t rows = trajectory.rows(), joints = trajectory.joint_count;
  const std::size_t step = (rows + kMostRows - 1) / kMostRows;
  std::string contact;
  for (std::size_t row = 0; row < rows; row += step)
    contact += "BLRN"[static_cast<std::size_t>(course.contact[row])];
  ordered_json json{{"start_s", trajectory.start_s},
                    {"step_s", static_cast<double>(step) * facts::kSlot_s},
                    {"rows", contact.size()},
                    {"contact", contact},
                    {"angle", rows_of(trajectory.joint_rad, joints, rows, step)},
                    {"speed", rows_of(course.speed_rad_per_s, joints, rows, step)},
                    {"torque", rows_of(course.torque_Nm, joints, rows, step)},
                    {"base", rows_of(flat(course.base), 7, rows, step)},
                    {"com", rows_of(flat_vectors(course.com_m), 3, rows, step)}};
  if (!trajectory.reference_rad.empty())
    json["reference"] = rows_of(trajectory.reference_rad, joints, rows, step);
  for (const kinematic::ZmpSource source : kinematic::kZmpSources) {
    const kinematic::ZmpCourse& zmp = course.of(source);
    if (!zmp.known()) continue;
    const bool computed = source == kinematic::ZmpSource::planned && course.planned_is_computed;
    json["zmp"].push_back({{"name", computed ? "cart-table" : kinematic::name_of(source)},
                           {"place", kinematic::index_of(source)},
                           {"at", rows_of(flat_vectors(zmp.at_m), 2, rows, step)},
                           {"margin", rows_of(zmp.margin_m, 1, rows, step)},
                           {"least_at_s", zmp.least_at_s},
                           {"least_m", zmp.least_margin_m}});
  }
  return json;
}

// Nothing of it can end the element that it stands in.
std::string in_element(const ordered_json& json) {
  std::string text = json.dump();
  for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos;) text.replace(at, 1, "\\u003c");
  return text;
}

}  // namespace

void write_simulation_page(const std::filesystem::path& file, const Simulation& simulation) {
  ordered_json data = simulation_json(simulation);
  data["subject"] = simulation.subject == Subject::zmp ? "zmp" : "trajectory";
  data["model"] = robot_json(simulation.robot);
  for (std::size_t i = 0; i < simulation.played.size(); ++i)
    data["played"][i]["course"] = course_json(simulation.played[i]);
  process::write_text_file(
      file,
      fmt::format(
          "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">"
          "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src "
          "'nonce-gaitway'; "
          "style-src 'nonce-gaitway'; base-uri 'none'; form-action 'none'\">"
          "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"><title>Gaitway: "
          "simulation without "
          "dynamics</title>\n<style nonce=\"gaitway\">\n{}</style></head><body><main id=\"page\"></main>\n"
          "<script type=\"application/json\" id=\"data\">{}</script>\n<script "
          "nonce=\"gaitway\">\n{}</script></body>"
          "</html>\n",
          page_style(), in_element(data), page_script()));
}

}  // namespace gaitway::tools
