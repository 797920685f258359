// A topic written and read, ours and the peers', in one thread: one round, as JSON.
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <nlohmann/json.hpp>

#include "gaitway/msgclient/topics.hpp"
#include "topic_rival.hpp"
#include "turns.hpp"

namespace gaitway::peers {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kTurns = 25;
constexpr std::size_t kBytesOfTurn = 4'000'000;  // so that large values and small ones take a turn alike
constexpr std::size_t kMostPairs = 10'000;

std::vector<std::unique_ptr<TopicRival>> rivals_for(std::size_t bytes) {
  std::vector<std::unique_ptr<TopicRival>> rivals;
  rivals.push_back(our_topic(bytes));
  rivals.push_back(seqlock_topic(bytes));
#ifdef GAITWAY_ICEORYX
  rivals.push_back(iceoryx_topic(bytes));
#endif
  return rivals;
}

Json contest(std::size_t bytes) {
  const std::size_t pairs = std::min(kMostPairs, kBytesOfTurn / bytes);
  const std::vector<std::unique_ptr<TopicRival>> rivals = rivals_for(bytes);
  std::vector<std::function<void()>> turns;
  for (const std::unique_ptr<TopicRival>& rival : rivals) {
    turns.emplace_back([pairs, rival = rival.get()] {
      if (const std::size_t whole = rival->write_and_read(pairs); whole != pairs) {
        throw std::runtime_error(
            fmt::format("{}: {} of {} values were read as written", rival->name(), whole, pairs));
      }
    });
  }
  const std::vector<double> taken_ns = median_turn_ns(kTurns, turns);
  Json result;
  for (std::size_t i = 0; i < rivals.size(); ++i) {
    result[rivals[i]->name()] = {{"ns", taken_ns[i] / static_cast<double>(pairs)}};
  }
  return result;
}

void run() {
  Json result;
  for (const std::size_t bytes : {std::size_t{64}, std::size_t{1024}, sizeof(JointPlan) / 8 * 8}) {
    result[fmt::format("{} B", bytes)] = contest(bytes);
  }
  fmt::print("{}\n", result.dump(1));
}

}  // namespace
}  // namespace gaitway::peers

int main() {
  try {
    gaitway::peers::run();
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    fmt::print(stderr, "topic_peers: {}\n", error.what());
    return EXIT_FAILURE;
  }
}
