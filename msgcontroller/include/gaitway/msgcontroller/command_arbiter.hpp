// Makes orders the command: those of people before those of the behaviour, none during an emergency stop, and
// nothing by itself after a stop. It runs where stops are obeyed, beside the message controller, so that it
// outlives the main controller and with it every plug-in: a behaviour that was started anew knows nothing of
// a stop, this does. docs/commands.md has the table.
#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/msgcontroller/command_authority.hpp"
#include "gaitway/msgcontroller/command_channel.hpp"
#include "gaitway/msgcontroller/command_intake.hpp"

namespace gaitway::msgcontroller {

// The largest command that is taken from a scenario or a command line.
inline constexpr double kLargestWalkSpeed_m_per_s = 1.0;
inline constexpr double kLargestTurnRate_rad_per_s = 2.0;
// Throws std::invalid_argument unless `walk`, of an option --walk, is forward m/s, left m/s and turn rad/s,
// and not too fast.
void check_walk_option(std::span<const double> walk);

// As CommandRequest::verb has the first two; the third, that whoever commanded has gone.
enum class CommandVerb : std::uint8_t { take, let_go, is_lost };

// What people have asked for and became the command in one millisecond, for whoever wants to do it again.
struct PassedOrders {
  std::optional<CommandVerb> verb;
  std::optional<WalkCommand> walk;
  std::optional<WalkToRequest> way;
  std::optional<MotionRequest> motion;
  std::optional<HeadCommand> head;
};

class CommandArbiter final : public CommandListener {
 public:
  // The robot stands until the first order. Throws msgclient::TopicError when somebody else writes one of the
  // commands.
  explicit CommandArbiter(msgclient::Client& client);

  // Once a millisecond, before the message controller's, which is or is not in an emergency stop. No
  // allocation.
  PassedOrders step(std::int64_t now_ns, bool emergency_stopped) noexcept;
  // A command that the message controller has carried out just now.
  void on_command(msgclient::UserCommandKind kind, std::int64_t now_ns) noexcept override;

  // Orders of people that come in another way than by topics. False: not obeyed.
  bool order(const WalkCommand& walk, std::int64_t now_ns) noexcept;
  bool order(const WalkToRequest& way, std::int64_t now_ns) noexcept;
  bool order(const MotionRequest& motion, std::int64_t now_ns) noexcept;
  bool order(const HeadCommand& head, std::int64_t now_ns) noexcept;
  bool order(CommandVerb verb, std::int64_t now_ns) noexcept;

  // Requests of people that lie in the topics do not count, and the walk that is in force ends then. Whoever
  // commanded so far is not lost when the first of them comes.
  void begin_anew_with_people(std::int64_t walk_until_ns) noexcept;
  // The robot stands; nothing is obeyed any more.
  void end(std::int64_t now_ns) noexcept;

  [[nodiscard]] const CommandAuthority& authority() const noexcept { return authority_; }

 private:
  void hear_stops(std::int64_t now_ns) noexcept;
  void drop(OrderSource source) noexcept;
  void hear_robot(std::int64_t now_ns) noexcept;
  void hear_people(std::int64_t now_ns, PassedOrders& passed) noexcept;
  void hear_behaviour(std::int64_t now_ns) noexcept;
  [[nodiscard]] std::optional<CommandVerb> take_verb() noexcept;
  [[nodiscard]] bool person_may(bool ends_something, std::int64_t now_ns) noexcept;
  [[nodiscard]] bool behaviour_may(bool is_motion) noexcept;
  void note_ends(std::int64_t now_ns, PassedOrders& passed) noexcept;
  void stop(std::int64_t now_ns) noexcept;
  void end_all(std::int64_t now_ns) noexcept;
  void end_orders_of(OrderSource source, std::int64_t now_ns) noexcept;
  void end_walk(std::int64_t now_ns) noexcept;
  void end_way(std::int64_t now_ns) noexcept;
  void end_motion(std::int64_t now_ns) noexcept;
  void end_head(std::int64_t now_ns) noexcept;
  void hold_head(std::int64_t now_ns) noexcept;
  [[nodiscard]] std::uint32_t own_number() noexcept;
  void tell(std::int64_t now_ns) noexcept;

  CommandAuthority authority_;
  CommandChannel<WalkCommand> walk_;
  CommandChannel<WalkToRequest> way_;
  CommandChannel<MotionRequest> motion_;
  CommandChannel<HeadCommand> head_;
  msgclient::Reader<CommandRequest> requests_;
  msgclient::Reader<StopRequest> stop_requests_;
  msgclient::Reader<Estimate> estimates_;
  msgclient::Reader<NavigationState> ways_;
  msgclient::Reader<MotionState> motions_;
  msgclient::Writer<CommandState> states_;
  std::uint64_t request_seen_ = 0, stop_seen_ = 0, estimate_seen_ = 0, way_seen_ = 0, motion_seen_ = 0;
  Estimate estimate_{};
  NavigationState navigation_{};
  MotionState motion_state_{};
  bool fallen_ = false;
  std::int64_t behaviour_ends_ns_ = 0;  // when it has had nothing in force for a while; 0: it has
  std::int64_t walk_until_ns_ = 0;      // of the walk that is in force; 0: for ever
  StopRequest stops_{};                 // the newest that was heard
  std::uint32_t numbers_ = 0, turned_away_ = 0, answered_ = 0;
  bool ended_ = false;
  bool awaits_emergency_stop_ = false;  // it was heard, and the message controller is about to obey
  bool hears_loss_ = true;
  CommandState told_{};
  std::int64_t told_ns_ = -1;  // not yet
};

}  // namespace gaitway::msgcontroller
