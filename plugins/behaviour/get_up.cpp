// Getting up: lie still, the motion for that side, stand; a few times, then never again until it has stood.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "leaf_base.hpp"
#include "played_motion.hpp"

namespace gaitway::behaviour_leaves {
namespace {

using behaviour::Call;
using behaviour::Outcome;

constexpr double kStill_rad_per_s = 0.15;
constexpr std::int64_t kStillFor_ns = 400'000'000;
constexpr std::int64_t kStandsFor_ns = 400'000'000;
// After the motion's end: until what the filters say of the fall, and the walk of its stand, has come round.
constexpr std::int64_t kMostForStand_ns = 3'000'000'000;

class GetUp final : public RobotAction {
 public:
  using RobotAction::RobotAction;

  Outcome on_start(Call& call) noexcept override {
    if (has_been_up_for(call.get<std::int64_t>(1).value_or(0))) {
      attempts_ = 0;
      has_given_up_ = false;
    }
    if (attempts_ >= most(call)) return give_up("no stand has lasted");
    has_played_ = false;
    enter(Doing::comes_to_rest, call);
    return on_running(call);
  }

  Outcome on_running(Call& call) noexcept override {
    switch (doing_) {
      case Doing::comes_to_rest:
        return rest(call);
      case Doing::gets_up:
        return watch_motion(call);
      case Doing::stands:
        return watch_stand(call);
    }
    return Outcome::failure;
  }

  Halt on_halt(Call& call) noexcept override {
    if (doing_ == Doing::gets_up) {
      tried(call);
      if (now().commands_motions()) motion_.leave(now(), orders());
    }
    return on_halting(call);
  }
  Halt on_halting(Call&) noexcept override {
    const bool has_ended = doing_ != Doing::gets_up || motion_.has_left(now(), orders());
    return has_ended ? Halt::ended : Halt::ending;
  }

 private:
  enum class Doing : std::uint8_t { comes_to_rest, gets_up, stands };

  [[nodiscard]] static std::int64_t most(Call& call) noexcept {
    return call.get<std::int64_t>(0).value_or(0);
  }
  // Since the last attempt, standing or walking.
  [[nodiscard]] bool has_been_up_for(std::int64_t time_ns) const noexcept {
    return on_feet().to_ns - std::max(on_feet().from_ns, tried_ns_) >= time_ns;
  }
  void enter(Doing doing, Call& call) noexcept {
    doing_ = doing;
    since_ns_ = holds_since_ns_ = call.now_ns();
  }

  // Lies still, on a side that is known, and whoever plans the joints is done with the fall.
  Outcome rest(Call& call) noexcept {
    if (now().stands()) {
      enter(Doing::stands, call);
      return Outcome::running;
    }
    const Estimate* const estimate = now().estimate;
    const bool is_still = now().lies() && std::abs(estimate->angular_velocity[0]) <= kStill_rad_per_s &&
                          std::abs(estimate->angular_velocity[1]) <= kStill_rad_per_s &&
                          std::abs(estimate->angular_velocity[2]) <= kStill_rad_per_s;
    const bool is_stopped = now().network != nullptr && now().network->mode != network_state::mode::batches &&
                            now().network->mode != network_state::mode::holding;
    if (!is_still || is_stopped || now().plays_motion()) holds_since_ns_ = call.now_ns();
    if (call.now_ns() - holds_since_ns_ < kStillFor_ns) return Outcome::running;
    const auto name = call.get<behaviour::Text>(lies_on_front() ? 2 : 3);
    if (!name || name->view().empty()) return fail("GetUp", "there is no motion for the side it lies on");
    std::array<char, 160> text{};
    fmt::format_to_n(text.data(), text.size() - 1, "gets up: attempt {} by '{}'", attempts_ + 1,
                     name->view());
    orders().say(text.data());
    motion_.order(name->view(), now(), orders());
    has_played_ = true;
    enter(Doing::gets_up, call);
    return Outcome::running;
  }

