// Runs `gaitway check-plugin` and reads what it wrote.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace gaitway::tests {

struct CheckOutcome {
  int exit_code = -1;
  std::string text;
  nlohmann::json report;

  [[nodiscard]] std::set<std::string> failed_checks() const {
    std::set<std::string> failed;
    for (const nlohmann::json& check : report.value("checks", nlohmann::json::array())) {
      if (check.at("outcome") == "finding") {
        failed.insert(check.at("check"));
      }
    }
    return failed;
  }
};

inline CheckOutcome check_plugin(const std::filesystem::path& plugin, const std::string& options = "") {
  const std::filesystem::path json =
      std::filesystem::path(testing::TempDir()) /
      ("plugin_check_" + plugin.stem().string() + "_" + std::to_string(getpid()) + ".json");
  const std::string command = std::string(GAITWAY_COMMAND) + " check-plugin '" + plugin.string() +
                              "' --json '" + json.string() + "' " + options + " 2>&1";
  CheckOutcome outcome;
  FILE* const pipe = popen(command.c_str(), "r");  // NOLINT(cert-env33-c): the command under test
  std::array<char, 4096> chunk{};
  while (pipe != nullptr && std::fgets(chunk.data(), chunk.size(), pipe) != nullptr) {
    outcome.text += chunk.data();
  }
  const int status = pipe == nullptr ? -1 : pclose(pipe);
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (std::ifstream file(json); file.is_open()) {
    outcome.report = nlohmann::json::parse(file, nullptr, false);
  }
  std::filesystem::remove(json);
  return outcome;
}

}  // namespace gaitway::tests
