// One loop: who has ended, who makes progress, what is to be done.
#include "tools/robot/keeper/robot_keeper.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <sys/file.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <utility>

#include "gaitway/facts/facts.hpp"
#include "gaitway/process/real_time.hpp"
#include "tools/robot/keeper/port_owner.hpp"

namespace gaitway::tools {
namespace {

using facts::kMillisecond_ns;

constexpr std::int64_t kBetweenLooks_ns = 20 * kMillisecond_ns;
constexpr std::int64_t kBetweenLooksAtChange_ns = 5 * kMillisecond_ns;  // something is being started
constexpr std::int64_t kBetweenRounds_ns = 100 * kMillisecond_ns;       // looks into /proc
constexpr std::int64_t kBetweenStatus_ns = 200 * kMillisecond_ns;
constexpr std::int64_t kBetweenLogBounds_ns = 5'000 * kMillisecond_ns;
constexpr const char* kLockName = "robot.lock";

std::string seconds_text(std::int64_t duration_ns) {
  return fmt::format("{:.3f} s", static_cast<double>(duration_ns) * 1e-9);
}

std::vector<PartProcess> processes_of(const std::vector<PartPlan>& plans, const RobotFolders& folders) {
  std::vector<PartProcess> processes;
  for (const PartPlan& plan : plans) {
    processes.emplace_back(plan.name, plan.words,
                           PartProcess::Place{.folder = folders.folder, .log = folders.log});
  }
  return processes;
}

}  // namespace

SupervisorLock::SupervisorLock(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kLockName;
  lock_ = process::FileDescriptor(open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0600));
  if (!lock_) {
    throw std::invalid_argument(
        fmt::format("'{}' cannot be made: {}. Choose another --folder", file.string(), std::strerror(errno)));
  }
  // Who only asks whether there is a supervisor has it for a moment.
  const std::int64_t until_ns = process::monotonic_ns() + 100 * kMillisecond_ns;
  while (flock(lock_.get(), LOCK_EX | LOCK_NB) != 0) {
    if (process::monotonic_ns() < until_ns) {
      process::wait_until(process::monotonic_ns() + kMillisecond_ns, {});
      continue;
    }
    throw std::invalid_argument(fmt::format(
        "a robot is up in {} already: its supervisor is process {}. 'gaitway robot down' ends it; or "
        "choose another --folder for another robot",
        folder.string(), holder(folder)));
  }
  const std::string text = fmt::format("{}\n", getpid());
  static_cast<void>(!ftruncate(lock_.get(), 0));
  static_cast<void>(!pwrite(lock_.get(), text.data(), text.size(), 0));
}

pid_t SupervisorLock::holder(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / kLockName;
  const process::FileDescriptor lock(open(file.c_str(), O_RDWR | O_CLOEXEC));
  if (!lock || flock(lock.get(), LOCK_SH | LOCK_NB) == 0) return 0;
  pid_t process = 0;
  std::ifstream(file) >> process;
  return process;
}

RobotKeeper::RobotKeeper(std::vector<PartPlan> plans, Options options)
    : plans_(std::move(plans)),
      options_(std::move(options)),
      processes_(processes_of(plans_, options_.folders)),
      view_(options_.folders.memory_socket()),
      probe_(options_.probe_address, options_.probe_port),
      events_(options_.folders.event_file()) {
  for (const PartPlan& plan : plans_) {
    parts_.push_back({.watch = PartWatch(plan.patience, process::monotonic_ns()), .start_complaint = {}});
  }
}

void RobotKeeper::tell(const std::string& text) {
  events_.tell(text);
  kept_ns_ = 0;  // and it is in the status at once
  if (!options_.quiet) {
    fmt::print(stderr, "gaitway robot: {}\n", text);
    std::fflush(stderr);
  }
}

