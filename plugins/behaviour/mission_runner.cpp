// The states of a mission.
#include "gaitway/behaviour_leaves/mission_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "fixed_text.hpp"

namespace gaitway::behaviour_leaves {
namespace {

namespace states = behaviour_state::state;
namespace verbs = behaviour_request::verb;
using behaviour::NodeStatus;

// A request of that age is from before a start of this plug-in.
constexpr std::int64_t kRequestIsOld_ns = 1'000'000'000;

}  // namespace

MissionRunner::MissionRunner(const behaviour::Registry& registry, Robot& robot, MissionDesk::Where where,
                             Listener& listener)
    : registry_(registry), robot_(robot), listener_(listener), desk_(registry, where) {}

void MissionRunner::load(const std::string& name_or_path) {
  mission_ = std::make_unique<LoadedMission>(read_mission(name_or_path, registry_), name_or_path, registry_);
  copy_text(wanted_, name_or_path);
  state_ = states::runs;
}

behaviour::Tree* MissionRunner::shown() const noexcept {
  if (mission_ == nullptr) return nullptr;
  return shows_stand_up_ && mission_->stand_up ? &*mission_->stand_up : &mission_->tree;
}

// ---- What people ask

void MissionRunner::ask(const BehaviourRequest& request, std::int64_t now_ns) {
  if (request.number == 0 || request.number == answered_) return;
  const bool is_first = !std::exchange(has_been_asked_, true);
  if (is_first && !goes_on_ && now_ns - request.stamp_ns > kRequestIsOld_ns && request.verb != verbs::end) {
    return turn_old_away(request);
  }
  if (request.verb == verbs::end) {
    asked_ = request.number;
    return end_mission();
  }
  if (desk_.waits() || next_ != nullptr) return;
  asked_ = request.number;
  const std::string_view named = text_of(request.mission);
  if (!was_enabled_) return answer(true, "the behaviour is disabled: set its parameter 'enabled'");
  if (request.verb != verbs::start && request.verb != verbs::change)
    return answer(true, "there is no such verb");
  if (named.empty() && mission_ == nullptr) return answer(true, "no mission is loaded: name one");
  const std::string name = named.empty() ? mission_->name : std::string(named);
  if (request.verb == verbs::change && mission_ == nullptr) return answer(true, "no mission runs: start one");
  desk_.submit(name, request.verb == verbs::change ? &mission_->tree : nullptr);
}

// From before a start of this plug-in. Where that person's mission is another than the plug-in's own, none
// begins by itself.
void MissionRunner::turn_old_away(const BehaviourRequest& request) noexcept {
  asked_ = answered_ = request.number;
  refused_ = true;
  answered_ns_ = robot_.situation.now_ns;
  copy_text(text_, "it was asked for before the behaviour was started anew: ask again");
  if (request.verb != verbs::start || state_ != states::runs || text_of(request.mission) == mission_->name)
    return;
  ends_ = true;
  enter(states::halts);
}

// Also while another is being read, or waits for this one's end.
void MissionRunner::end_mission() {
  is_dropped_ = desk_.waits();
  is_disabling_ = false;
  inherited_.reset();
  if (next_ != nullptr)
    desk_.put_away({.refused = {}, .mission = std::exchange(next_, nullptr), .change = {}});
  const bool is_over = state_ == states::none;
  answer(false, is_over ? "no mission runs" : "the mission is being ended");
  ends_ = !is_over;
  if (ends_) enter(states::halts);
}

void MissionRunner::answer(bool refused, std::string_view text) noexcept {
  answered_ = asked_;
  refused_ = refused;
  answered_ns_ = robot_.situation.now_ns;
  copy_text(text_, text);
  if (refused) listener_.on_line(true, text_.data());
}

void MissionRunner::take_up(ReadMission read) {
  if (std::exchange(is_dropped_, false)) return desk_.put_away(std::move(read));
  if (read.mission == nullptr) {
    if (inherited_) {
      inherited_.reset();
      enter(states::none);
      copy_text(wanted_, mission_ != nullptr ? mission_->name : std::string());
    }
    return answer(true, read.refused);
  }
  if (!read.change) {
    copy_text(wanted_, read.mission->name);
    next_ = std::move(read.mission);
    answer(false, robot_.situation.commands() ? "the mission begins"
                                              : "the mission begins when the command is let go of");
    ends_ = true;
    if (state_ != states::none && !is_halted_) enter(states::halts);
    return;
  }
  if (stand_up_runs_) {
    answer(true, "the robot is getting up: change the tree when it stands");
  } else if (!mission_->tree.adopt(*read.change)) {
    const std::vector<std::string> why = mission_->tree.refusals(*read.change);
    answer(true, why.empty() ? "the tree has become another meanwhile: ask again" : why.front());
  } else {
    mission_->stand_up.swap(read.mission->stand_up);
    mission_->name.swap(read.mission->name);
    copy_text(wanted_, mission_->name);
    begin_revision();
    answer(false, "the tree has been changed");
    line(false, "the tree has been changed");
  }
  desk_.put_away(std::move(read));
}

// ---- A step

bool MissionRunner::is_disturbed() noexcept {
  const Situation& now = robot_.situation;
  const std::uint32_t fall = now.estimate != nullptr ? now.estimate->fall : 0;
  const std::uint32_t commander = now.command != nullptr ? now.command->commander : 0;
  const std::uint32_t may_get_up = now.command != nullptr ? now.command->may_get_up : 0;
  const bool is_news = fall != last_fall_ || commander != last_commander_ || may_get_up != last_may_get_up_;
  last_fall_ = fall;
  last_commander_ = commander;
  last_may_get_up_ = may_get_up;
  return is_news;
}

// A person has had the command and has let go of it between two looks: what the tree has ordered was ended.
bool MissionRunner::was_taken_meanwhile() const noexcept {
  const CommandState* const command = robot_.situation.command;
  if (command == nullptr || !last_changes_ || command->changes == *last_changes_) return false;
  // Between two looks the behaviour itself comes to an end and orders anew, at most: each is one change.
  if (command->changes - *last_changes_ > 2) return true;
  return command->reason == command_state::reason::person_lets_go ||
         command->reason == command_state::reason::emergency_stop_released;
}

bool MissionRunner::step(bool is_due, bool is_enabled) {
  if (auto read = desk_.take()) take_up(*std::move(read));
  const bool is_disturbed_now = is_disturbed();
  if (!is_due && !is_disturbed_now) return false;
  if (is_enabled != was_enabled_) {
    was_enabled_ = is_enabled;
    if (!is_enabled) line(false, "is disabled");
    if (is_enabled && !ends_ && mission_ != nullptr) begin_anew("is enabled, and begins anew");
    if (!is_enabled && state_ != states::none) {
      is_disabling_ = is_disabling_ || !ends_;
      ends_ = true;
      enter(states::halts);
    }
  }
  robot_.begin();
  told_sayings_ = 0;
  advance();
  pass_sayings();
  tell_what_waited();
  if (const CommandState* const command = robot_.situation.command) last_changes_ = command->changes;
  return true;
}

void MissionRunner::begin_anew(const char* why) noexcept {
  mission_->tree.reset();
  enter(states::runs);
  line(false, why);
}

void MissionRunner::advance() {
  if (inherited_ && !ends_) return;  // the mission that is loaded is not the one that is to run
  if (ends_) {
    halt();
    if (!is_halted_) return;
    ends_ = false;
    const bool begins_anew = std::exchange(is_disabling_, false) && was_enabled_;
    if (next_ != nullptr) {
      desk_.put_away(
          {.refused = {}, .mission = std::exchange(mission_, std::exchange(next_, nullptr)), .change = {}});
      begin_revision();
      shows_stand_up_ = false;
      enter(was_enabled_ ? inherited_.value_or(states::runs) : states::none);
      if (!inherited_) ticks_ = 0;
      inherited_.reset();
    } else if (begins_anew) {
      begin_anew("is enabled, and begins anew");
    } else {
      enter(states::none);
      line(false, "the mission has been ended");
    }
    if (state_ != states::runs) return;
    std::array<char, 208> text{};
    fmt::format_to_n(text.data(), text.size() - 1, "mission '{}' begins", mission_->name);
    line(false, text.data());
  }
  if (mission_ == nullptr) return;
  if (state_ == states::runs && (!robot_.situation.commands() || was_taken_meanwhile())) {
    enter(states::waits);
    line(false, "somebody else commands: the mission waits");
  }
  if (state_ == states::waits) wait();
  if (state_ == states::runs) run();
}

void MissionRunner::run() {
  show(false);
  is_halted_ = false;
  const NodeStatus result = mission_->tree.tick(robot_.situation.now_ns);
  after_tree(mission_->tree);
  if (result == NodeStatus::running) return;
  is_halted_ = true;
  pass_sayings();  // before what follows from it
  std::array<char, 208> text{};
  if (result == NodeStatus::success) {
    enter(states::succeeded);
    fmt::format_to_n(text.data(), text.size() - 1, "mission '{}' has succeeded", mission_->name);
    return line(false, text.data());
  }
  enter(states::failed);
  fmt::format_to_n(text.data(), text.size() - 1, "mission '{}' has failed: {}", mission_->name,
                   cause_of_failure());
  line(true, text.data());
}

// What a leaf says, or which node, of those that failed in this tick the deepest.
std::string_view MissionRunner::cause_of_failure() const noexcept {
  std::string_view cause = "it had nothing to do";
  behaviour::NodeIndex deepest = behaviour::kNoNode;
  for (const behaviour::Transition& change : mission_->tree.transitions()) {
    if (change.to == NodeStatus::failure) deepest = std::max(deepest, change.node);
  }
  if (deepest != behaviour::kNoNode)
    cause = mission_->tree.description().nodes[static_cast<std::size_t>(deepest)].segment;
  for (const Orders::Saying& saying : robot_.orders.sayings()) {
    if (saying.is_trouble) cause = saying.text.data();
  }
  return cause;
}

// Everything halts; one thing may go on: the robot has fallen under a person's command, and gets up. Once it
// has begun to, it goes on when the command comes back meanwhile.
void MissionRunner::wait() {
  const Situation& now = robot_.situation;
  const bool gets_up = mission_->stand_up && now.commands_motions() &&
                       (stand_up_runs_ || (!now.commands() && now.has_fallen()));
  if (!gets_up || !is_halted_) {
    halt();
    if (is_halted_ && now.commands()) begin_anew("the command is back: the mission begins anew");
    return;
  }
  show(true);
  stand_up_runs_ = mission_->stand_up->tick(now.now_ns) == NodeStatus::running;
  after_tree(*mission_->stand_up);
}

void MissionRunner::halt() {
  if (mission_ == nullptr) {
    is_halted_ = true;
    return;
  }
  bool has_ended = true;
  if (stand_up_runs_) {
    has_ended = mission_->stand_up->halt(robot_.situation.now_ns);
    stand_up_runs_ = !has_ended;
    after_tree(*mission_->stand_up);
  }
  if (!is_halted_) {
    is_halted_ = mission_->tree.halt(robot_.situation.now_ns);
    show(false);
    after_tree(mission_->tree);
  }
  is_halted_ = is_halted_ && has_ended;
}

void MissionRunner::enter(std::uint32_t state) noexcept {
  state_ = state;
}

// ---- Going over to a successor

RunnerState MissionRunner::state() const noexcept {
  return {.answered = answered_,
          .refused = refused_ ? 1U : 0U,
          .state = next_ != nullptr && !inherited_ ? states::runs : inherited_.value_or(state_),
          .revision = revision_,
          .told_node = told_node_,
          .fall = last_fall_,
          .commander = last_commander_,
          .may_get_up = last_may_get_up_,
          .ticks = ticks_,
          .transitions = transitions_,
          .mission = wanted_,
          .text = text_};
}

void MissionRunner::go_on_from(const RunnerState& state) {
  goes_on_ = true;
  answered_ = asked_ = state.answered;
  refused_ = state.refused != 0;
  text_ = state.text;
  last_fall_ = state.fall;
  last_commander_ = state.commander;
  last_may_get_up_ = state.may_get_up;
  revision_ = state.revision;
  told_node_ = state.told_node;
  if (mission_ != nullptr) begin_revision();  // its file may have become another
  ticks_ = state.ticks;
  transitions_ = state.transitions;
  const bool runs = state.state == states::runs || state.state == states::waits;
  enter(runs ? state.state : state.state == states::halts ? states::none : state.state);
  if (state.mission == wanted_ || state.mission[0] == '\0') return;
  inherited_ = state_;
  wanted_ = state.mission;
  desk_.submit(state.mission.data(), nullptr);
}

}  // namespace gaitway::behaviour_leaves
