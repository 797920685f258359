#include "tools/wireless/outage_schedule.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "gaitway/facts/random_stream.hpp"

namespace gaitway::tools {
namespace {

constexpr std::uint64_t kOutageStream = 0x6F75'7461'6765;

void require_order(std::int64_t shortest_ns, std::int64_t longest_ns, const char* what) {
  if (shortest_ns <= 0 || longest_ns < shortest_ns) {
    throw std::invalid_argument(std::string(what) +
                                ": the shortest must be above 0, and the longest no shorter. Write it like "
                                "0.3s..10s");
  }
}

}  // namespace

void OutageSchedule::add(const Outage& outage) {
  if (outage.end_ns <= outage.begin_ns) {
    return;
  }
  Outage whole = outage;
  const auto first = std::ranges::lower_bound(outages_, outage.begin_ns, {}, &Outage::end_ns);
  auto last = first;
  for (; last != outages_.end() && last->begin_ns <= outage.end_ns; ++last) {
    whole.begin_ns = std::min(whole.begin_ns, last->begin_ns);
    whole.end_ns = std::max(whole.end_ns, last->end_ns);
  }
  outages_.insert(outages_.erase(first, last), whole);
}

std::optional<Outage> OutageSchedule::covering(std::int64_t at_ns) const {
  return overlapping(at_ns, at_ns);
}

std::optional<Outage> OutageSchedule::overlapping(std::int64_t from_ns, std::int64_t to_ns) const {
  const auto found = std::ranges::upper_bound(outages_, from_ns, {}, &Outage::end_ns);
  if (found == outages_.end() || found->begin_ns > to_ns) {
    return std::nullopt;
  }
  return *found;
}

std::optional<OutageEdge> OutageSchedule::edge_after(std::int64_t at_ns) const {
  const auto found = std::ranges::upper_bound(outages_, at_ns, {}, &Outage::end_ns);
  if (found == outages_.end()) {
    return std::nullopt;
  }
  const bool down = found->begin_ns > at_ns;
  return OutageEdge{down ? found->begin_ns : found->end_ns, down};
}

std::vector<Outage> draw_outages(const RandomOutages& wanted, std::uint64_t seed, std::int64_t start_ns) {
  require_order(wanted.shortest_ns, wanted.longest_ns, "outages");
  require_order(wanted.shortest_up_ns, wanted.longest_up_ns, "time between outages");
  facts::RandomStream random(seed, kOutageStream);
  std::vector<Outage> outages;
  for (std::size_t i = 0; i < wanted.count; ++i) {
    const auto up_ns = static_cast<std::int64_t>(
        random.uniform() * static_cast<double>(wanted.longest_up_ns - wanted.shortest_up_ns));
    const double factor = static_cast<double>(wanted.longest_ns) / static_cast<double>(wanted.shortest_ns);
    const auto length_ns = static_cast<std::int64_t>(static_cast<double>(wanted.shortest_ns) *
                                                     std::pow(factor, random.uniform()));
    const std::int64_t begin_ns = start_ns + wanted.shortest_up_ns + up_ns;
    outages.push_back({begin_ns, begin_ns + length_ns});
    start_ns = outages.back().end_ns;
  }
  return outages;
}

}  // namespace gaitway::tools