bool RobotKeeper::run() {
  up_ns_ = process::monotonic_ns();
  take_over();
  notice_.tell("READY=1");
  while (!process::stop_requested()) {
    const std::int64_t now_ns = process::monotonic_ns();
    round(now_ns);
    keep_house(now_ns);
    wait(now_ns);
  }
  notice_.tell("STOPPING=1\nSTATUS=the robot is taken down");
  for (Part& part : parts_) part.watch.switch_off();
  const bool well = end_parts(plans_, processes_, view_, [this](const std::string& text) { tell(text); });
  commanded_ = false;
  write_status(options_.folders.status_file(), status(process::monotonic_ns()));
  tell(well ? "down" : "down; not every part ended by itself");
  return well;
}

// All of them, or none is touched.
void RobotKeeper::take_over() {
  std::vector<std::string> taken;
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    if (processes_[i].take_over()) {
      parts_[i].watch.on_taken_over(up_ns_);
      taken.push_back(fmt::format("{} (process {})", plans_[i].name, processes_[i].pid()));
    }
  }
  tell(taken.empty() ? "up"
                     : fmt::format("up; an earlier supervisor is gone, its parts are taken over: {}",
                                   fmt::join(taken, ", ")));
  for (const PartProcess& process : processes_) {
    if (process.differences().empty()) continue;
    tell(fmt::format(
        "{}: was started with other options, and goes on with them. Its next start has the new: {}",
        process.name(), process.differences()));
  }
}

void RobotKeeper::round(std::int64_t now_ns) {
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    look_at(i, now_ns);
  }
  follow_command(now_ns);
}

void RobotKeeper::look_at(std::size_t index, std::int64_t now_ns) {
  PartWatch& watch = parts_[index].watch;
  if (const auto how = processes_[index].take_end()) {
    on_end(index, *how, now_ns);
  }
  follow_progress(index, now_ns);
  look_for_worker(index, now_ns);
  const std::string& needs = plans_[index].needs;
  switch (watch.step(now_ns, needs.empty() || works(needs))) {
    case PartWatch::Wish::start:
      start(index, now_ns);
      break;
    case PartWatch::Wish::kill:
      end_hung(index);
      break;
    case PartWatch::Wish::nothing:
      break;
  }
}

bool RobotKeeper::works(const std::string& name) const {
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    if (plans_[i].name == name) return parts_[i].watch.state() == PartState::works;
  }
  return false;
}

void RobotKeeper::on_end(std::size_t index, const std::string& how, std::int64_t now_ns) {
  PartWatch& watch = parts_[index].watch;
  const std::int64_t pause_ns = watch.pause_ns();
  watch.on_end(how + port_trouble(index), now_ns);
  tell(fmt::format("{}: {}. It is started again {}{}", plans_[index].name, watch.reason(),
                   pause_ns == 0 ? "at once" : fmt::format("in {}", seconds_text(pause_ns)),
                   watch.failures() > 1 ? fmt::format(", its failure {} in a row", watch.failures()) : ""));
  if (plans_[index].progress == Progress::block) view_.forget();
  parts_[index].worker = 0;
  if (disturbed_ns_ == 0) {
    disturbed_ns_ = now_ns;
    disturbance_ = plans_[index].name;
  }
}

// Where somebody else has the port that this part is to listen on: who; empty: nobody.
std::string RobotKeeper::port_trouble(std::size_t index) const {
  if (plans_[index].progress != Progress::answers) return {};
  const std::string other = describe_listener(options_.probe_port);
  const bool is_own = listens(processes_[index].pid(), options_.probe_port).value_or(false);
  return other.empty() || is_own ? std::string()
                                 : fmt::format(". Port {} is taken by {}", options_.probe_port, other);
}

void RobotKeeper::start(std::size_t index, std::int64_t now_ns) {
  Part& part = parts_[index];
  try {
    processes_[index].start();
  } catch (const std::runtime_error& error) {
    part.watch.on_start(now_ns);
    part.watch.on_end(fmt::format("could not be started: {}", error.what()), now_ns);
    if (std::exchange(part.start_complaint, error.what()) != error.what()) {
      tell(fmt::format("{}: {}. It is tried again and again", plans_[index].name, part.watch.reason()));
    }
    return;
  }
  part.start_complaint.clear();
  part.watch.on_start(process::monotonic_ns());
}

