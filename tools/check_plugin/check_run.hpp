// What a check's process works with: the job, the recorded walk, and where findings go.
#pragma once

#include <chrono>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "tools/check_plugin/board.hpp"
#include "tools/check_plugin/nominal_record.hpp"
#include "tools/check_plugin/specimen.hpp"
#include "tools/check_plugin/worker_process.hpp"

namespace gaitway::plugin_check {

class CheckRun {
 public:
  CheckRun(const Job& job, const NominalRecord& record, Board& board)
      : job_(job), record_(record), board_(board) {}

  // A check consists of cases, tried one after the other. False: this one was tried by a process that died,
  // or there is no time for it any more, which the report says.
  bool begin(std::string_view name);
  [[nodiscard]] const std::string& case_name() const noexcept { return case_name_; }

  // The quick form's time is up: a loop over many steps may end early.
  [[nodiscard]] bool time_is_up() const noexcept {
    return !job_.full && std::chrono::steady_clock::now() - start_ > kLongestQuick;
  }

  void finding(std::string_view what, std::string_view where, std::string_view remedy);
  void figure(std::string_view name, const nlohmann::ordered_json& value);
  void remark(std::string_view text);
  void skip(std::string_view why);
  // Nothing else can be tried; the reason is a finding of the check `life_cycle`.
  void not_usable(std::string_view why);

  [[nodiscard]] const Job& job() const noexcept { return job_; }
  [[nodiscard]] const NominalRecord& record() const noexcept { return record_; }
  [[nodiscard]] Board& board() const noexcept { return board_; }
  [[nodiscard]] int findings() const noexcept { return findings_; }

 private:
  static constexpr std::chrono::seconds kLongestQuick{4};
  const Job& job_;
  const NominalRecord& record_;
  Board& board_;
  std::uint32_t next_case_ = 0;
  std::string case_name_;
  int findings_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// What this process holds at the moment: memory, descriptors, threads.
struct ProcessResources {
  // Allocated and not freed since the count began; 0 in a build with a sanitizer.
  std::int64_t heap_bytes = 0;
  std::int64_t resident_bytes = 0;
  int descriptors = 0;
  int threads = 0;
};
ProcessResources process_resources();

// The parameters of a job with one of them set anew.
Job with_parameter(const Job& job, const std::string& name, const std::string& text);

void check_abi(CheckRun& run);
void check_descriptor(CheckRun& run);
void check_life_cycle(CheckRun& run);
void check_unload(CheckRun& run);
void check_outputs(CheckRun& run);  // of determinism and two_instances: the starter compares
void check_real_time(CheckRun& run);
void check_budget(CheckRun& run);
void check_values(CheckRun& run);
void check_parameters(CheckRun& run);
void check_state(CheckRun& run);

}  // namespace gaitway::plugin_check
