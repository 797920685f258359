// The same figures as lines and as JSON.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gaitway/facts/facts.hpp"
#include "tools/simulate/simulation_report.hpp"

namespace gaitway::tools {
namespace {

using kinematic::Course;
using kinematic::Finding;
using kinematic::JointUse;
using kinematic::ZmpCourse;
using kinematic::ZmpSource;
using nlohmann::ordered_json;

constexpr std::size_t kMostTold = 20;  // findings, on a terminal
constexpr double kDegree = facts::kRadPerDegree;

std::string joints_text(const urdf::RobotModel& robot, const Played& played) {
  const bool points = played.trajectory.points_of_wire;
  std::string text = fmt::format("  {:<22}{:>9}{:>9}{:>13}{:>13}{:>8}{}\n", "joint", "from deg", "to deg",
                                 "speed rad/s", "torque N·m", "share", points ? "  counts a point" : "");
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const JointUse& use = played.course.joints[j];
    text += fmt::format("  {:<22}{:>9.2f}{:>9.2f}{:>13.3f}{:>12.3f}{:>7.0f}%{}\n", robot.joints[j].name,
                        use.lowest_rad / kDegree, use.highest_rad / kDegree, use.fastest_rad_per_s,
                        use.largest_torque_Nm, 100.0 * use.torque_share,
                        points ? fmt::format("{:>16}", use.largest_step_counts) : "");
  }
  return text;
}

std::string stands_text(const Course& course) {
  std::string text;
  for (const urdf::Side side : urdf::kSides) {
    std::size_t count = 0;
    double stood_s = 0.0;
    for (const kinematic::Stand& stand : course.stands) {
      if (stand.side != side) continue;
      ++count;
      stood_s += stand.to_s - stand.from_s;
    }
    text += fmt::format("  {:<22}stands {} time{}, {:.2f} s in all\n",
                        side == urdf::Side::left ? "left sole" : "right sole", count, count == 1 ? "" : "s",
                        stood_s);
  }
  return text;
}

std::string zmp_name(const Course& course, ZmpSource source) {
  const bool computed = source == ZmpSource::planned && course.planned_is_computed;
  return computed ? "cart-table (of the CoM)" : std::string(kinematic::name_of(source));
}

std::string zmp_text(const Course& course) {
  std::string text = fmt::format("  {:<26}{:>16}{:>12}{:>16}\n", "ZMP over the support", "least margin mm",
                                 "at s", "mean margin mm");
  for (const ZmpSource source : kinematic::kZmpSources) {
    const ZmpCourse& zmp = course.of(source);
    text += zmp.known() ? fmt::format("  {:<26}{:>16.1f}{:>12.3f}{:>16.1f}\n", zmp_name(course, source),
                                      1e3 * zmp.least_margin_m, zmp.least_at_s, 1e3 * zmp.mean_margin_m)
                        : fmt::format("  {:<26}{:>16}\n", zmp_name(course, source), "not known here");
  }
  return text;
}

std::string findings_text(const std::vector<Finding>& findings) {
  if (findings.empty()) return "  findings: none\n";
  std::string text = fmt::format("  findings: {}\n", findings.size());
  for (std::size_t i = 0; i < std::min(findings.size(), kMostTold); ++i)
    text += fmt::format("    {}\n", kinematic::describe(findings[i]));
  if (findings.size() > kMostTold)
    text +=
        fmt::format("    and {} more; --json and the report have all of them\n", findings.size() - kMostTold);
  return text;
}

std::string played_text(const Simulation& simulation, const Played& played) {
  const double factor = played.playing_s > 0.0 ? played.duration_s() / played.playing_s : 0.0;
  std::string text =
      fmt::format("{} ({}): {:.2f} s in {} rows, played at {:.0f} x real time, read in {:.2f} s\n",
                  played.trajectory.name, played.trajectory.kind, played.duration_s(),
                  played.trajectory.rows(), factor, played.reading_s);
  for (const std::string& note : played.course.notes) text += fmt::format("  note: {}\n", note);
  if (simulation.subject == Subject::trajectory) {
    text += joints_text(simulation.robot, played) + stands_text(played.course);
    text +=
        fmt::format("  {:<22}{} pairs of links looked at\n", "self-collision", played.course.collision_pairs);
  }
  return text + zmp_text(played.course) + findings_text(played.course.findings);
}

std::string comparison_text(const Simulation& simulation) {
  const auto differences =
      kinematic::compare(simulation.played[0].trajectory, simulation.played[1].trajectory);
  std::string text =
      fmt::format("{} against {}\n  {:<22}{:>12}{:>14}{:>10}\n", simulation.played[0].trajectory.name,
                  simulation.played[1].trajectory.name, "joint", "rms deg", "largest deg", "at s");
  for (std::size_t j = 0; j < differences.size(); ++j) {
    text += fmt::format("  {:<22}{:>12.3f}{:>14.3f}{:>10.3f}\n", simulation.robot.joints[j].name,
                        differences[j].rms_rad / kDegree, differences[j].largest_rad / kDegree,
                        differences[j].largest_at_s);
  }
  return text;
}

ordered_json json_of(const Finding& finding) {
  return {{"rule", kinematic::name_of(finding.rule)},
          {"meaning", kinematic::meaning_of(finding.rule)},
          {"what", finding.what},
          {"at_s", finding.at_s},
          {"from_s", finding.from_s},
          {"to_s", finding.to_s},
          {"value", finding.value},
          {"limit", finding.limit},
          {"unit", finding.unit}};
}

ordered_json zmp_json(const Course& course) {
  ordered_json json = ordered_json::object();
  constexpr std::array<const char*, kinematic::kZmpSources.size()> kKeys{"planned", "all_masses", "cells",
                                                                         "solver"};
  for (const ZmpSource source : kinematic::kZmpSources) {
    const ZmpCourse& zmp = course.of(source);
    ordered_json& entry = json[kKeys[kinematic::index_of(source)]];
    if (!zmp.known()) continue;  // null
    entry = {{"least_margin_m", zmp.least_margin_m},
             {"least_at_s", zmp.least_at_s},
             {"mean_margin_m", zmp.mean_margin_m},
             {"rows", zmp.rows}};
    if (source == ZmpSource::planned) entry["made_from_com"] = course.planned_is_computed;
  }
  return json;
}

ordered_json joints_json(const urdf::RobotModel& robot, const Played& played) {
  ordered_json json = ordered_json::array();
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const JointUse& use = played.course.joints[j];
    json.push_back({{"name", robot.joints[j].name},
                    {"lowest_rad", use.lowest_rad},
                    {"highest_rad", use.highest_rad},
                    {"fastest_rad_per_s", use.fastest_rad_per_s},
                    {"fastest_at_s", use.fastest_at_s},
                    {"largest_torque_Nm", use.largest_torque_Nm},
                    {"largest_torque_at_s", use.largest_torque_at_s},
                    {"torque_share", use.torque_share}});
    if (!played.trajectory.points_of_wire) continue;
    json.back()["largest_step_counts"] = use.largest_step_counts;
    json.back()["largest_step_at_s"] = use.largest_step_at_s;
  }
  return json;
}