void RobotKeeper::end_hung(std::size_t index) {
  const std::string state = processes_[index].kernel_state();
  const std::string seen = (state.empty() ? "" : ": " + state) + port_trouble(index);
  parts_[index].watch.describe_hang(seen);
  processes_[index].end_group();
}

void RobotKeeper::follow_progress(std::size_t index, std::int64_t now_ns) {
  Part& part = parts_[index];
  if (processes_[index].pid() == 0) return;
  const PartPlan& plan = plans_[index];
  const bool is_of_rounds = plan.progress == Progress::rounds || plan.progress == Progress::joints;
  if (is_of_rounds && now_ns - part.looked_ns >= kBetweenRounds_ns) {
    part.looked_ns = now_ns;
    part.rounds = processes_[index].rounds();
  }
  std::optional<std::uint64_t> count;
  switch (plan.progress) {
    case Progress::rounds:
      count = part.rounds;
      break;
    case Progress::joints:
      count = part.rounds + view_.joint_feedback().value_or(0);
      break;
    case Progress::block:
      count = view_.look() ? view_.message_controller_beats() : std::nullopt;
      break;
    case Progress::reports:
      count = works(plan.lives_in) ? view_.main_controller_reports() : std::nullopt;
      if (!count) part.watch.on_unseen(now_ns);
      break;
    case Progress::answers:
      count = probe_.step(now_ns, processes_[index].pid());
      if (const std::string stranger = probe_.take_stranger(); !stranger.empty()) {
        tell(fmt::format("{}: port {} is taken: {} answers there, not this robot", plan.name,
                         options_.probe_port, stranger));
      }
      break;
  }
  const std::int64_t ended_ns = part.watch.ended_ns().value_or(0);
  if (count && part.watch.on_progress(*count, now_ns)) {
    on_works(index, ended_ns == 0 ? 0 : now_ns - ended_ns, now_ns);
  }
}

void RobotKeeper::on_works(std::size_t index, std::int64_t downtime_ns, std::int64_t now_ns) {
  const PartPlan& plan = plans_[index];
  tell(downtime_ns == 0 ? fmt::format("{}: works (process {})", plan.name, processes_[index].pid())
                        : fmt::format("{}: works again (process {}), {} after its end", plan.name,
                                      processes_[index].pid(), seconds_text(downtime_ns)));
  if (downtime_ns == 0) return;
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    if (plans_[i].lives_in != plan.name) continue;
    parts_[i].watch.on_new_ground(plans_[i].moves_ns, now_ns);
    parts_[i].moved_ns = now_ns;
  }
}

// Where a part keeps a process of its own, that one may have been started again by it.
void RobotKeeper::look_for_worker(std::size_t index, std::int64_t now_ns) {
  Part& part = parts_[index];
  if (plans_[index].progress != Progress::reports || processes_[index].pid() == 0 ||
      now_ns - part.looked_ns < kBetweenRounds_ns) {
    return;
  }
  part.looked_ns = now_ns;
  const pid_t worker = processes_[index].worker();
  if (worker == processes_[index].pid()) return;
  const pid_t before = std::exchange(part.worker, worker);
  if (before == 0 || before == worker) return;
  // It was moved to a new memory block, or says why it was started again.
  const bool was_moved = part.moved_ns != 0 && now_ns - part.moved_ns < plans_[index].moves_ns;
  part.moved_ns = 0;
  const std::string why = was_moved ? fmt::format("{} was started again", plans_[index].lives_in)
                                    : processes_[index].last_words("the process ");
  part.watch.on_inner_restart(why, now_ns);
  tell(fmt::format("{}: process {} is there in place of {}: {}", plans_[index].name, worker, before, why));
}

