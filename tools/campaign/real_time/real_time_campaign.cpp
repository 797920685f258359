// Trials that need the same robot follow each other.
#include "tools/campaign/real_time/real_time_campaign.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "gaitway/process/installation.hpp"
#include "gaitway/process/real_time.hpp"
#include "tools/campaign/real_time/trial_player.hpp"

namespace gaitway::tools {
namespace {

struct Planned {
  std::size_t row = 0;
  RealTimeTrial trial;
};

class RealTimePool {
 public:
  RealTimePool(const std::vector<RealTimeRow>& rows, OutcomeStore& store, const RealTimeOptions& options)
      : rows_(rows), store_(store), options_(options) {}

  // False: a signal came.
  bool play(std::vector<Planned> unknown) {
    std::ranges::stable_sort(unknown, {}, [this](const Planned& one) {
      return std::pair(rows_[one.row].equipment, one.trial.number);
    });
    planned_ = unknown.size();
    begun_ns_ = process::monotonic_ns();
    for (const Planned& one : unknown) {
      if (!play_one(one)) return false;
      ++done_;
    }
    return true;
  }
  [[nodiscard]] std::uint64_t played() const noexcept { return done_; }

 private:
  bool play_one(const Planned& planned);
  TrialGround& ground_for(const RealTimeRow& row);
  void note_progress(const RealTimeRow& row) const;

  const std::vector<RealTimeRow>& rows_;
  OutcomeStore& store_;
  const RealTimeOptions& options_;
  std::unique_ptr<TrialGround> ground_;
  Equipment equipment_ = Equipment::none;  // of ground_
  std::uint64_t seed_ = 0, planned_ = 0, done_ = 0;
  std::int64_t begun_ns_ = 0;
};

TrialGround& RealTimePool::ground_for(const RealTimeRow& row) {
  if (!ground_ || equipment_ != row.equipment) {
    ground_.reset();  // first, so that there is one at a time
    equipment_ = row.equipment;
    ground_ = std::make_unique<TrialGround>(
        WalkingRobot::Options{.robot = options_.robot, .seed = ++seed_, .equipment = row.equipment},
        options_.speed_m_per_s);
  }
  return *ground_;
}

bool RealTimePool::play_one(const Planned& planned) {
  const RealTimeRow& row = rows_[planned.row];
  note_progress(row);
  constexpr int kRobots = 3;  // one that does not come to the fault is exchanged: it says nothing of the row
  for (int robot = 1;; ++robot) {
    try {
      const auto outcome = TrialPlayer(ground_for(row), row, planned.trial).play();
      if (!outcome) {
        ground_.reset();
        return false;
      }
      store_.keep(describe(planned.trial).dump(), to_json(*outcome));
      if (!outcome->is_well()) ground_.reset();
      return true;
    } catch (const std::runtime_error&) {
      ground_.reset();
      if (robot == kRobots) throw;
    }
  }
}

void RealTimePool::note_progress(const RealTimeRow& row) const {
  if (!options_.progress) return;
  const double wall_s = static_cast<double>(process::monotonic_ns() - begun_ns_) * 1e-9;
  options_.progress(done_, planned_, row.name,
                    done_ == 0 ? std::nullopt
                               : std::optional(wall_s * static_cast<double>(planned_ - done_) /
                                               static_cast<double>(done_)));
}

}  // namespace

std::uint64_t real_time_fingerprint(const std::filesystem::path& robot) {
  ContentHash hash;
  std::vector<std::filesystem::path> files;
  for (const char* const name : {"gaitway-robot", "gaitway-ctl", "virtual_robot", "message_controller",
                                 "main_controller", "user_interface", "gaitway_plugin_child"}) {
    files.push_back(campaign_program(name));
  }
  const std::vector<std::filesystem::path> folders{process::shipped_plugin_directory(),
                                                   campaign_library("saboteur.so").parent_path(), robot};
  for (const std::filesystem::path& folder : folders) {
    std::vector<std::filesystem::path> found;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.is_regular_file()) found.push_back(entry.path());
    }
    std::ranges::sort(found);
    files.insert(files.end(), found.begin(), found.end());
  }
  for (const std::filesystem::path& file : files) hash.add_file(file);
  return hash.value();
}

RealTimeCampaign run_real_time_campaign(const std::vector<RealTimeRow>& rows, OutcomeStore& store,
                                        const RealTimeOptions& options) {
  std::vector<Planned> all, unknown;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    for (std::uint64_t number = 0; number < options.trials; ++number) {
      all.push_back({row, draw_real_time_trial(rows[row].name, number, options.speed_m_per_s)});
      if (store.find(describe(all.back().trial).dump()) == nullptr) unknown.push_back(all.back());
    }
  }
  RealTimeCampaign campaign;
  campaign.known = all.size() - unknown.size();
  RealTimePool pool(rows, store, options);
  campaign.is_whole = pool.play(std::move(unknown));
  campaign.run = pool.played();
  for (const RealTimeRow& row : rows) campaign.rows.push_back({row, {}});
  for (const Planned& one : all) {
    if (const auto* const outcome = store.find(describe(one.trial).dump())) {
      campaign.rows[one.row].outcomes.push_back(real_time_outcome_from_json(*outcome));
    }
  }
  return campaign;
}

}  // namespace gaitway::tools
