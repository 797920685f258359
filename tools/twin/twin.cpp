// Two watches, a comparison, a follower and a gate, put together.
#include "tools/twin/twin.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <span>
#include <utility>

#include "gaitway/process/real_time.hpp"

namespace gaitway::tools {
namespace {

using nlohmann::json;

constexpr std::size_t kMostTold = 20;
constexpr std::size_t kPictureBytes = 48'000;  // at once

json known_or_null(double value) {
  return std::isfinite(value) ? json(value) : json();
}

const char* name(RobotWatch::State state) {
  constexpr std::array kNames{"connecting", "connected", "lost", "refused"};
  return kNames[static_cast<std::size_t>(state)];
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t word = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      word = word << 8U | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) text += k <= count ? kLetters[word >> (18U - 6U * k) & 63U] : '=';
  }
  return text;
}

}  // namespace

Twin::Twin(const TwinOptions& options, const urdf::RobotModel& robot)
    : address_(options.there.url),
      comparison_(robot),
      pose_(robot),
      stop_(options.there),
      flight_(options.flight_arguments, options.out),
      there_(options.there, robot),
      here_(options.here, robot),
      follower_(options.here) {
  follower_.set(true);
}

Twin::~Twin() {
  if (flight_.is_under_way()) stop("the simulator has ended");
}

void Twin::look(const SimulationPace& pace) {
  there_status_ = there_.status();
  hear(Comparison::Robot::real, there_);
  hear(Comparison::Robot::simulated, here_);
  keep_pace(pace);
  comparison_.look(monotonic_s());
  if (std::string text = comparison_.take_news(); !text.empty()) tell(std::move(text));
  RobotNews news = there_status_.news;
  // With a robot that is not heard of the simulated one walks no further.
  if (there_status_.state != RobotWatch::State::connected) {
    news.walk = {};
    news.way_state = "idle";
    news.way_result = "cancelled";
  }
  follower_.hear(news, pace_text_.empty());
  join();
  look_at_link(there_status_);
  look_at_stop();
  look_at_following();
  look_at_flight();
}

void Twin::hear(Comparison::Robot robot, RobotWatch& watch) {
  for (const ArrivedPoint& arrived : watch.take_points()) {
    const bool goes_on = comparison_.take(robot, arrived);
    if (robot != Comparison::Robot::real) continue;
    if (!goes_on) pose_.forget();
    pose_.take(arrived.point);
    const bool is_known =
        arrived.point.what == Measurement::joints &&
        std::ranges::all_of(arrived.point.values, [](double one) { return std::isfinite(one); });
    if (is_known) measured_s_ = arrived.arrived_s;
  }
}

// At another pace, after a jump, or when somebody else commands the simulated robot, the two do not do the
// same at the same time.
void Twin::keep_pace(const SimulationPace& pace) {
  pace_text_ = !pace.plays         ? "the simulation is paused"
               : pace.speed != 1.0 ? fmt::format("the simulation runs at {:g} times real time", pace.speed)
                                   : "";
  const std::string commander = here_.status().news.commander;
  const bool is_others = !commander.empty() && commander != Follower::kName;
  if (pace_text_.empty() && is_others) pace_text_ = commander + " commands the simulated robot";
  if (pace.run != pace_.run || !pace_text_.empty() || !follower_.status().follows) {
    comparison_.pause(Comparison::Robot::simulated);
  }
  pace_ = pace;
}

void Twin::tell(std::string text) {
  lines_.push_back("the robot there: " + text);
  told_.emplace_back(monotonic_s() - began_s_, std::move(text));
  if (told_.size() > kMostTold) told_.pop_front();
}

void Twin::look_at_link(const RobotWatch::Status& status) {
  if (status.state == link_told_) return;
  link_told_ = status.state;
  const std::string why = status.text.empty() ? "" : ": " + status.text;
  tell(name(status.state) + why);
  // What is under way was meant for another robot.
  if (status.state == RobotWatch::State::refused && flight_.is_under_way())
    stop("the robot there is another one now");
}

void Twin::look_at_stop() {
  const RobotStop::Answer answer = stop_.answer();
  if (answer.number == stops_told_) return;
  stops_told_ = answer.number;
  tell(answer.text.empty() ? "it was told to stop, and does"
                           : "it was told to stop in vain: " + shortened(answer.text));
}

void Twin::look_at_following() {
  const Follower::Status follow = follower_.status();
  if (follow.text == follow_told_) return;
  follow_told_ = follow.text;
  if (follow.text.empty()) return;
  tell(
      fmt::format("the simulated robot follows {}: {}", follow.follows ? "in vain" : "no more", follow.text));
}

void Twin::look_at_flight() {
  flight_.look();
  // What it sent last may have been under way when the robot was told to stop.
  if (!flight_.is_under_way() && std::exchange(is_stopped_again_, false)) stop_.stop();
  if (flight_.state() == flight_seen_) return;
  flight_seen_ = flight_.state();
  const std::string text = flight_.text().empty() ? "" : ": " + shortened(flight_.text());
  tell(fmt::format("{}: {}{}", flight_.what(), tools::name(flight_.state()), text));
}

void Twin::stop(const std::string& why) {
  is_stopped_again_ = flight_.is_under_way();
  flight_.stop(why);
  stop_.stop();
}

