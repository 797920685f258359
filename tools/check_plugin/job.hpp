// What one process of a check is asked to do.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "gaitway/manager/configuration.hpp"

namespace gaitway::plugin_check {

struct Job {
  std::string check;
  std::string variant;  // of a check that runs more than once
  std::filesystem::path plugin;
  std::filesystem::path robot;
  std::filesystem::path configuration;  // the file of `parameters`
  std::vector<core::ParameterEntry> parameters;
  std::uint64_t seed = 1;
  bool full = false;
  double budget_ms = 0.0;
  std::uint32_t first_case = 0;  // those before were done by a process that died
};

std::string to_text(const Job& job);
Job read_job(const std::string& text);

// Numbers of the two descriptors that the process is born with.
inline constexpr int kBoardDescriptor = 100;
inline constexpr int kRecordDescriptor = 101;

}  // namespace gaitway::plugin_check
