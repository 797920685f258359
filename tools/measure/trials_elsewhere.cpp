// Starts the other program, asks it for series of trials, and takes what comes.
#include "tools/measure/trials_elsewhere.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>
#include <utility>

namespace gaitway::tools {
namespace {

using Json = nlohmann::ordered_json;

[[noreturn]] void fail_with(int error, const std::string& what) {
  throw std::system_error(error, std::generic_category(), what);
}

// Its standard input and output are the socket's other end.
pid_t spawn_with(int socket, const std::vector<std::string>& command) {
  std::vector<char*> words;
  for (const std::string& word : command) {
    words.push_back(const_cast<char*>(word.c_str()));  // NOLINT: it is not written to
  }
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, socket, STDOUT_FILENO);
  pid_t process = -1;
  const int error = posix_spawnp(&process, words.front(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    fail_with(error, command.front());
  }
  return process;
}

}  // namespace

TrialsElsewhere::TrialsElsewhere(const std::vector<std::string>& command, const Subject& subject,
                                 std::function<void(const std::string&)> tell)
    : tell_(std::move(tell)), name_(command.at(0)) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
    fail_with(errno, "no socket for " + name_);
  }
  socket_ = process::FileDescriptor(ends[0]);
  const process::FileDescriptor theirs(ends[1]);
  process_ = spawn_with(theirs.get(), command);
  send({{"robot", subject.robot},
        {"config", subject.config},
        {"quick", subject.quick},
        {"fingerprint", fmt::format("{:016x}", subject.fingerprint)}});
}

TrialsElsewhere::~TrialsElsewhere() {
  socket_ = {};  // it ends when it sees that nobody is there
  if (process_ > 0) {
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
  }
}

TrialPlace::Ticket TrialsElsewhere::start(const SeedTrials& seed, std::vector<std::size_t> wanted) {
  SeedRun run{&seed, std::move(wanted), {}};
  const Ticket ticket = ++last_ticket_;
  for (const TrialSeries& series : series_of(seed.trials)) {
    const auto next = std::ranges::lower_bound(run.wanted, series.first);
    if (next == run.wanted.end() || *next >= series.first + series.count) {
      continue;  // all of it is known
    }
    send({{"id", ++last_id_},
          {"rank", run.series.size()},
          {"row", seed.row->name},
          {"level", seed.level},
          {"seed", seed.seed},
          {"first", series.first},
          {"count", series.count},
          {"seconds", seconds_of(std::span(seed.trials).subspan(series.first, series.count))}});
    by_id_[last_id_] = ticket;
    run.series.push_back({series, last_id_});
  }
  seeds_.emplace(ticket, std::move(run));
  return ticket;
}

void TrialsElsewhere::give_up(Ticket ticket) {
  if (const auto run = seeds_.find(ticket); run != seeds_.end()) {
    withdraw_behind(run->second, 0);
    seeds_.erase(run);
  }
}

// All series but those that are done, and the one that the trial is in.
void TrialsElsewhere::withdraw_behind(SeedRun& run, std::size_t trial) {
  Json ids = Json::array();
  std::erase_if(run.series, [&](const Series& series) {
    const bool vain = !series.done && series.trials.first >= trial;
    if (vain) {
      ids.push_back(series.id);
      by_id_.erase(series.id);
    }
    return vain;
  });
  if (!ids.empty()) {
    send({{"withdrawn", std::move(ids)}});
  }
}

std::vector<TrialPlace::News> TrialsElsewhere::wait() {
  if (heard_results_ != results_) {
    heard_results_ = results_;
    send({{"heard", results_}});
  }
  std::vector<News> all;
  const std::vector<std::string> told = lines();
  if (told.empty()) {
    check_end();
    throw ElsewhereError(name_ + " has ended before all trials were played", kExitNotMeasured);
  }
  for (const std::string& line : told) {
    take(line, all);
  }
  return all;
}

void TrialsElsewhere::take(std::string_view line, std::vector<News>& all) {
  try {
    obey(Json::parse(line), all);
  } catch (const nlohmann::json::exception& error) {
    throw ElsewhereError(fmt::format("{} says '{}': {}", name_, line, error.what()), kExitNotMeasured);
  }
}