ordered_json played_json(const Simulation& simulation, const Played& played) {
  ordered_json json{{"source", played.trajectory.name},     {"kind", played.trajectory.kind},
                    {"start_s", played.trajectory.start_s}, {"duration_s", played.duration_s()},
                    {"rows", played.trajectory.rows()},     {"reading_s", played.reading_s},
                    {"playing_s", played.playing_s},        {"notes", played.course.notes}};
  if (simulation.subject == Subject::trajectory) {
    json["joints"] = joints_json(simulation.robot, played);
    json["collision_pairs"] = played.course.collision_pairs;
    json["stands"] = ordered_json::array();
    for (const kinematic::Stand& stand : played.course.stands) {
      json["stands"].push_back({{"side", stand.side == urdf::Side::left ? "left" : "right"},
                                {"from_s", stand.from_s},
                                {"to_s", stand.to_s}});
    }
  }
  json["zmp"] = zmp_json(played.course);
  json["findings"] = ordered_json::array();
  for (const Finding& finding : played.course.findings) json["findings"].push_back(json_of(finding));
  return json;
}

}  // namespace

std::string simulation_text(const Simulation& simulation) {
  std::string text;
  for (const Played& played : simulation.played) text += played_text(simulation, played);
  return simulation.played.size() > 1 ? text + comparison_text(simulation) : text;
}

ordered_json simulation_json(const Simulation& simulation) {
  ordered_json json{{"robot", simulation.robot.name}, {"played", ordered_json::array()}};
  for (const Played& played : simulation.played) json["played"].push_back(played_json(simulation, played));
  if (simulation.played.size() < 2) return json;
  const auto differences =
      kinematic::compare(simulation.played[0].trajectory, simulation.played[1].trajectory);
  for (std::size_t j = 0; j < differences.size(); ++j) {
    json["differences"].push_back({{"name", simulation.robot.joints[j].name},
                                   {"rms_rad", differences[j].rms_rad},
                                   {"largest_rad", differences[j].largest_rad},
                                   {"largest_at_s", differences[j].largest_at_s}});
  }
  return json;
}

}  // namespace gaitway::tools
