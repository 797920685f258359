// What the leaves of a tick want of the robot, until whoever ticks the tree passes it on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "gaitway/behaviour_leaves/situation.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::behaviour_leaves {

struct Velocity {
  double forward_m_per_s = 0.0, left_m_per_s = 0.0, turn_rad_per_s = 0.0;  // the robot's own heading
};

// The numbers of the behaviour's orders have this bit, those of people have not.
inline constexpr std::uint32_t kBehaviourNumber = 0x8000'0000U;

class Orders {
 public:
  struct Saying {
    std::array<char, 208> text{};  // ended by 0
    bool is_trouble = false;
  };
  static constexpr std::size_t kMostSayings = 8;  // a tick; further ones are left out

  // Before each tick. Walking has to be asked for anew in each: what nobody asks for ends.
  void begin(std::int64_t now_ns) noexcept;

  void walk(const Velocity& velocity) noexcept;
  // Each gives the number that navigation_state or motion_state answers.
  std::uint32_t walk_to(const Pose& goal_in_world) noexcept;
  std::uint32_t cancel_way() noexcept;
  std::uint32_t play(std::string_view motion) noexcept;
  std::uint32_t leave_motion() noexcept;
  // Gives the number of the order; its stamp is put in here.
  std::uint32_t look(HeadCommand command) noexcept;
  // A leaf that has the head no more sends it home; not where another leaf has given a newer order.
  void look_ahead_after(std::uint32_t number) noexcept;
  void look_ahead() noexcept;
  void say(std::string_view text) noexcept;
  void tell_trouble(std::string_view leaf, std::string_view why) noexcept;

  // The newest order of its kind, of whichever leaf. 0: none yet.
  [[nodiscard]] std::uint32_t way_number() const noexcept { return way_number_; }
  [[nodiscard]] std::uint32_t motion_number() const noexcept { return motion_number_; }

  // For whoever passes them on: what this tick has ordered.
  [[nodiscard]] const std::optional<Velocity>& walking() const noexcept { return walking_; }
  [[nodiscard]] const std::optional<WalkToRequest>& way() const noexcept { return way_; }
  [[nodiscard]] const std::optional<MotionRequest>& motion() const noexcept { return motion_; }
  [[nodiscard]] const std::optional<HeadCommand>& head() const noexcept { return head_; }
  [[nodiscard]] std::span<const Saying> sayings() const noexcept { return std::span(sayings_).first(said_); }

 private:
  [[nodiscard]] std::uint32_t next_number() noexcept;
  Saying* new_saying(bool is_trouble) noexcept;

  std::int64_t now_ns_ = 0;
  std::uint32_t last_number_ = 0, way_number_ = 0, motion_number_ = 0, head_number_ = 0;
  std::optional<Velocity> walking_;
  std::optional<WalkToRequest> way_;
  std::optional<MotionRequest> motion_;
  std::optional<HeadCommand> head_;
  std::array<Saying, kMostSayings> sayings_{};
  std::size_t said_ = 0;
};

}  // namespace gaitway::behaviour_leaves
