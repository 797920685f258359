// When a link is down: outages that are planned, drawn from a seed or ordered while it runs.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace gaitway::tools {

struct Outage {
  std::int64_t begin_ns = 0;
  std::int64_t end_ns = 0;  // the first instant at which the link is up again

  bool operator==(const Outage&) const = default;
};

struct OutageEdge {
  std::int64_t at_ns = 0;
  bool down = false;  // from then on
};

class OutageSchedule {
 public:
  // Outages that overlap or touch become one. One that ends before it begins is none.
  void add(const Outage& outage);

  [[nodiscard]] std::optional<Outage> covering(std::int64_t at_ns) const;
  // The first one with an instant in from..to, both included.
  [[nodiscard]] std::optional<Outage> overlapping(std::int64_t from_ns, std::int64_t to_ns) const;
  // The first edge later than that.
  [[nodiscard]] std::optional<OutageEdge> edge_after(std::int64_t at_ns) const;
  [[nodiscard]] const std::vector<Outage>& all() const { return outages_; }  // in order, none touches another

 private:
  std::vector<Outage> outages_;
};

// So many outages of so long, with the link up before each and in between.
struct RandomOutages {
  std::size_t count = 0;
  std::int64_t shortest_ns = 0, longest_ns = 0;        // every factor is as likely as any other: log-uniform
  std::int64_t shortest_up_ns = 0, longest_up_ns = 0;  // uniform
};

// Throws std::invalid_argument where a shortest is not above 0 or a longest is below its shortest.
[[nodiscard]] std::vector<Outage> draw_outages(const RandomOutages& wanted, std::uint64_t seed,
                                               std::int64_t start_ns);

}  // namespace gaitway::tools