  // By where the trunk's x axis goes: down or up. One that lies on its side, or leans on something, tries the
  // two in turn, the likelier first.
  [[nodiscard]] bool lies_on_front() const noexcept {
    const double down = std::sin(now().estimate->attitude[1]);
    constexpr double kOnItsSide = 0.5;
    const bool in_turn = std::abs(down) < kOnItsSide && attempts_ % 2 != 0;
    return (down >= 0.0) != in_turn;
  }

  Outcome watch_motion(Call& call) noexcept {
    using Stage = PlayedMotion::Stage;
    switch (motion_.stage(now(), orders())) {
      case Stage::waits:
      case Stage::plays:
        return Outcome::running;
      case Stage::finished:
        enter(Doing::stands, call);
        return Outcome::running;
      case Stage::refused:
        return try_again(call, reinterpret_cast<const char*>(now().motion->text));
      case Stage::broken_off:
        return try_again(call, "the motion did not come to its end");
      case Stage::not_answered:
        return try_again(call, "the order has not been answered");
      case Stage::replaced:
        return fail("GetUp", "another node plays a motion of its own");
    }
    return Outcome::failure;
  }

  Outcome watch_stand(Call& call) noexcept {
    if (!now().stands()) holds_since_ns_ = call.now_ns();
    if (call.now_ns() - holds_since_ns_ >= kStandsFor_ns) {
      if (has_played_) tried(call);  // counts until it has been up for long enough
      return Outcome::success;
    }
    if (!has_played_ && !now().stands()) {  // it had caught itself, and now it has not
      enter(Doing::comes_to_rest, call);
      return Outcome::running;
    }
    const bool falls = now().estimate != nullptr && now().estimate->fall == estimate::fall::falls;
    if (falls) return try_again(call, "it fell again");
    if (call.now_ns() - since_ns_ >= kMostForStand_ns)
      return try_again(call, "it does not stand after the motion");
    return Outcome::running;
  }

  void tried(Call& call) noexcept {
    ++attempts_;
    tried_ns_ = call.now_ns();
  }

  Outcome try_again(Call& call, const char* why) noexcept {
    tried(call);
    if (attempts_ >= most(call)) return give_up(why);
    std::array<char, 200> text{};
    fmt::format_to_n(text.data(), text.size() - 1, "attempt {} of {}: {}", attempts_, most(call), why);
    orders().tell_trouble("GetUp", text.data());
    enter(Doing::comes_to_rest, call);
    return Outcome::running;
  }

  // Said once.
  Outcome give_up(const char* why) noexcept {
    if (has_given_up_) return Outcome::failure;
    has_given_up_ = true;
    std::array<char, 200> text{};
    fmt::format_to_n(text.data(), text.size() - 1, "gives up after {} attempts: {}", attempts_, why);
    return fail("GetUp", text.data());
  }

  Doing doing_ = Doing::comes_to_rest;
  bool has_given_up_ = false;
  std::int64_t since_ns_ = 0, holds_since_ns_ = 0;
  bool has_played_ = false;     // a motion, since it was started
  std::int64_t attempts_ = 0;   // since it was last up for long enough
  std::int64_t tried_ns_ = -1;  // end of the last of them
  PlayedMotion motion_;
};

}  // namespace

void register_getting_up(behaviour::Registry& registry, const std::shared_ptr<Robot>& robot) {
  registry.add_action(
      {.id = "GetUp",
       .ports = {integer_port("attempts", 1, 20, "3", "after so many it gives up"),
                 duration_port("steady", "3 s", "attempts are forgotten when it has stood for so long"),
                 text_port("front", "get_up_front", "motion for one that lies on its front"),
                 text_port("back", "get_up_back", "motion for one that lies on its back")},
       .meaning =
           "Waits until the robot lies still, plays the motion for the side it lies on, and succeeds when it "
           "stands. Fails after some attempts, also such as led to a stand that did not last, and then at "
           "once until the robot has stood again"},
      [robot] { return std::make_unique<GetUp>(robot); });
}

}  // namespace gaitway::behaviour_leaves
