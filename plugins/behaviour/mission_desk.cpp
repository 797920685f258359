// A thread that reads missions.
#include "gaitway/behaviour_leaves/mission_desk.hpp"

#include <exception>
#include <utility>

namespace gaitway::behaviour_leaves {

LoadedMission::LoadedMission(Mission mission, std::string mission_name, const behaviour::Registry& registry)
    : name(std::move(mission_name)), tree(std::move(mission.tree), registry) {
  if (mission.stand_up) stand_up.emplace(*std::move(mission.stand_up), registry);
}

MissionDesk::MissionDesk(const behaviour::Registry& registry, Where where)
    : registry_(registry), where_(where) {
  if (where == Where::beside) {
    thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
  }
}

MissionDesk::~MissionDesk() = default;

ReadMission MissionDesk::read(const Job& job) const {
  ReadMission result;
  try {
    Mission mission = read_mission(job.name, registry_);
    if (job.changes != nullptr) result.change = job.changes->prepare(mission.tree, registry_);
    result.mission = std::make_unique<LoadedMission>(std::move(mission), job.name, registry_);
  } catch (const std::exception& error) {
    result.refused = error.what();
    result.change.reset();
  }
  return result;
}

void MissionDesk::submit(const std::string& name, const behaviour::Tree* changes) {
  waits_ = true;
  if (where_ == Where::in_step) {
    done_ = read({name, changes});
    return;
  }
  {
    const std::scoped_lock lock(mutex_);
    job_ = Job{name, changes};
    done_.reset();
  }
  wake_.notify_one();
}

std::optional<ReadMission> MissionDesk::take() {
  if (!waits_) return std::nullopt;
  const std::scoped_lock lock(mutex_);
  if (!done_) return std::nullopt;
  waits_ = false;
  return std::exchange(done_, std::nullopt);
}

void MissionDesk::put_away(ReadMission used) {
  if (where_ == Where::in_step) return;
  {
    const std::scoped_lock lock(mutex_);
    used_.push_back(std::move(used));
  }
  wake_.notify_one();
}

void MissionDesk::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (wake_.wait(lock, stop, [this] { return job_.has_value() || !used_.empty(); })) {
    std::vector<ReadMission> used = std::exchange(used_, {});
    const std::optional<Job> job = std::exchange(job_, std::nullopt);
    lock.unlock();
    used.clear();
    std::optional<ReadMission> done;
    if (job) done = read(*job);
    lock.lock();
    if (done) done_ = std::move(done);
  }
}

}  // namespace gaitway::behaviour_leaves
