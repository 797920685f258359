// Plays the flight, and watches.
#include "flight_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

namespace gaitway::preflight {
namespace {

constexpr double kRounding_s = 1e-9;

simulator::CosimulationOptions with_seed(simulator::CosimulationOptions options, std::uint64_t seed) {
  options.plant.seed = seed;
  return options;
}

template <std::size_t size>
std::string text_of(const std::uint8_t (&bytes)[size]) {
  const auto* const begin = reinterpret_cast<const char*>(bytes);
  return {begin, std::find(begin, begin + size, '\0')};
}

}  // namespace

FlightRun::FlightRun(const urdf::RobotModel& robot, const Flight& flight,
                     simulator::CosimulationOptions options, std::uint64_t seed)
    : flight_(flight),
      run_(robot, with_seed(std::move(options), seed)),
      motion_(run_.client().read<MotionState>("motion_state")),
      way_(run_.client().read<NavigationState>("navigation_state")) {
  trial_.seed = seed;
}

bool FlightRun::goes_on() const {
  return !trial_.fell && static_cast<double>(run_.now_ns()) * 1e-9 < flight_.seconds - kRounding_s;
}

void FlightRun::advance_millisecond() {
  const double now_s = static_cast<double>(run_.now_ns()) * 1e-9;
  for (; next_event_ < flight_.events.size() && flight_.events[next_event_].at_s <= now_s + kRounding_s;
       ++next_event_) {
    run_.apply(flight_.events[next_event_]);
  }
  run_.advance_millisecond();
  look();
}

void FlightRun::look() {
  const simulator::Plant& plant = run_.plant();
  trial_.fell = plant.fallen();
  trial_.ended_s = static_cast<double>(run_.now_ns()) * 1e-9;
  trial_.largest_tilt_rad = std::max(trial_.largest_tilt_rad, plant.truth().trunk_tilt_rad);
  if (const auto contacts = plant.body_contacts(); !contacts.empty()) {
    ++trial_.body_contacts;
    if (trial_.first_contact.empty()) trial_.first_contact = contact_text(contacts.front());
  }
  constexpr std::int64_t kLook_ns = 80'000'000;
  if (run_.now_ns() % kLook_ns == 0) look_at_answers();
}

std::string FlightRun::contact_text(const simulator::BodyContact& contact) const {
  const std::vector<urdf::Link>& links = run_.robot().links;
  const std::string link = links[static_cast<std::size_t>(contact.link)].name + " touches ";
  if (contact.is_within_robot()) return link + links[static_cast<std::size_t>(contact.other_link)].name;
  if (contact.solid == simulator::BodyContact::kFloor) return link + "the floor";
  return link + run_.plant().solids()[static_cast<std::size_t>(contact.solid)].name;
}

void FlightRun::look_at_answers() {
  if (!trial_.refusal.empty()) return;
  MotionState motion;
  if (motion_.read(motion)) {
    if (motion.refused != 0) trial_.refusal = text_of(motion.text);
    motions_ended_ = motion.ended;
  }
  NavigationState way;
  if (way_.read(way)) {
    const bool failed =
        way.result == navigation_state::result::refused || way.result == navigation_state::result::failed;
    if (failed) trial_.refusal = text_of(way.text);
    arrived_ = way.state == navigation_state::state::idle && way.result == navigation_state::result::arrived;
    distance_left_m_ = way.distance_left;
  }
}

// What was asked for has an end, and the flight was long enough for it only if that was reached.
std::string FlightRun::left_undone() const {
  std::size_t motions = 0;
  bool walks_to = false;
  for (const simulator::ScenarioEvent& event : flight_.events) {
    const auto* const motion = std::get_if<simulator::MotionEvent>(&event.action);
    if (motion != nullptr && !motion->name.empty()) ++motions;
    if (const auto* const way = std::get_if<simulator::WalkToEvent>(&event.action)) {
      walks_to = way->goal.has_value();
    }
  }
  if (motions > motions_ended_) {
    return fmt::format("the motion has not ended within {:g} s: watch it longer (--seconds)",
                       flight_.seconds);
  }
  if (walks_to && !arrived_) {
    return fmt::format("it has not arrived within {:g} s, {:.2f} m are left: watch it longer (--seconds)",
                       flight_.seconds, distance_left_m_);
  }
  return {};
}

Trial FlightRun::trial() const {
  Trial trial = trial_;
  if (!trial.fell && trial.refusal.empty()) trial.refusal = left_undone();
  const core::MainControllerStatistics statistics = run_.main_controller().statistics();
  trial.refused_batches = statistics.refused_locally + run_.message_controller().state().refused;
  return trial;
}

}  // namespace gaitway::preflight
