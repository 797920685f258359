// What of the robot touched what of the world, otherwise than by standing, or what else of the robot: from
// when to when, and how hard.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gaitway/simulator/plant.hpp"

namespace gaitway::tools {

// One pair of link and solid, or of links, that touched, with no longer a break than kContactBreak_ns.
struct ContactEpisode {
  int link = 0;
  int other_link = simulator::BodyContact::kNoLink;  // in place of a solid
  world::Kind kind = world::Kind::floor;
  std::string with = "floor";           // the solid's name
  std::int64_t from_ns = 0, to_ns = 0;  // beginning of the first millisecond, end of the last one
  double peak_N = 0.0;                  // of one millisecond
  double impulse_Ns = 0.0;
};
inline constexpr std::int64_t kContactBreak_ns = 100'000'000;

class ContactLog {
 public:
  static constexpr std::size_t kMost = 200;  // are kept; further ones are counted

  // Of the millisecond that ended at `now_ns`, in the world as it was then; `geometry` tells one world from
  // the next (Plant::geometry()).
  void add(std::int64_t now_ns, std::span<const simulator::BodyContact> contacts,
           const std::optional<world::World>& world, std::uint32_t geometry);

  [[nodiscard]] std::uint64_t total() const noexcept { return total_; }
  [[nodiscard]] const std::vector<ContactEpisode>& episodes() const noexcept { return episodes_; }

 private:
  struct Open {
    int link = 0, solid = 0, other_link = 0;
    std::int64_t last_ns = 0;
    std::size_t episode = kMost;  // kMost: not kept
  };
  std::vector<ContactEpisode> episodes_;
  std::vector<Open> open_;
  std::uint32_t geometry_ = 0;
  std::uint64_t total_ = 0;
};

// For summary.json.
[[nodiscard]] nlohmann::ordered_json contacts_json(const ContactLog& log, const urdf::RobotModel& robot);

}  // namespace gaitway::tools