void TrialsElsewhere::obey(const Json& message, std::vector<News>& all) {
  if (message.contains("id")) {
    take_result(message, all);
  } else if (message.contains("workers")) {
    workers_ = message.at("workers").get<int>();
  } else if (message.contains("news")) {
    tell_(message.at("news").get<std::string>());
  } else {
    throw ElsewhereError(message.at("error").get<std::string>(), message.at("exit_code").get<int>());
  }
}

void TrialsElsewhere::take_result(const Json& result, std::vector<News>& all) {
  ++results_;
  const auto by_id = by_id_.find(result.at("id").get<std::uint64_t>());
  if (by_id == by_id_.end()) {
    return;  // it was withdrawn meanwhile
  }
  const Ticket ticket = by_id->second;
  SeedRun& run = seeds_.at(ticket);
  const auto series = std::ranges::find(run.series, by_id->first, &Series::id);
  by_id_.erase(by_id);
  series->done = true;
  News news{.ticket = ticket, .played = {}, .ran = result.at("ran").get<bool>()};
  std::size_t trial = series->trials.first;
  const std::size_t end = trial + series->trials.count;
  bool decided = false;
  for (const Json& one : result.at("outcomes")) {
    if (trial == end) {
      break;
    }
    TrialOutcome outcome = outcome_from_json(one);
    const bool last = run.seed->end_with(run.seed->trials.at(trial), outcome);
    if (std::ranges::binary_search(run.wanted, trial)) {
      news.played.push_back({trial, std::move(outcome)});
    }
    ++trial;
    if (last) {
      decided = true;
      withdraw_behind(run, trial);
      break;
    }
  }
  if (!decided && trial != end) {
    throw ElsewhereError(fmt::format("{} gave {} outcomes of {} trials", name_, result.at("outcomes").size(),
                                     series->trials.count),
                         kExitNotMeasured);
  }
  news.done = std::ranges::all_of(run.series, &Series::done);
  if (news.done) {
    seeds_.erase(ticket);
  }
  all.push_back(std::move(news));
}

void TrialsElsewhere::finish() {
  send({{"closed", true}});
  std::vector<News> late;
  for (std::vector<std::string> told; !(told = lines()).empty();) {
    std::ranges::for_each(told, [&](const std::string& line) { take(line, late); });
  }
  check_end();
}

void TrialsElsewhere::send(const Json& message) const {
  const std::string line = message.dump() + '\n';
  for (std::string_view rest = line; !rest.empty();) {
    const ssize_t sent = ::send(socket_.get(), rest.data(), rest.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno != EINTR) {
      return;  // it has ended: wait() tells why
    }
    rest.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(sent, 0)));
  }
}

std::vector<std::string> TrialsElsewhere::lines() {
  std::vector<std::string> whole;
  while (whole.empty()) {
    std::array<char, 65536> buffer{};
    const ssize_t got = read(socket_.get(), buffer.data(), buffer.size());
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got <= 0) {
      break;
    }
    heard_.append(buffer.data(), static_cast<std::size_t>(got));
    std::size_t start = 0;
    for (std::size_t end = 0; (end = heard_.find('\n', start)) != std::string::npos; start = end + 1) {
      whole.push_back(heard_.substr(start, end - start));
    }
    heard_.erase(0, start);
  }
  return whole;
}

// What it had to say it has said, or its own words are on the terminal.
void TrialsElsewhere::check_end() {
  int status = 0;
  while (waitpid(process_, &status, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
  if (WIFSIGNALED(status)) {
    throw ElsewhereError(fmt::format("{} was ended: {}", name_, strsignal(WTERMSIG(status))),
                         kExitNotMeasured);
  }
  if (WEXITSTATUS(status) != 0) {
    throw ElsewhereError(fmt::format("{} ended with code {}", name_, WEXITSTATUS(status)), kExitNotMeasured);
  }
}

}  // namespace gaitway::tools
