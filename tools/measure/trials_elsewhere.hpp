// Trials that another program has played, wherever its workers are: `gaitway measure gait --on PLACE`.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/process/file_descriptor.hpp"
#include "tools/measure/trial_place.hpp"

namespace gaitway::tools {

// Exit code: trials are missing, since there were no workers, or the other program ended.
inline constexpr int kExitNotMeasured = 6;

// The other program could not have all trials played.
class ElsewhereError : public std::runtime_error {
 public:
  ElsewhereError(const std::string& what, int exit_code) : std::runtime_error(what), exit_code_(exit_code) {}
  [[nodiscard]] int exit_code() const noexcept {
    return exit_code_;
  }  // what it asks this program to end with

 private:
  int exit_code_;
};

// Lines of JSON go to the other program's standard input, and come from its standard output.
//
//   to it:   {"robot":…,"config":…,"quick":…,"fingerprint":…}  first: whose gait, and what outcomes depend on
//            {"id":7,"rank":0,"row":…,"level":…,"seed":…,"first":…,"count":…,"seconds":…}
//                               wanted: trials of a seed at a level. Those of lower rank first: a failure in
//                               them makes the others vain
//            {"withdrawn":[7]}  wanted no longer
//            {"heard":3}        all that came of the first three results has been asked for
//            {"closed":true}    nothing more will be
//   from it: {"id":7,"ran":true,"outcomes":[…]}  a result: up to the trial that decides; in any order
//            {"workers":2}, {"news":"…"}
//            {"error":"…","exit_code":3}         it has given up
class TrialsElsewhere final : public TrialPlace {
 public:
  // What is measured, as workers find it.
  struct Subject {
    std::string robot, config;  // absolute paths
    bool quick = false;         // which table
    std::uint64_t fingerprint = 0;
  };

  // `command`: the program, looked for in the path where its name has no slash, and its arguments. `tell`:
  // news for people. Throws std::system_error when it cannot be started.
  TrialsElsewhere(const std::vector<std::string>& command, const Subject& subject,
                  std::function<void(const std::string&)> tell);
  ~TrialsElsewhere() override;

  [[nodiscard]] bool has_room() const override { return true; }
  Ticket start(const SeedTrials& seed, std::vector<std::size_t> wanted) override;
  void give_up(Ticket ticket) override;
  // Throws ElsewhereError when the other program gives up, ends, or says what it should not.
  std::vector<News> wait() override;
  [[nodiscard]] int workers() const override { return workers_; }

  // Nothing more is wanted: waits until the other program has ended. Throws as wait().
  void finish();

 private:
  struct Series {
    TrialSeries trials;
    std::uint64_t id = 0;
    bool done = false;
  };
  struct SeedRun {
    const SeedTrials* seed = nullptr;
    std::vector<std::size_t> wanted;
    std::vector<Series> series;  // those behind a failure are taken out
  };

  void send(const nlohmann::ordered_json& message) const;
  [[nodiscard]] std::vector<std::string> lines();  // at least one; none: it has ended
  void take(std::string_view line, std::vector<News>& all);
  void obey(const nlohmann::ordered_json& message, std::vector<News>& all);
  void take_result(const nlohmann::ordered_json& result, std::vector<News>& all);
  void withdraw_behind(SeedRun& run, std::size_t trial);
  void check_end();

  process::FileDescriptor socket_;
  pid_t process_ = -1;
  std::function<void(const std::string&)> tell_;
  std::string name_;   // of the program
  std::string heard_;  // of a line that has not yet come to its end
  std::map<Ticket, SeedRun> seeds_;
  std::map<std::uint64_t, Ticket> by_id_;  // of series that are wanted
  Ticket last_ticket_ = 0;
  std::uint64_t last_id_ = 0, results_ = 0;
  std::optional<std::uint64_t> heard_results_;  // told last
  int workers_ = 0;
};

}  // namespace gaitway::tools
