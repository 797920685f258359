// rosbridge messages as numbers and words.
#include "tools/twin/robot_news.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "gaitway/input/text.hpp"

namespace gaitway::tools {
namespace {

using nlohmann::json;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr int kFast_ms = 20, kSlow_ms = 0;  // 0: as it changes

double number(const json& value) {
  return value.is_number() ? value.get<double>() : kUnknown;
}

double stamp_of(const json& message) {
  const json& stamp = message.at("header").at("stamp");
  return stamp.at("sec").get<double>() + stamp.at("nanosec").get<double>() * 1e-9;
}

std::vector<double> vector_of(const json& value, std::initializer_list<const char*> fields) {
  std::vector<double> numbers;
  for (const char* const field : fields) numbers.push_back(number(value.at(field)));
  return numbers;
}

MeasuredPoint attitude_of(const json& message) {
  const std::vector<double> q = vector_of(message.at("orientation"), {"x", "y", "z", "w"});
  const double roll = std::atan2(2.0 * (q[3] * q[0] + q[1] * q[2]), 1.0 - 2.0 * (q[0] * q[0] + q[1] * q[1]));
  const double pitch = std::asin(std::clamp(2.0 * (q[3] * q[1] - q[2] * q[0]), -1.0, 1.0));
  const bool known = number(message.at("orientation_covariance").at(0)) >= 0.0;
  return {Measurement::attitude, stamp_of(message),
          known ? std::vector{roll, pitch} : std::vector{kUnknown, kUnknown}};
}

MeasuredPoint odometry_of(const json& message) {
  const json& pose = message.at("pose").at("pose");
  std::vector<double> values = vector_of(pose.at("position"), {"x", "y", "z"});
  for (const double one : vector_of(pose.at("orientation"), {"x", "y", "z", "w"})) values.push_back(one);
  return {Measurement::odometry, stamp_of(message), std::move(values)};
}

std::optional<std::array<double, 3>> three_of(const json& list) {
  if (!list.is_array() || list.size() != 3) return std::nullopt;
  const std::array three{number(list.at(0)), number(list.at(1)), number(list.at(2))};
  const bool is_known = std::ranges::all_of(three, [](double one) { return std::isfinite(one); });
  return is_known ? std::optional(three) : std::nullopt;
}

}  // namespace

std::string shortened(std::string text) {
  constexpr std::size_t kMostCharacters = 300;
  text.resize(std::min(text.size(), 4 * kMostCharacters));
  text = input::terminal_text(text);
  if (text.size() > kMostCharacters) text = input::terminal_text(text.substr(0, kMostCharacters)) + "...";
  return text;
}

RobotReader::RobotReader(const urdf::RobotModel& robot) {
  for (const urdf::Joint& joint : robot.joints) index_.emplace(joint.name, index_.size());
}

std::vector<RobotReader::Topic> RobotReader::topics() {
  return {{"/joint_states", kFast_ms},      {"/imu/data", kFast_ms},  {"/foot/left/wrench", kFast_ms},
          {"/foot/right/wrench", kFast_ms}, {"/odom", kFast_ms},      {"/walk_to/state", kSlow_ms},
          {"/robot_state", kSlow_ms},       {"/commander", kSlow_ms}, {"/walk/command", kSlow_ms},
          {"/motion_state", kSlow_ms}};
}

MeasuredPoint RobotReader::joints_of(const json& message) const {
  MeasuredPoint point{Measurement::joints, stamp_of(message), std::vector<double>(index_.size(), kUnknown)};
  const json& names = message.at("name");
  const json& positions = message.at("position");
  for (std::size_t i = 0; i < std::min(names.size(), positions.size()); ++i) {
    const auto found = index_.find(names.at(i).get_ref<const std::string&>());
    if (found != index_.end()) point.values[found->second] = number(positions.at(i));
  }
  return point;
}

std::optional<MeasuredPoint> RobotReader::take(std::string_view topic, const json& message, RobotNews& news) {
  if (topic == "/joint_states") return joints_of(message);
  if (topic == "/imu/data") return attitude_of(message);
  if (topic == "/odom") return odometry_of(message);
  if (topic == "/foot/left/wrench" || topic == "/foot/right/wrench") {
    return MeasuredPoint{topic == "/foot/left/wrench" ? Measurement::left_foot : Measurement::right_foot,
                         stamp_of(message),
                         {number(message.at("wrench").at("force").at("z"))}};
  }
  if (topic == "/walk_to/state") {
    news.way_state = shortened(message.at("state").get<std::string>());
    news.way_result = shortened(message.at("result").get<std::string>());
    news.goal = three_of(message.at("goal"));
    const auto pose = three_of(message.at("pose"));
    if (pose) return MeasuredPoint{Measurement::place, stamp_of(message), {pose->begin(), pose->end()}};
  } else if (topic == "/robot_state") {
    news.activity = shortened(message.at("state").get<std::string>());
  } else if (topic == "/commander") {
    news.commander = shortened(message.at("data").get<std::string>());
  } else if (topic == "/walk/command") {
    const json& twist = message.at("twist");
    news.walk = {number(twist.at("linear").at("x")), number(twist.at("linear").at("y")),
                 number(twist.at("angular").at("z"))};
    const bool is_known = std::ranges::all_of(news.walk, [](double one) { return std::isfinite(one); });
    if (!is_known) news.walk = {};
  } else if (topic == "/motion_state") {
    news.motion = shortened(message.at("motion").get<std::string>());
    news.motion_state = shortened(message.at("state").get<std::string>());
    news.motion_result = shortened(message.at("result").get<std::string>());
    news.motions_ended = message.at("ended").get<std::uint32_t>();
  }
  return std::nullopt;
}

}  // namespace gaitway::tools
