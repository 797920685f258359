// A program, and what comes through its pipe.
#include "tools/twin/flight_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "gaitway/facts/facts.hpp"
#include "gaitway/process/bound_program.hpp"
#include "gaitway/process/installation.hpp"

namespace gaitway::tools {
namespace {

constexpr int kLowPriority = 5;        // nice
constexpr double kAfterwards_s = 1.0;  // a flight begins with so long a stand
constexpr std::size_t kLongestLine = 4000;
constexpr const char* kSends = "  sending     ";
constexpr const char* kVerdict = "verdict.json";

// "0.1,0,0.2".
std::string list_of(const std::vector<double>& numbers) {
  return fmt::format("{:g},{:g},{:g}", numbers.at(0), numbers.at(1), numbers.at(2));
}

// "17 of 20 simulated robots stayed up and did it; robot 4 fell after 3.20 s".
std::string verdict_of(const nlohmann::json& verdict) {
  std::string text = fmt::format("{} of {} simulated robots stayed up and did it",
                                 verdict.value("passed", 0U), verdict.value("robots", 0U));
  const auto worst = verdict.value("worst_seed", 0U);
  for (const auto& trial : verdict.value("trials", nlohmann::json::array())) {
    const std::string refusal = trial.value("refusal", "");
    if (trial.value("seed", 0U) != worst) continue;
    if (trial.value("fell", false)) {
      text += fmt::format("; robot {} fell after {:.2f} s", worst, trial.value("ended_s", 0.0));
    } else if (!refusal.empty()) {
      text += fmt::format("; robot {}: {}", worst, refusal);
    }
  }
  return text;
}

std::vector<double> in_degrees(std::vector<double> goal) {
  goal.at(2) /= facts::kRadPerDegree;
  return goal;
}

}  // namespace

std::string FlightTask::text() const {
  std::string text;
  for (const std::string& one : settings) text += (text.empty() ? "" : ", ") + one;
  const auto add = [&text](const std::string& task) { text += (text.empty() ? "" : ", then ") + task; };
  if (!walk.empty()) {
    const bool is_straight = walk[1] == 0.0 && walk[2] == 0.0;
    const std::string aside = fmt::format(" ahead, {:.2f} to the left, {:.2f} rad/s", walk[1], walk[2]);
    add(fmt::format("walk {:.2f} m/s{}, {:g} s", walk[0], is_straight ? "" : aside, walk_s));
  }
  if (!motion.empty()) add("motion " + motion);
  if (!goal.empty()) {
    add(fmt::format("way to {:.2f} m, {:.2f} m, {:.0f} deg", goal[0], goal[1],
                    goal[2] / facts::kRadPerDegree));
  }
  return text;
}

FlightProcess::~FlightProcess() {
  if (!is_under_way()) return;
  kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
}

void FlightProcess::start(const FlightTask& task) {
  if (is_under_way()) throw std::invalid_argument(what_ + " is under way: wait for its end, or stop it");
  std::vector<std::string> words{(process::installation_root() / "bin" / "gaitway-preflight").string(),
                                 "preflight"};
  words.insert(words.end(), arguments_.begin(), arguments_.end());
  const auto add = [&words](const std::string& option, const std::string& value) {
    words.push_back(option + "=" + value);
  };
  words.push_back("--send");
  add("--out", out_.string());
  if (!task.walk.empty()) {
    add("--walk", list_of(task.walk));
    add("--seconds", fmt::format("{:g}", task.walk_s + kAfterwards_s));
  }
  if (!task.motion.empty()) add("--motion", task.motion);
  if (!task.goal.empty()) add("--to", list_of(in_degrees(task.goal)));
  for (const std::string& setting : task.settings) add("--set", setting);
  if (!task.reason.empty()) add("--override", task.reason);
  std::error_code none_yet;
  std::filesystem::remove(out_ / kVerdict, none_yet);  // what is there afterwards is of this flight
  std::filesystem::remove(picture(), none_yet);
  spawn(words);
  what_ = task.text();
  state_ = State::trying;
  text_.clear();
  last_line_.clear();
  heard_.clear();
  passed_ = tried_ = 0;
  is_stopped_ = false;
}

void FlightProcess::spawn(const std::vector<std::string>& words) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw std::runtime_error(
        fmt::format("the pre-flight cannot be started: no pipe: {}", std::strerror(errno)));
  }
  says_ = process::FileDescriptor(ends[0]);
  const process::FileDescriptor writes(ends[1]);
  fcntl(says_.get(), F_SETFL, O_NONBLOCK);
  // The twin goes on beside it.
  const pid_t child =
      process::start({.words = words, .kept = -1, .output = writes.get(), .niceness = kLowPriority});
  if (child < 0) {
    throw std::runtime_error(fmt::format("the pre-flight cannot be started: {}", std::strerror(errno)));
  }
  process_ = child;
}

void FlightProcess::look() {
  if (!is_under_way()) return;
  hear();
  int status = 0;
  if (waitpid(process_, &status, WNOHANG) != process_) return;
  process_ = 0;
  hear();
  take_end(status);
}

void FlightProcess::stop(const std::string& why) {
  if (!is_under_way()) return;
  is_stopped_ = true;
  stopped_text_ = why;
  kill(process_, SIGKILL);  // its connection ends with it: no walk and no way goes on
}

void FlightProcess::hear() {
  std::array<char, 4096> bytes{};
  for (ssize_t count = 0; (count = read(says_.get(), bytes.data(), bytes.size())) > 0;) {
    heard_.append(bytes.data(), static_cast<std::size_t>(count));
    for (std::size_t end = 0; (end = heard_.find('\n')) != std::string::npos; heard_.erase(0, end + 1)) {
      take_line(heard_.substr(0, end));
    }
    if (heard_.size() > kLongestLine) heard_.clear();
  }
}

void FlightProcess::take_line(const std::string& line) {
  if (line.starts_with(kSends)) {
    state_ = State::sending;
    take_verdict();
  } else if (!line.empty() && !line.starts_with(' ')) {  // what is indented is the verdict's
    last_line_ = line;
  }
}

void FlightProcess::take_verdict() {
  std::ifstream file(out_ / kVerdict);
  const auto verdict = nlohmann::json::parse(file, nullptr, false);
  if (!verdict.is_object() || tried_ != 0) return;
  passed_ = verdict.value("passed", 0U);
  tried_ = verdict.value("robots", 0U);
  text_ = verdict_of(verdict);
  if (std::filesystem::exists(picture())) ++pictures_;
}

void FlightProcess::take_end(int status) {
  constexpr int kNotPassed = 2;
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  if (is_stopped_) {
    state_ = State::stopped;
    text_ = stopped_text_;
  } else if (code == 0) {
    state_ = State::done;
  } else if (code == kNotPassed) {
    take_verdict();
    state_ = State::not_passed;
  } else {
    state_ = State::failed;
    const std::string prefix = "gaitway: ";
    const std::string said = last_line_.starts_with(prefix) ? last_line_.substr(prefix.size()) : last_line_;
    text_ = WIFSIGNALED(status) ? fmt::format("the pre-flight was ended by signal {}", WTERMSIG(status))
            : said.empty()      ? fmt::format("the pre-flight has ended with code {}", code)
                                : said;
  }
}

const char* name(FlightProcess::State state) noexcept {
  constexpr std::array kNames{"idle", "trying", "sending", "done", "not passed", "failed", "stopped"};
  return kNames[static_cast<std::size_t>(state)];
}

}  // namespace gaitway::tools
