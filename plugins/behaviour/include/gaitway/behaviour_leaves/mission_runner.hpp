// Runs one mission: ticks its tree while the behaviour commands, halts it while somebody else does, starts,
// ends and changes it as people ask.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "gaitway/behaviour_leaves/leaves.hpp"
#include "gaitway/behaviour_leaves/mission_desk.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::behaviour_leaves {

// What a successor goes on from: which mission, and whether it is over. The tree itself begins anew.
struct RunnerState {
  std::uint32_t answered = 0, refused = 0, state = behaviour_state::state::none;
  std::uint32_t revision = 1, told_node = 0;
  std::uint32_t fall = 0, commander = 0, may_get_up = 0;  // as it has seen them last
  std::uint64_t ticks = 0, transitions = 0;
  std::array<char, 256> mission{};
  std::array<char, 208> text{};
};

class MissionRunner {
 public:
  // What is told to people, once each.
  class Listener {
   public:
    virtual ~Listener() = default;
    virtual void on_line(bool is_trouble, const char* text) noexcept = 0;
  };

  // Leaves of the registry work on `robot`. All of these must outlive this.
  MissionRunner(const behaviour::Registry& registry, Robot& robot, MissionDesk::Where where,
                Listener& listener);

  // Begins at the next step. Throws behaviour::BadTree and input::InputError. Asks for memory.
  void load(const std::string& name_or_path);

  // Every tick of the robot; `robot.situation` is filled in. The tree is ticked where `is_due`, and at once
  // where the robot begins to fall or to lie, or the command passes to somebody else. Then robot.orders holds
  // what is to be passed on. True: a tree was ticked or halted.
  bool step(bool is_due, bool is_enabled);
  // A request that has been answered already, or a number 0, does nothing. An old one that was there before
  // this is refused, but for an end, unless go_on_from() tells that the one before had still to answer it.
  void ask(const BehaviourRequest& request, std::int64_t now_ns);

  void tell(BehaviourState& state) const noexcept;
  // The next part.
  void tell(BehaviourNodes& nodes) noexcept;

  [[nodiscard]] RunnerState state() const noexcept;
  // Before the first step. Reads the mission beside it, if it is another than the loaded one.
  void go_on_from(const RunnerState& state);

 private:
  [[nodiscard]] behaviour::Tree* shown() const noexcept;
  [[nodiscard]] bool is_disturbed() noexcept;
  void take_up(ReadMission read);
  void answer(bool refused, std::string_view text) noexcept;
  void line(bool is_trouble, const char* text) noexcept;
  void advance();
  void run();
  void wait();
  void halt();
  void show(bool stand_up) noexcept;
  void begin_revision() noexcept;
  void after_tree(const behaviour::Tree& tree) noexcept;
  void pass_sayings() noexcept;
  void enter(std::uint32_t state) noexcept;
  void begin_anew(const char* why) noexcept;
  void end_mission();
  void turn_old_away(const BehaviourRequest& request) noexcept;
  void tell_what_waited() noexcept;
  [[nodiscard]] bool was_taken_meanwhile() const noexcept;
  [[nodiscard]] std::string_view cause_of_failure() const noexcept;
  [[nodiscard]] bool is_repeated(const Orders::Saying& saying) noexcept;

  const behaviour::Registry& registry_;
  Robot& robot_;
  Listener& listener_;
  std::unique_ptr<LoadedMission> mission_, next_;
  MissionDesk desk_;  // after these: its thread looks at the tree that it is to change

  std::uint32_t state_ = behaviour_state::state::none;
  bool ends_ = false;           // it halts because a person has ended it, or to make room for the next one
  bool is_halted_ = true;       // the tree has come to its end
  bool stand_up_runs_ = false;  // of a mission that waits
  bool shows_stand_up_ = false;
  bool was_enabled_ = true;
  bool is_disabling_ = false;  // it halts because it was disabled; enabled again meanwhile, it begins anew

  std::optional<std::uint32_t>
      inherited_;  // state of a mission that is still to be read; none runs till then
  bool goes_on_ = false, has_been_asked_ = false;

  std::uint32_t asked_ = 0, answered_ = 0;  // numbers of requests: being worked on, answered
  bool refused_ = false;
  bool is_dropped_ = false;        // what is being read: its mission was ended before it began
  std::int64_t answered_ns_ = -1;  // an answer's text stays for a while
  std::array<char, 208> text_{};
  std::array<char, 208> waiting_text_{};  // the newest line, while an answer is still to be read
  bool has_waiting_text_ = false;

  std::uint32_t revision_ = 1;
  std::uint32_t told_node_ = 0;
  std::uint64_t ticks_ = 0, transitions_ = 0;
  std::array<std::int64_t, kTreeTransitions> transition_ns_{};
  std::array<std::uint32_t, kTreeTransitions> transition_node_{};
  std::array<std::uint8_t, kTreeTransitions> transition_to_{};

  std::uint32_t last_fall_ = 0, last_commander_ = 0, last_may_get_up_ = 0;
  std::optional<std::uint32_t> last_changes_;  // of who commands

  struct Said {
    Orders::Saying saying;
    std::int64_t at_ns = 0;
  };
  std::array<Said, Orders::kMostSayings> last_said_{};
  std::size_t said_ = 0;
  std::size_t told_sayings_ = 0;  // of this tick
  std::array<char, 256>
      wanted_{};  // name of the mission that is being read, and then of the one that is loaded
};

}  // namespace gaitway::behaviour_leaves
