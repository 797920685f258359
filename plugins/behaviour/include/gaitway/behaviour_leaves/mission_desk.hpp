// Where missions are read: in the step that asks for one, or beside the steps in a thread of its own.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "gaitway/behaviour/registry.hpp"
#include "gaitway/behaviour/tree.hpp"
#include "gaitway/behaviour_leaves/mission.hpp"

namespace gaitway::behaviour_leaves {

// The trees of one mission, ready to be ticked.
struct LoadedMission {
  LoadedMission(Mission mission, std::string mission_name, const behaviour::Registry& registry);

  std::string name;  // as asked for
  behaviour::Tree tree;
  std::optional<behaviour::Tree> stand_up;
};

// What comes of one job.
struct ReadMission {
  std::string refused;                              // why there is none; empty: it is there
  std::unique_ptr<LoadedMission> mission;           // of a start; of a change, its `stand_up` alone is of use
  std::optional<behaviour::PreparedChange> change;  // of a change: of the tree that runs
};

// One job at a time.
class MissionDesk {
 public:
  enum class Where : std::uint8_t { in_step, beside };
  // The registry must outlive this.
  MissionDesk(const behaviour::Registry& registry, Where where);
  ~MissionDesk();
  MissionDesk(const MissionDesk&) = delete;
  MissionDesk& operator=(const MissionDesk&) = delete;

  // `changes`: the tree that is to become this mission while it runs, nullptr for a start. It must stay where
  // it is until the job is done.
  void submit(const std::string& name, const behaviour::Tree* changes);
  [[nodiscard]] bool waits() const noexcept { return waits_; }
  // Of the last job, once.
  [[nodiscard]] std::optional<ReadMission> take();
  // To be destroyed where it delays nobody.
  void put_away(ReadMission used);

 private:
  struct Job {
    std::string name;
    const behaviour::Tree* changes = nullptr;
  };
  [[nodiscard]] ReadMission read(const Job& job) const;
  void work(const std::stop_token& stop);

  const behaviour::Registry& registry_;
  Where where_;
  bool waits_ = false;

  std::mutex mutex_;  // of what follows; held for moments
  std::condition_variable_any wake_;
  std::optional<Job> job_;
  std::optional<ReadMission> done_;
  std::vector<ReadMission> used_;
  std::jthread thread_;  // the last one: it uses all of these
};

}  // namespace gaitway::behaviour_leaves
