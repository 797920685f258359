// Reads a line, plays, answers.
#include "tools/measure/series_player.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/process/working_copy.hpp"
#include "tools/measure/seed_trials.hpp"
#include "tools/measure/trial_run.hpp"

namespace gaitway::tools {
namespace {

using Json = nlohmann::ordered_json;

// Standard output for answers alone: what plug-ins print goes where errors go.
process::FileDescriptor take_standard_output() {
  process::FileDescriptor answers(fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1));
  if (!answers || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) {
    throw std::system_error(errno, std::generic_category(), "standard output");
  }
  return answers;
}

// Returns whether somebody is there to read it.
bool answer(int answers, const Json& message) {
  const std::string line = message.dump() + '\n';
  for (std::string_view rest = line; !rest.empty();) {
    const ssize_t written = write(answers, rest.data(), rest.size());
    if (written < 0 && errno != EINTR) {
      return false;
    }
    rest.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
  }
  return true;
}

SeedTrials seed_of(const Json& series, const std::vector<GaitRow>& rows) {
  const auto name = series.at("row").get<std::string>();
  const auto row = std::ranges::find(rows, name, &GaitRow::name);
  if (row == rows.end()) {
    throw std::invalid_argument(fmt::format("the table has no row '{}'", name));
  }
  return {*row, series.at("level").get<double>(), series.at("seed").get<std::uint64_t>()};
}

std::span<const Trial> trials_of(const Json& series, const SeedTrials& seed) {
  const auto first = series.at("first").get<std::size_t>(), count = series.at("count").get<std::size_t>();
  if (first >= seed.trials.size() || count == 0 || count > seed.trials.size() - first) {
    throw std::invalid_argument(fmt::format("trials {} to {}: a seed of '{}' has {}", first, first + count,
                                            seed.row->name, seed.trials.size()));
  }
  return std::span(seed.trials).subspan(first, count);
}

// None: nobody waits for them any more.
std::optional<Json> outcomes_of(const TrialRobot& robot, const SeedTrials& seed,
                                std::span<const Trial> trials) {
  process::WorkingCopy copy([&](const process::WorkingCopy::Tell& tell) {
    run_trials(robot, trials, [&](std::size_t trial, const TrialOutcome& outcome) {
      tell(to_json(outcome).dump());
      return !seed.end_with(trials[trial], outcome);
    });
  });
  Json outcomes = Json::array();
  while (!copy.done()) {
    std::array<pollfd, 2> ends{pollfd{copy.descriptor(), POLLIN, 0}, pollfd{STDIN_FILENO, 0, 0}};
    if (poll(ends.data(), ends.size(), -1) < 0 && errno != EINTR) {
      throw std::system_error(errno, std::generic_category(), "cannot wait for trials");
    }
    if (ends[1].revents != 0) {
      return std::nullopt;
    }
    if (ends[0].revents != 0) {
      for (const std::string& line : copy.listen()) {
        outcomes.push_back(Json::parse(line));
      }
    }
  }
  return outcomes;
}

}  // namespace

void play_series(const TrialRobot& robot, const std::vector<GaitRow>& rows, std::uint64_t fingerprint) {
  const process::FileDescriptor answers = take_standard_output();
  bool wanted = answer(answers.get(), {{"fingerprint", fmt::format("{:016x}", fingerprint)}});
  for (std::string line; wanted && std::getline(std::cin, line);) {
    Json message;
    try {
      const Json series = Json::parse(line);
      const SeedTrials seed = seed_of(series, rows);
      std::optional<Json> outcomes = outcomes_of(robot, seed, trials_of(series, seed));
      if (!outcomes) {
        return;
      }
      message["outcomes"] = std::move(*outcomes);
    } catch (const std::exception& error) {
      message = {{"error", error.what()}};
    }
    wanted = answer(answers.get(), message);
  }
}

}  // namespace gaitway::tools
