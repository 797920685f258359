// Stops first, then people, then the behaviour; then what has come to its end.
#include "gaitway/msgcontroller/command_arbiter.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "gaitway/facts/facts.hpp"
#include "sound_orders.hpp"

namespace gaitway::msgcontroller {
namespace {

using facts::kMillisecond_ns;

// The behaviour has come to an end when none of its orders has been in force for so long: from one to its
// next it may think.
constexpr std::int64_t kDone_ns = 1000 * kMillisecond_ns;
// What changes all the time is told so often.
constexpr std::int64_t kTellAgain_ns = 100 * kMillisecond_ns;

}  // namespace

void check_walk_option(std::span<const double> walk) {
  if (walk.size() != 3) {
    throw std::invalid_argument(
        "--walk: wants VX,VY,WZ in m/s, m/s and rad/s: three numbers, for example 0.15,0,0.1");
  }
  if (std::hypot(walk[0], walk[1]) > kLargestWalkSpeed_m_per_s) {
    throw std::invalid_argument(fmt::format("--walk: at most {} m/s may be commanded. Choose a lower speed",
                                            kLargestWalkSpeed_m_per_s));
  }
}

CommandArbiter::CommandArbiter(msgclient::Client& client)
    : walk_(client, "behaviour_walk", "walk_request", "walk_command"),
      way_(client, "behaviour_walk_to", "walk_to_request", "walk_to_command"),
      motion_(client, "behaviour_motion", "motion_request", "motion_command"),
      head_(client, "behaviour_head", "head_request", "head_command"),
      requests_(client.read<CommandRequest>("command_request")),
      stop_requests_(client.read<StopRequest>("stop_request")),
      estimates_(client.read<Estimate>("estimate")),
      ways_(client.read<NavigationState>("navigation_state")),
      motions_(client.read<MotionState>("motion_state")),
      states_(client.write<CommandState>("command_state")) {
  walk_.command(stand(), OrderSource::nobody, 0);
}

PassedOrders CommandArbiter::step(std::int64_t now_ns, bool emergency_stopped) noexcept {
  PassedOrders passed;
  hear_stops(now_ns);
  if (emergency_stopped && authority_.commander() != Commander::emergency_stop) stop(now_ns);
  awaits_emergency_stop_ = awaits_emergency_stop_ && !emergency_stopped;
  authority_.emergency_stop(emergency_stopped || awaits_emergency_stop_);
  hear_robot(now_ns);
  hear_people(now_ns, passed);
  hear_behaviour(now_ns);
  note_ends(now_ns, passed);
  tell(now_ns);
  return passed;
}

// In the millisecond in which the message controller obeys them, which is about to follow. What lies there
// was asked before, as far as anybody can tell: it does not count.
void CommandArbiter::hear_stops(std::int64_t now_ns) noexcept {
  if (stop_requests_.newest_sequence() == stop_seen_) return;
  StopRequest asked;
  const auto read = stop_requests_.read(asked);
  if (!read) return;
  stop_seen_ = read.sequence;
  const bool emergency = asked.holds != stops_.holds || asked.softs != stops_.softs;
  const bool any = emergency || asked.stops != stops_.stops;
  stops_ = asked;
  if (!any) return;
  stop(now_ns);
  for (const OrderSource source : {OrderSource::behaviour, OrderSource::person}) drop(source);
  request_seen_ = requests_.newest_sequence();
  awaits_emergency_stop_ = awaits_emergency_stop_ || emergency;
}

void CommandArbiter::drop(OrderSource source) noexcept {
  walk_.drop(source);
  way_.drop(source);
  motion_.drop(source);
  head_.drop(source);
}

void CommandArbiter::on_command(msgclient::UserCommandKind kind, std::int64_t now_ns) noexcept {
  using Kind = msgclient::UserCommandKind;
  switch (kind) {
    case Kind::stop:
      return stop(now_ns);
    case Kind::emergency_stop_hold:
    case Kind::emergency_stop_soft:
      stop(now_ns);
      awaits_emergency_stop_ = true;
      return authority_.emergency_stop(true);
    case Kind::manual_joint:
      if (authority_.person_commands(CommandReason::person_moves_joint)) {
        authority_.person_gets_it_up();
        end_orders_of(OrderSource::behaviour, now_ns);
      }
      return;
    case Kind::release:
      return;  // its end is seen by the message controller's mode
  }
}

void CommandArbiter::stop(std::int64_t now_ns) noexcept {
  end_all(now_ns);
  if (head_.current().stamp_ns != 0 || head_.current().mode != head_command::mode::ahead) hold_head(now_ns);
  authority_.person_stops();
}

void CommandArbiter::hear_robot(std::int64_t now_ns) noexcept {
  if (estimates_.newest_sequence() != estimate_seen_) {
    if (const auto read = estimates_.read(estimate_)) {
      estimate_seen_ = read.sequence;
      const bool fallen = estimate_.fall != estimate::fall::upright;
      if (fallen && !fallen_) {  // nothing walks on after it
        end_walk(now_ns);
        end_way(now_ns);
      }
      fallen_ = fallen;
      authority_.fall(fallen);
    }
  }
  if (ways_.newest_sequence() != way_seen_) {
    if (const auto read = ways_.read(navigation_)) {
      way_seen_ = read.sequence;
      const bool idle = navigation_.state == navigation_state::state::idle;
      if (idle && navigation_.answered == way_.current().number) way_.is_done();
    }
  }
  if (motions_.newest_sequence() != motion_seen_) {
    if (const auto read = motions_.read(motion_state_)) {
      motion_seen_ = read.sequence;
      // One that was refused because another plays leaves that to whoever asked: it is theirs to end.
      constexpr std::uint32_t kNonePlays = 0;
      if (motion_state_.state == kNonePlays && motion_state_.answered == motion_.current().number)
        motion_.is_done();
    }
  }
}

// Nobody knows in which order topics were written within a millisecond. Whoever is lost or takes the command
// does so before their orders of it, and lets go after them: an order that is told late would take the
// command back.
void CommandArbiter::hear_people(std::int64_t now_ns, PassedOrders& passed) noexcept {
  const std::optional<CommandVerb> verb = take_verb();
  const auto obey = [&] {
    if (order(*verb, now_ns)) passed.verb = verb;
  };
  if (verb && *verb != CommandVerb::let_go) obey();
  if (const auto walk = walk_.take(OrderSource::person)) {
    if (order(*walk, now_ns)) passed.walk = walk_.current();
  }
  if (const auto way = way_.take(OrderSource::person)) {
    if (order(*way, now_ns)) passed.way = way;
  }
  if (const auto motion = motion_.take(OrderSource::person)) {
    if (order(*motion, now_ns)) passed.motion = made_sound(*motion);
  }
  if (const auto head = head_.take(OrderSource::person)) {
    if (order(*head, now_ns)) passed.head = head;
  }
  if (verb && *verb == CommandVerb::let_go) obey();
}

std::optional<CommandVerb> CommandArbiter::take_verb() noexcept {
  if (requests_.newest_sequence() == request_seen_) return std::nullopt;
  CommandRequest request;
  const auto read = requests_.read(request);
  if (!read) return std::nullopt;
  request_seen_ = read.sequence;
  answered_ = request.number;
  return request.verb <= command_request::verb::is_lost
             ? std::optional(static_cast<CommandVerb>(request.verb))
             : std::nullopt;
}

// The end of an order, of somebody who commands, is no news of who does: a stop stays a stop. A robot that is
// being got up goes on with that, whatever but a motion is ordered meanwhile.
bool CommandArbiter::person_may(bool ends_something, std::int64_t now_ns) noexcept {
  if (ended_) return false;
  const bool commands = ends_something && authority_.commander() == Commander::person;
  if (!commands && !authority_.person_commands(CommandReason::person_orders)) return false;
  hears_loss_ = true;
  end_orders_of(OrderSource::behaviour, now_ns);
  return true;
}

bool CommandArbiter::order(const WalkCommand& walk, std::int64_t now_ns) noexcept {
  // Nobody walks while the robot gets up, and nobody's stick that is still held breaks that off.
  const WalkCommand sound = authority_.may_get_up() ? stand() : made_sound(walk, now_ns);
  if (!person_may(sound.walk == 0, now_ns)) return false;
  walk_.command(sound, sound.walk != 0 ? OrderSource::person : OrderSource::nobody, now_ns);
  walk_until_ns_ = sound.valid_until_ns;
  return true;
}

bool CommandArbiter::order(const WalkToRequest& way, std::int64_t now_ns) noexcept {
  if (!person_may(way.cancel != 0, now_ns)) return false;
  way_.command(way, way.cancel == 0 ? OrderSource::person : OrderSource::nobody, now_ns);
  return true;
}

bool CommandArbiter::order(const MotionRequest& motion, std::int64_t now_ns) noexcept {
  const MotionRequest sound = made_sound(motion);
  // Whoever leaves a motion means the one that plays, be it the behaviour's.
  if (authority_.commander() != Commander::emergency_stop && !ended_) authority_.person_gets_it_up();
  if (!person_may(leaves(sound), now_ns)) return false;
  motion_.command(sound, leaves(sound) ? OrderSource::nobody : OrderSource::person, now_ns);
  return true;
}

bool CommandArbiter::order(const HeadCommand& head, std::int64_t now_ns) noexcept {
  if (!is_sensible(head) || !person_may(false, now_ns)) return false;
  head_.command(head, head.mode == head_command::mode::ahead ? OrderSource::nobody : OrderSource::person,
                now_ns);
  return true;
}

bool CommandArbiter::order(CommandVerb verb, std::int64_t now_ns) noexcept {
  if (ended_) return false;
  switch (verb) {
    case CommandVerb::take:
      if (!authority_.person_commands(CommandReason::person_takes)) return false;
      authority_.person_gets_it_up();
      end_orders_of(OrderSource::behaviour, now_ns);
      return true;
    case CommandVerb::let_go:
      if (!authority_.person_lets_go()) return false;
      end_orders_of(OrderSource::person, now_ns);
      drop(OrderSource::behaviour);  // what it has asked for meanwhile does not count: it asks again
      return true;
    case CommandVerb::is_lost:
      if (!std::exchange(hears_loss_, true)) return false;
      if (walk_.in_force() == OrderSource::person) end_walk(now_ns);
      if (way_.in_force() == OrderSource::person) end_way(now_ns);
      authority_.person_is_lost();
      return true;
  }
  return false;
}

void CommandArbiter::hear_behaviour(std::int64_t now_ns) noexcept {
  if (const auto walk = walk_.take(OrderSource::behaviour)) {
    const WalkCommand sound = made_sound(*walk, now_ns);
    if (sound.walk == 0) {
      if (walk_.in_force() == OrderSource::behaviour) end_walk(now_ns);
    } else if (behaviour_may(false)) {
      walk_.command(sound, OrderSource::behaviour, now_ns);
      walk_until_ns_ = sound.valid_until_ns;
    }
  }
  if (const auto way = way_.take(OrderSource::behaviour)) {
    if (way->cancel != 0) {
      if (way_.in_force() == OrderSource::behaviour) end_way(now_ns);
    } else if (behaviour_may(false)) {
      way_.command(*way, OrderSource::behaviour, now_ns);
    }
  }
  if (const auto motion = motion_.take(OrderSource::behaviour)) {
    const MotionRequest sound = made_sound(*motion);
    if (leaves(sound)) {
      if (motion_.in_force() == OrderSource::behaviour) end_motion(now_ns);
    } else if (behaviour_may(true)) {
      motion_.command(sound, OrderSource::behaviour, now_ns);
    }
  }
  if (const auto head = head_.take(OrderSource::behaviour)) {
    if (is_sensible(*head) && behaviour_may(false)) {
      const bool ahead = head->mode == head_command::mode::ahead;
      head_.command(*head, ahead ? OrderSource::nobody : OrderSource::behaviour, now_ns);
    }
  }
}

bool CommandArbiter::behaviour_may(bool is_motion) noexcept {
  if (!ended_ && (authority_.behaviour_commands() || (is_motion && authority_.may_get_up() && fallen_)))
    return true;
  ++turned_away_;
  return false;
}

void CommandArbiter::note_ends(std::int64_t now_ns, PassedOrders& passed) noexcept {
  if (walk_.in_force() != OrderSource::nobody && walk_until_ns_ != 0 && now_ns >= walk_until_ns_) {
    const bool of_person = walk_.in_force() == OrderSource::person;
    end_walk(now_ns);
    if (of_person) passed.walk = walk_.current();
  }
  if (motion_.in_force() == OrderSource::nobody) authority_.got_up();
  const auto in_force = {walk_.in_force(), way_.in_force(), motion_.in_force(), head_.in_force()};
  if (std::ranges::find(in_force, OrderSource::behaviour) != in_force.end() ||
      authority_.commander() != Commander::behaviour) {
    behaviour_ends_ns_ = 0;
  } else if (behaviour_ends_ns_ == 0) {
    behaviour_ends_ns_ = now_ns + kDone_ns;
  } else if (now_ns >= behaviour_ends_ns_) {
    authority_.behaviour_is_done();
  }
}

void CommandArbiter::end_all(std::int64_t now_ns) noexcept {
  end_walk(now_ns);
  end_way(now_ns);
  end_motion(now_ns);
  end_head(now_ns);
}

void CommandArbiter::end_orders_of(OrderSource source, std::int64_t now_ns) noexcept {
  if (walk_.in_force() == source) end_walk(now_ns);
  if (way_.in_force() == source) end_way(now_ns);
  const bool gets_up = source == OrderSource::behaviour && authority_.may_get_up();
  if (motion_.in_force() == source && !gets_up) end_motion(now_ns);
  if (head_.in_force() == source) end_head(now_ns);
}

void CommandArbiter::end_walk(std::int64_t now_ns) noexcept {
  if (walk_.in_force() != OrderSource::nobody) walk_.command(stand(), OrderSource::nobody, now_ns);
}

void CommandArbiter::end_way(std::int64_t now_ns) noexcept {
  if (way_.in_force() == OrderSource::nobody) return;
  WalkToRequest leave{};
  leave.number = own_number();
  leave.cancel = 1;
  way_.command(leave, OrderSource::nobody, now_ns);
}

void CommandArbiter::end_motion(std::int64_t now_ns) noexcept {
  if (motion_.in_force() == OrderSource::nobody) return;
  MotionRequest leave{};
  leave.number = own_number();
  motion_.command(leave, OrderSource::nobody, now_ns);
}

void CommandArbiter::end_head(std::int64_t now_ns) noexcept {
  if (head_.in_force() != OrderSource::nobody) hold_head(now_ns);
}

// It stays where it is, also one that is on its way ahead.
void CommandArbiter::hold_head(std::int64_t now_ns) noexcept {
  HeadCommand hold{};
  hold.mode = head_command::mode::hold;
  head_.command(hold, OrderSource::nobody, now_ns);
}

// Neither one of the API's nor one of the behaviour's, as far as numbers can tell.
std::uint32_t CommandArbiter::own_number() noexcept {
  constexpr std::uint32_t kOwn = 0x4000'0000;
  return kOwn | (++numbers_ % kOwn);
}

void CommandArbiter::begin_anew_with_people(std::int64_t walk_until_ns) noexcept {
  drop(OrderSource::person);
  request_seen_ = requests_.newest_sequence();
  hears_loss_ = false;
  if (walk_.in_force() == OrderSource::person) walk_until_ns_ = walk_until_ns;
}

void CommandArbiter::end(std::int64_t now_ns) noexcept {
  end_all(now_ns);
  ended_ = true;
}

void CommandArbiter::tell(std::int64_t now_ns) noexcept {
  CommandState state{};
  state.commander = static_cast<std::uint32_t>(authority_.commander());
  state.reason = static_cast<std::uint32_t>(authority_.reason());
  state.in_force[0] = static_cast<std::uint32_t>(walk_.in_force());
  state.in_force[1] = static_cast<std::uint32_t>(way_.in_force());
  state.in_force[2] = static_cast<std::uint32_t>(motion_.in_force());
  state.in_force[3] = static_cast<std::uint32_t>(head_.in_force());
  state.may_get_up = authority_.may_get_up() ? 1 : 0;
  state.answered = answered_;
  state.changes = authority_.changes();
  const bool same_commander = state.changes == told_.changes && told_ns_ >= 0;
  const bool same = same_commander && std::ranges::equal(state.in_force, told_.in_force) &&
                    state.may_get_up == told_.may_get_up && state.answered == told_.answered;
  if (same && (turned_away_ == told_.turned_away || now_ns - told_ns_ < kTellAgain_ns)) return;
  state.since_ns = same_commander ? told_.since_ns : now_ns;
  state.turned_away = turned_away_;
  state.stamp_ns = now_ns;
  const std::string_view text = sentence(authority_.commander(), authority_.reason());
  std::ranges::copy_n(text.begin(), static_cast<std::ptrdiff_t>(std::min(text.size(), sizeof state.text - 1)),
                      state.text);
  told_ = state;
  told_ns_ = now_ns;
  states_.publish(state, now_ns);
}

}  // namespace gaitway::msgcontroller
