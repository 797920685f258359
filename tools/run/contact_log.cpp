// Joins the contacts of single milliseconds to episodes.
#include "tools/run/contact_log.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "gaitway/facts/facts.hpp"

namespace gaitway::tools {

void ContactLog::add(std::int64_t now_ns, std::span<const simulator::BodyContact> contacts,
                     const std::optional<world::World>& world, std::uint32_t geometry) {
  if (std::exchange(geometry_, geometry) != geometry) open_.clear();  // their numbers mean other solids now
  std::erase_if(open_, [now_ns](const Open& open) { return now_ns - open.last_ns > kContactBreak_ns; });
  for (const simulator::BodyContact& contact : contacts) {
    auto open = std::ranges::find_if(open_, [&contact](const Open& one) {
      return one.link == contact.link && one.solid == contact.solid && one.other_link == contact.other_link;
    });
    if (open == open_.end()) {
      ++total_;
      const bool kept = episodes_.size() < kMost;
      open_.push_back(
          {contact.link, contact.solid, contact.other_link, now_ns, kept ? episodes_.size() : kMost});
      open = open_.end() - 1;
      if (kept) {
        ContactEpisode& begun = episodes_.emplace_back();
        begun.link = contact.link;
        begun.other_link = contact.other_link;
        begun.from_ns = now_ns - facts::kMillisecond_ns;
        if (contact.solid != simulator::BodyContact::kFloor) {
          const world::Solid solid = world->all_solids(true)[static_cast<std::size_t>(contact.solid)];
          begun.kind = solid.kind;
          begun.with = solid.name;
        }
      }
    }
    open->last_ns = now_ns;
    if (open->episode == kMost) continue;
    ContactEpisode& episode = episodes_[open->episode];
    episode.to_ns = now_ns;
    episode.peak_N = std::max(episode.peak_N, contact.force_N);
    episode.impulse_Ns += contact.force_N * 1e-9 * static_cast<double>(facts::kMillisecond_ns);
  }
}

nlohmann::ordered_json contacts_json(const ContactLog& log, const urdf::RobotModel& robot) {
  auto list = nlohmann::ordered_json::array();
  const auto link = [&robot](int index) { return robot.links[static_cast<std::size_t>(index)].name; };
  for (const ContactEpisode& episode : log.episodes()) {
    const bool within_robot = episode.other_link != simulator::BodyContact::kNoLink;
    list.push_back({{"link", link(episode.link)},
                    {"kind", within_robot ? "link" : world::name(episode.kind)},
                    {"with", within_robot ? link(episode.other_link) : episode.with},
                    {"from_s", static_cast<double>(episode.from_ns) * 1e-9},
                    {"to_s", static_cast<double>(episode.to_ns) * 1e-9},
                    {"peak_N", episode.peak_N},
                    {"impulse_Ns", episode.impulse_Ns}});
  }
  return {{"total", log.total()}, {"first", list}};
}

}  // namespace gaitway::tools