void RobotKeeper::follow_command(std::int64_t now_ns) {
  if (const std::string complaint = view_.take_complaint(); !complaint.empty()) {
    tell("what the parts do cannot be seen whole: " + complaint);
  }
  // A batch that is late for once is no news.
  constexpr std::int64_t kNews_ns = 100 * kMillisecond_ns;
  bool commanded = view_.may_be_commanded(now_ns);
  if (commanded) obeyed_ns_ = now_ns;
  // But who knows that a part has ended, need not wait.
  const bool is_hiccup = commanded_ && disturbed_ns_ == 0 && now_ns - obeyed_ns_ < kNews_ns;
  commanded = commanded || is_hiccup;
  why_not_ = commanded ? std::string() : why_not_commanded(now_ns);
  if (std::exchange(commanded_, commanded) == commanded) return;
  if (!commanded) {
    const std::string news = "the robot may not be commanded now: " + why_not_;
    tell(news);
    notice_.tell("STATUS=" + news);
    return;
  }
  commanded_since_ns_ = now_ns;
  tell(disturbed_ns_ == 0 ? "the robot may be commanded"
                          : fmt::format("the robot may be commanded again, {} after the end of {}",
                                        seconds_text(now_ns - disturbed_ns_), disturbance_));
  notice_.tell("STATUS=the robot may be commanded");
  disturbed_ns_ = 0;
}

// A part that does not work says more than what is seen of it from beside.
std::string RobotKeeper::why_not_commanded(std::int64_t now_ns) {
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    const PartWatch& watch = parts_[i].watch;
    if (plans_[i].progress == Progress::answers || watch.state() == PartState::works) continue;
    const std::string why = watch.reason().empty() ? "" : fmt::format("; it {}", watch.reason());
    return watch.state() == PartState::starts ? fmt::format("{} is starting{}", plans_[i].name, why)
                                              : fmt::format("{} is not there{}", plans_[i].name, why);
  }
  return view_.why_not_commanded(now_ns);
}

void RobotKeeper::keep_house(std::int64_t now_ns) {
  if (now_ns - kept_ns_ < kBetweenStatus_ns) return;
  kept_ns_ = now_ns;
  write_status(options_.folders.status_file(), status(now_ns));
  notice_.tell("WATCHDOG=1");
  if (commanded_ && !std::exchange(was_ready_, true) && options_.on_ready) options_.on_ready();
  // An end that cost nobody the command is past once all work again.
  const auto is_well = [](const Part& part) { return part.watch.state() == PartState::works; };
  if (commanded_ && std::ranges::all_of(parts_, is_well)) disturbed_ns_ = 0;
  if (now_ns - logs_ns_ < kBetweenLogBounds_ns) return;
  logs_ns_ = now_ns;
  for (const PartProcess& process : processes_) bound_log(process.log_file());
}

RobotStatus RobotKeeper::status(std::int64_t now_ns) {
  RobotStatus status{.supervisor = getpid(),
                     .written_ns = now_ns,
                     .up_ns = up_ns_,
                     .may_be_commanded = commanded_,
                     .commanded_since_ns = commanded_since_ns_,
                     .why_not = why_not_,
                     .commander = view_.who_commands(now_ns),
                     .lost_lines = events_.lost(),
                     .events = events_.file().string(),
                     .parts = {}};
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    const PartWatch& watch = parts_[i].watch;
    const PartProcess& process = processes_[i];
    status.parts.push_back({.name = plans_[i].name,
                            .state = name_of(watch.state()),
                            .process = process.pid(),
                            .worker = parts_[i].worker != 0 ? parts_[i].worker : process.pid(),
                            .since_ns = watch.since_ns(),
                            .progress_ns = watch.progress_ns(),
                            .restarts = watch.restarts(),
                            .failures = watch.failures(),
                            .real_time = process.is_real_time(),
                            .reason = watch.reason(),
                            .last_end_ns = watch.last_end_ns()});
  }
  return status;
}

void RobotKeeper::wait(std::int64_t now_ns) {
  std::vector<pollfd> ends;
  std::int64_t due_ns = now_ns + kBetweenLooks_ns;
  if (!commanded_) due_ns = now_ns + kBetweenLooksAtChange_ns;
  for (std::size_t i = 0; i < plans_.size(); ++i) {
    if (processes_[i].ended_fd() >= 0) ends.push_back({processes_[i].ended_fd(), POLLIN, 0});
    if (parts_[i].watch.state() == PartState::starts) due_ns = now_ns + kBetweenLooksAtChange_ns;
  }
  process::wait_until(due_ns, ends);
}

}  // namespace gaitway::tools