std::vector<std::string> Twin::take_lines() {
  return std::exchange(lines_, {});
}

std::optional<json> Twin::obey(const json& order) {
  const auto what = order.at("order").get<std::string>();
  if (what == "twin") return state();
  if (what == "twin_picture") return picture(order);
  if (what == "twin_follow") {
    joins_ = order.at("follow").get<bool>();
    follower_.set(joins_);
  } else if (what == "twin_send") {
    begin_flight(order);
  } else if (what == "twin_stop") {
    stop("stopped by you");
  } else if (what == "twin_reconnect") {
    there_.reconnect();
  } else {
    return std::nullopt;
  }
  return json::object();
}

// Once both stand, and where is known.
void Twin::join() {
  constexpr double kNear_m = 0.05, kAlong_rad = 0.1;
  const bool both_stand = there_status_.news.activity == "stands" && here_.status().news.activity == "stands";
  if (!joins_ || !both_stand || !pace_text_.empty()) return;
  const std::span<const ChannelValues> place = std::span(comparison_.values()).last<3>();
  if (!std::ranges::all_of(place, [](const ChannelValues& one) { return std::isfinite(one.difference); }))
    return;
  joins_ = false;
  const bool is_near =
      std::hypot(place[0].difference, place[1].difference) < kNear_m && place[2].difference < kAlong_rad;
  if (!is_near) follower_.join({place[0].measured, place[1].measured, place[2].measured});
}

void Twin::begin_flight(const json& order) {
  if (process::monotonic_ns() > order.at("until_ns").get<std::int64_t>()) {
    throw std::runtime_error("late: it was to begin before now, and whoever asked was told that it has not");
  }
  if (there_status_.state != RobotWatch::State::connected) {
    throw std::runtime_error(
        fmt::format("the robot there is {}: {}", name(there_status_.state), there_status_.text));
  }
  constexpr double kUsual_s = 10.0;
  FlightTask task{.walk = order.at("walk").get<std::vector<double>>(),
                  .walk_s = order.at("duration_s").get<double>(),
                  .motion = order.at("motion").get<std::string>(),
                  .goal = order.at("goal").get<std::vector<double>>(),
                  .settings = order.at("settings").get<std::vector<std::string>>(),
                  .reason = order.at("reason").get<std::string>()};
  if (task.walk_s == 0.0) task.walk_s = kUsual_s;
  if (task.walk.size() % 3 != 0 || task.goal.size() % 3 != 0 || task.walk.size() > 3 ||
      task.goal.size() > 3) {
    throw std::invalid_argument("walk and goal must be empty or have three numbers");
  }
  flight_.start(task);
}

json Twin::state() const {
  const Follower::Status follow = follower_.status();
  json message{{"robot", address_},
               {"state", name(there_status_.state)},
               {"text", there_status_.text},
               {"age", measured_s_ == 0.0 ? json() : json(monotonic_s() - measured_s_)},
               {"activity", there_status_.news.activity},
               {"commander", there_status_.news.commander},
               {"follows", follow.follows && pace_text_.empty()},
               {"follows_text", pace_text_.empty() ? follow.text : pace_text_},
               {"base", json::array()},
               {"joints", pose_.joints()},
               {"lag", comparison_.lag_s() ? json(*comparison_.lag_s()) : json()}};
  if (const auto base = pose_.base()) {
    const Eigen::Vector3d at = base->translation();
    const Eigen::Quaterniond turn(base->linear());
    message["base"] = {at.x(), at.y(), at.z(), turn.x(), turn.y(), turn.z(), turn.w()};
  }
  for (const char* const list :
       {"channels", "units", "measured", "simulated", "difference", "limits", "told_times", "told_texts"}) {
    message[list] = json::array();
  }
  for (std::size_t i = 0; i < comparison_.channels().size(); ++i) {
    const Channel& channel = comparison_.channels()[i];
    const ChannelValues& values = comparison_.values()[i];
    message["channels"].push_back(channel.name);
    message["units"].push_back(channel.unit);
    message["measured"].push_back(known_or_null(values.measured));
    message["simulated"].push_back(known_or_null(values.simulated));
    message["difference"].push_back(known_or_null(values.difference));
    message["limits"].push_back(channel.limit);
  }
  for (const auto& [since_begin_s, text] : told_) {
    message["told_times"].push_back(since_begin_s);
    message["told_texts"].push_back(text);
  }
  message.update({{"sending", tools::name(flight_.state())},
                  {"sending_what", flight_.what()},
                  {"sending_text", shortened(flight_.text())},
                  {"passed", flight_.passed()},
                  {"tried", flight_.tried()},
                  {"picture", flight_.pictures()}});
  return message;
}

json Twin::picture(const json& order) const {
  if (flight_.pictures() == 0) throw std::runtime_error("there is no picture yet: nothing has been tried");
  std::ifstream file(flight_.picture(), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file && bytes.empty()) {
    throw std::runtime_error(fmt::format("the picture '{}' cannot be read", flight_.picture().string()));
  }
  const std::size_t from = std::min<std::size_t>(order.at("from").get<std::uint32_t>(), bytes.size());
  return {{"total", bytes.size()}, {"data", base64(std::string_view(bytes).substr(from, kPictureBytes))}};
}

}  // namespace gaitway::tools
