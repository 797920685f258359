// What planning costs on random worlds of 6 m x 6 m in cells of 10 mm: map, distances, guide, search, whole
// plans, and plans made anew after a step. Processor time of one thread. `planning_bench [WORLDS]`.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <map>
#include <string>
#include <vector>

#include "body_field.hpp"
#include "distance_field.hpp"
#include "step_lattice.hpp"
#include "terrain.hpp"
#include "written_scene.hpp"

namespace gaitway::planning {
namespace {

double now_ms() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

class Figures {
 public:
  void add(double value) { values_.push_back(value); }
  void print(const char* what, const char* unit) {
    if (values_.empty()) return;
    std::ranges::sort(values_);
    const auto at = [this](double share) {
      return values_[std::min(values_.size() - 1,
                              static_cast<std::size_t>(share * static_cast<double>(values_.size())))];
    };
    fmt::print("{:<34} {:>6} {:>9.2f} {:>9.2f} {:>9.2f}  {}\n", what, values_.size(), at(0.5), at(0.99),
               values_.back(), unit);
  }

 private:
  std::vector<double> values_;
};

void measure(int worlds) {
  const Planner& one = planner();
  Figures map, terrain, distances, guide, first, whole, again, no_way, bound, expansions;
  std::map<std::string, int> reasons;
  for (int seed = 0; seed < worlds; ++seed) {
    const Scene scene = random_scene(static_cast<std::uint64_t>(seed));
    const double begun = now_ms();
    const GroundMap ground = scene.map();
    const double mapped = now_ms();
    const Terrain around(ground, one.limits(), {scene.start.x_m, scene.start.y_m}, one.lattice().reach_m());
    const double spread = now_ms();
    const DistanceField field(around, one.limits(), scene.goal, one.lattice().pitch());
    const double measured = now_ms();
    const BodyField body(around, one.limits(), one.moves(), scene.goal, scene.start);
    const double guided = now_ms();
    Request request = scene.request();
    const Plan plan = one.plan(ground, request);
    const double planned = now_ms();
    map.add(mapped - begun);
    terrain.add(spread - mapped);
    ++reasons[name(plan.reason)];
    if (!plan.found()) {
      no_way.add(planned - guided);
      continue;
    }
    distances.add(measured - spread);
    guide.add(guided - measured);
    whole.add(planned - guided);
    bound.add(plan.bound);
    expansions.add(plan.expansions);
    request.budget.improvements = 0;
    const double before = now_ms();
    (void)one.plan(ground, request);
    first.add(now_ms() - before);
    if (plan.steps.empty()) continue;
    request.budget = {};
    const Footstep& step = plan.steps.front();
    (step.side == Side::left ? request.left : request.right) = step.pose;
    request.previous = plan.steps;
    const double stepped = now_ms();
    (void)one.plan(ground, request);
    again.add(now_ms() - stepped);
  }
  fmt::print("{:<34} {:>6} {:>9} {:>9} {:>9}\n", "", "worlds", "p50", "p99", "worst");
  map.print("map of the world", "ms");
  terrain.print("terrain", "ms");
  distances.print("distances to the goal", "ms");
  guide.print("guide", "ms");
  first.print("plan, the first that is found", "ms");
  whole.print("plan", "ms");
  again.print("plan anew after a step", "ms");
  no_way.print("no way is told", "ms");
  expansions.print("expansions", "");
  bound.print("bound that is proven", "");
  for (const auto& [reason, count] : reasons) fmt::print("  {:<32} {:>6}\n", reason, count);
}

}  // namespace
}  // namespace gaitway::planning

int main(int argc, char** argv) {
  constexpr int kWorlds = 1000;
  gaitway::planning::measure(argc > 1 ? std::atoi(argv[1]) : kWorlds);
}
