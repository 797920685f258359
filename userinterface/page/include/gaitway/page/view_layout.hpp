// The frame that a page draws the robot from, thirty times a second: one table, out of which the encoder, the
// documentation (docs/view.md) and the page's own decoder (userinterface/web/src/view_layout.ts) come.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

namespace gaitway::page {

inline constexpr std::uint8_t kViewVersion = 1;
inline constexpr std::size_t kViewJoints = 40;     // the first of a robot that has more
inline constexpr std::size_t kViewFootsteps = 4;   // the next ones
inline constexpr std::size_t kViewNameBytes = 16;  // of who commands
inline constexpr std::size_t kMostViewBytes = 200;
inline constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

// What the robot does, as people would say it.
enum class Activity : std::uint8_t { unknown, stands, walks, moves, falls, lies };

// All that is drawn. What is not known is kUnknown. Places are in the frame `odom`; those that are said to be
// "from the base" are differences of places there.
struct ViewState {
  std::uint32_t frame = 0;  // counts up
  double robot_time_s = 0.0;
  double mode = kUnknown;  // NetworkState::mode
  Activity activity = Activity::unknown;
  std::array<double, 2> contact{kUnknown, kUnknown};  // [Side] 1: bears load
  // Since the newest came: joints, pose, message controller's state, plan, beat of the robot's clock.
  std::array<double, 5> age_s{kUnknown, kUnknown, kUnknown, kUnknown, kUnknown};
  double round_trip_s = kUnknown;  // of a frame to the page and its acknowledgement
  std::array<double, 2> base_place_m{kUnknown, kUnknown};
  double base_height_m = kUnknown;
  std::array<double, 4> base_turn{kUnknown, kUnknown, kUnknown, kUnknown};  // x, y, z, w
  std::array<double, 3> com_m{kUnknown, kUnknown, kUnknown};  // z above the ground; x, y from the base
  std::array<double, 2> zmp_m{kUnknown, kUnknown}, planned_zmp_m{kUnknown, kUnknown};  // from the base
  std::array<double, 2> foot_force_N{kUnknown, kUnknown};
  std::array<double, 3> velocity{kUnknown, kUnknown, kUnknown};  // forward, left [m/s], turning left [rad/s]
  std::array<bool, kViewJoints> joint_trouble{};
  std::uint64_t batches_late = 0, batches_refused = 0, tails_played = 0;
  std::size_t footstep_count = 0;
  std::array<std::array<double, 3>, kViewFootsteps> footsteps{};  // x, y from the base [m], yaw [rad]
  std::string_view commander;                                     // empty: nobody
  std::size_t joint_count = 0;
  std::array<double, kViewJoints> joints_rad{};
};

enum class ViewType : std::uint8_t { uint8, int16, uint16, int32, uint32 };

struct ViewRow {
  std::string_view name;
  ViewType type;
  std::size_t count;  // values, one after the other; 0: as many as `joint_count` says
  double
      scale;  // of one unit of the raw number; 0: counters, bits and letters, of which the lowest bits travel
  std::string_view unit;
  std::string_view doc;
  double (*value)(const ViewState& state, std::size_t index);
};

[[nodiscard]] constexpr std::size_t bytes_of(ViewType type) noexcept {
  constexpr std::array<std::size_t, 5> kBytes{1, 2, 2, 4, 4};
  return kBytes[static_cast<std::size_t>(type)];
}

// In their order in the frame, without gaps, each little-endian.
inline constexpr std::array kViewRows{
    ViewRow{"version", ViewType::uint8, 1, 1.0, "",
            "of this layout: a page that knows another one must be loaded again",
            [](const ViewState&, std::size_t) { return static_cast<double>(kViewVersion); }},
    ViewRow{"joint_count", ViewType::uint8, 1, 1.0, "", "of the last row",
            [](const ViewState& state, std::size_t) { return static_cast<double>(state.joint_count); }},
    ViewRow{"frame", ViewType::uint32, 1, 0.0, "", "counts up; the page sends these four bytes back",
            [](const ViewState& state, std::size_t) { return static_cast<double>(state.frame); }},
    ViewRow{"robot_time", ViewType::uint32, 1, 1e-3, "s", "the robot's clock",
            [](const ViewState& state, std::size_t) { return state.robot_time_s; }},
    ViewRow{"mode", ViewType::uint8, 1, 1.0, "",
            "of the message controller: 0 plays batches, 1 plays a safe tail, 2 holds, 3 emergency stop",
            [](const ViewState& state, std::size_t) { return state.mode; }},
    ViewRow{"activity", ViewType::uint8, 1, 1.0, "",
            "0 not known, 1 stands, 2 walks, 3 plays a motion, 4 falls, 5 lies",
            [](const ViewState& state, std::size_t) { return static_cast<double>(state.activity); }},
    ViewRow{"contact", ViewType::uint8, 2, 1.0, "", "left, right foot: 1 bears load, 0 is lifted",
            [](const ViewState& state, std::size_t i) { return state.contact[i]; }},
    ViewRow{"age", ViewType::uint16, 5, 1e-3, "s",
            "since the newest came of: joints, pose, message controller's state, plan, robot's clock",
            [](const ViewState& state, std::size_t i) { return state.age_s[i]; }},
    ViewRow{"round_trip", ViewType::uint16, 1, 1e-3, "s",
            "of the newest frame that the page has acknowledged",
            [](const ViewState& state, std::size_t) { return state.round_trip_s; }},
    ViewRow{"base_place", ViewType::int32, 2, 1e-4, "m", "x, y of the base in `odom`",
            [](const ViewState& state, std::size_t i) { return state.base_place_m[i]; }},
    ViewRow{"base_height", ViewType::int16, 1, 1e-4, "m", "z of the base in `odom`",
            [](const ViewState& state, std::size_t) { return state.base_height_m; }},
    ViewRow{"base_turn", ViewType::int16, 4, 1.0 / 32767.0, "",
            "orientation of the base in `odom`: quaternion x, y, z, w",
            [](const ViewState& state, std::size_t i) { return state.base_turn[i]; }},
    ViewRow{"com", ViewType::int16, 3, 1e-4, "m", "estimated centre of mass: x, y from the base, z in `odom`",
            [](const ViewState& state, std::size_t i) { return state.com_m[i]; }},
    ViewRow{"zmp", ViewType::int16, 2, 1e-4, "m", "measured ZMP: x, y from the base",
            [](const ViewState& state, std::size_t i) { return state.zmp_m[i]; }},
    ViewRow{"planned_zmp", ViewType::int16, 2, 1e-4, "m", "ZMP that is planned for now: x, y from the base",
            [](const ViewState& state, std::size_t i) { return state.planned_zmp_m[i]; }},
    ViewRow{"foot_force", ViewType::uint16, 2, 0.1, "N", "left, right, measured",
            [](const ViewState& state, std::size_t i) { return state.foot_force_N[i]; }},
    ViewRow{"velocity", ViewType::int16, 3, 1e-3, "m/s, m/s, rad/s",
            "of the base: forward, left, turning left",
            [](const ViewState& state, std::size_t i) { return state.velocity[i]; }},
    ViewRow{"joint_trouble", ViewType::uint8, kViewJoints / 8, 0.0, "",
            "bit j % 8 of byte j / 8: joint j is missing or reports a fault",
            [](const ViewState& state, std::size_t i) {
              unsigned bits = 0;
              for (std::size_t bit = 0; bit < 8; ++bit) {
                bits |= state.joint_trouble[8 * i + bit] ? 1U << bit : 0U;
              }
              return static_cast<double>(bits);
            }},
    ViewRow{"batches_late", ViewType::uint16, 1, 0.0, "", "that came too late since the start",
            [](const ViewState& state, std::size_t) { return static_cast<double>(state.batches_late); }},
    ViewRow{"batches_refused", ViewType::uint16, 1, 0.0, "", "that were refused since the start",
            [](const ViewState& state, std::size_t) { return static_cast<double>(state.batches_refused); }},
    ViewRow{"tails_played", ViewType::uint16, 1, 0.0, "",
            "cycles that were played from a safe tail since the start",
            [](const ViewState& state, std::size_t) { return static_cast<double>(state.tails_played); }},
    ViewRow{"footstep_count", ViewType::uint8, 1, 1.0, "", "of the next row's footsteps that are planned",
            [](const ViewState& state, std::size_t) { return static_cast<double>(state.footstep_count); }},
    ViewRow{"footstep", ViewType::int16, 3 * kViewFootsteps, 1e-3, "m, m, rad",
            "planned footsteps that have not landed yet: x, y from the base and yaw, one after the other",
            [](const ViewState& state, std::size_t i) { return state.footsteps[i / 3][i % 3]; }},
    ViewRow{"commander", ViewType::uint8, kViewNameBytes, 0.0, "",
            "name of who commands, UTF-8, cut off, filled up with 0; all 0: nobody",
            [](const ViewState& state, std::size_t i) {
              return i < state.commander.size()
                         ? static_cast<double>(static_cast<unsigned char>(state.commander[i]))
                         : 0.0;
            }},
    ViewRow{"joint", ViewType::int16, 0, 1e-4, "rad",
            "measured position of each joint, in the order of the description",
            [](const ViewState& state, std::size_t i) { return state.joints_rad[i]; }},
};

[[nodiscard]] constexpr std::size_t view_bytes(std::size_t joint_count) noexcept {
  std::size_t bytes = 0;
  for (const ViewRow& row : kViewRows) {
    bytes += bytes_of(row.type) * (row.count > 0 ? row.count : joint_count);
  }
  return bytes;
}
static_assert(view_bytes(kViewJoints) <= kMostViewBytes);

}  // namespace gaitway::page
