// fork, a lock that the part keeps, exec. The lock file's text says who has it: whoever finds it locked can
// take that process over.
#include "tools/robot/keeper/part_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sched.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "gaitway/input/text.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::tools {
namespace {

constexpr mode_t kOwnerOnly = 0600;
// A process that was killed gives its lock back when the kernel has taken it down, with all of its memory.
constexpr std::int64_t kLockPatience_ns = 2'000'000'000;
constexpr std::int64_t kRecordPatience_ns = 200'000'000;
constexpr std::int64_t kBetweenTries_ns = 1'000'000;
constexpr std::uintmax_t kLastWordsBytes = 4096;

std::string file_text(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// The end of the file from `begin` on, at most so many bytes.
std::string file_end(const std::filesystem::path& file, std::uintmax_t begin, std::uintmax_t most_bytes) {
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(file, unknown);
  if (unknown || size == 0) return {};
  if (begin > size) begin = 0;  // it was cut down meanwhile
  std::ifstream in(file, std::ios::binary);
  in.seekg(static_cast<std::streamoff>(std::max(begin, size - std::min(size, most_bytes))));
  return {std::istreambuf_iterator<char>(in), {}};
}

// "Name:   value" of a /proc file.
std::uint64_t number_after(const std::string& text, const std::string& name) {
  const std::size_t at = text.find("\n" + name);
  return at == std::string::npos ? 0 : std::strtoull(text.c_str() + at + 1 + name.size(), nullptr, 10);
}

process::FileDescriptor pidfd_of(pid_t process) {
  return process::FileDescriptor(static_cast<int>(syscall(SYS_pidfd_open, process, 0)));
}

// Not so: it has ended, even if nobody has taken notice yet.
bool lives(const process::FileDescriptor& pidfd) {
  pollfd ended{pidfd.get(), POLLIN, 0};
  return pidfd && poll(&ended, 1, 0) == 0;
}

// Each option's values; under no name what comes before the first of them. The program may lie elsewhere.
using Options = std::map<std::string, std::vector<std::string>>;

Options options_of(const std::vector<std::string>& words) {
  Options options;
  std::string name;
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (words[i].starts_with("--")) {
      name = words[i];
      options.try_emplace(name);
    } else {
      options[name].push_back(words[i]);
    }
  }
  return options;
}

// "2026-01-31T12:00:00.000Z: what happened", without the time: whoever repeats it says when.
std::string without_time(const std::string& said) {
  constexpr std::string_view kTime = "0000-00-00T00:00:00.000Z: ";
  const auto is_like = [](char character, char form) {
    return form == '0' ? std::isdigit(static_cast<unsigned char>(character)) != 0 : character == form;
  };
  const bool has_time = said.size() >= kTime.size() &&
                        std::equal(kTime.begin(), kTime.end(), said.begin(),
                                   [&](char form, char character) { return is_like(character, form); });
  return has_time ? said.substr(kTime.size()) : said;
}

}  // namespace

void bound_log(const std::filesystem::path& file, std::uintmax_t most_bytes) {
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(file, unknown);
  if (unknown || size <= most_bytes) return;
  std::string kept = file_end(file, 0, most_bytes / 2);
  kept.erase(0, std::min(kept.find('\n'), kept.size() - 1) + 1);
  const process::FileDescriptor out(open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC));
  // Whoever appends goes on at the file's new end.
  if (out && ftruncate(out.get(), 0) == 0) {
    static_cast<void>(!write(out.get(), kept.data(), kept.size()));
  }
}

PartProcess::PartProcess(std::string name, std::vector<std::string> words, const Place& place)
    : name_(std::move(name)),
      words_(std::move(words)),
      lock_(place.folder / (name_ + ".lock")),
      log_(place.log / (name_ + ".log")) {}

process::FileDescriptor PartProcess::open_lock() const {
  process::FileDescriptor lock(open(lock_.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, kOwnerOnly));
  if (!lock) {
    throw std::runtime_error(
        fmt::format("{}: '{}' cannot be made: {}", name_, lock_.string(), std::strerror(errno)));
  }
  return lock;
}

PartProcess::Record PartProcess::read_record() const {
  std::istringstream lines(file_text(lock_));
  Record record;
  lines >> record.process;
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) record.words.push_back(line);
  return record;
}

bool PartProcess::take_over() {
  return adopt(false);
}
bool PartProcess::take_over_whatever() {
  return adopt(true);
}

// Robot and bus are the same, or it cannot be watched over as this robot. What else differs, an option that
// another version had or had not among it, is for its next start.
void PartProcess::compare(const Record& record) {
  constexpr std::array<std::string_view, 6> kBinding{"--robot", "--profile", "--can",
                                                     "--bus",   "--memory",  "--socket"};
  const Options theirs = options_of(record.words), ours = options_of(words_);
  std::set<std::string> differ;
  for (const Options* const options : {&theirs, &ours}) {
    for (const auto& [name, value] : *options) {
      const bool is_same = theirs.contains(name) && ours.contains(name) && theirs.at(name) == ours.at(name);
      if (!is_same) differ.insert(name);
    }
  }
  for (const std::string& name : differ) {
    if (!name.empty() && std::ranges::find(kBinding, name) == kBinding.end()) continue;
    throw std::runtime_error(
        fmt::format("{}: process {} runs in this folder with {}. End it first by 'gaitway robot "
                    "down', or choose another --folder",
                    name_, record.process, name.empty() ? "other words" : "another " + name));
  }
  differences_ = fmt::format("{}", fmt::join(differ, ", "));
}

bool PartProcess::adopt(bool whatever) {
  const process::FileDescriptor lock = open_lock();
  if (flock(lock.get(), LOCK_EX | LOCK_NB) == 0) return false;
  Record record;
  process::FileDescriptor pidfd;
  // One that was started in its supervisor's last moment is about to write who it is.
  const std::int64_t until_ns = process::monotonic_ns() + kRecordPatience_ns;
  while (true) {
    record = read_record();
    if (record.process > 0) pidfd = pidfd_of(record.process);
    if (lives(pidfd) && getpgid(record.process) == record.process) break;
    if (process::monotonic_ns() >= until_ns) {
      return false;  // it has ended, and what it had started is about to: start() sees to that
    }
    process::wait_until(process::monotonic_ns() + kBetweenTries_ns, {});
  }
  if (!whatever) compare(record);
  process_ = record.process;
  pidfd_ = std::move(pidfd);
  is_child_ = false;
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(log_, unknown);
  log_begin_ = unknown ? 0 : size;
  return true;
}

process::FileDescriptor PartProcess::take_lock() const {
  process::FileDescriptor lock = open_lock();
  const std::int64_t until_ns = process::monotonic_ns() + kLockPatience_ns;
  while (flock(lock.get(), LOCK_EX | LOCK_NB) != 0) {
    const pid_t holder = read_record().process;
    const bool holder_lives = holder > 0 && lives(pidfd_of(holder));
    if (holder_lives || process::monotonic_ns() >= until_ns) {
      throw std::runtime_error(
          fmt::format("another one runs in this folder ('{}', process {}): it is not started a second time",
                      lock_.string(), holder));
    }
    if (holder > 1) kill(-holder, SIGKILL);  // what it has left behind
    process::wait_until(process::monotonic_ns() + kBetweenTries_ns, {});
  }
  return lock;
}

void PartProcess::start() {
  const process::FileDescriptor lock = take_lock();
  const process::FileDescriptor log(
      open(log_.c_str(), O_CREAT | O_WRONLY | O_APPEND | O_CLOEXEC, kOwnerOnly));
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(log_, unknown);
  log_begin_ = unknown ? 0 : size;
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) {
    throw std::runtime_error(fmt::format("no process: {}", std::strerror(errno)));
  }
  if (child == 0) {
    become(lock, log);
  }
  process_ = child;
  is_child_ = true;
  pidfd_ = pidfd_of(child);
  if (!pidfd_) {
    const std::string why = std::strerror(errno);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    process_ = 0;
    throw std::runtime_error("it cannot be watched: " + why);
  }
}

// Of the new process: one of its own session, so that a terminal's Ctrl-C is the supervisor's alone.
void PartProcess::become(const process::FileDescriptor& lock, const process::FileDescriptor& log) const {
  setsid();
  std::string record = fmt::format("{}\n", getpid());
  for (const std::string& word : words_) record += word + "\n";
  static_cast<void>(!ftruncate(lock.get(), 0));
  static_cast<void>(!pwrite(lock.get(), record.data(), record.size(), 0));
  fcntl(lock.get(), F_SETFD, 0);  // it keeps the lock
  const process::FileDescriptor nothing(open("/dev/null", O_RDWR | O_CLOEXEC));
  dup2(nothing.get(), STDIN_FILENO);
  const int output = log ? log.get() : nothing.get();  // a full disk costs the log, not the robot
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  // A signal that came meanwhile is this process's: not for the supervisor's handler, which is still in
  // force.
  for (const int asks_to_end : {SIGINT, SIGTERM}) signal(asks_to_end, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  signal(SIGPIPE, SIG_DFL);
  std::vector<std::string> words = words_;
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  execv(argv[0], argv.data());
  const std::string failure =
      fmt::format("{}: '{}' cannot be run: {}\n", name_, words_.front(), std::strerror(errno));
  static_cast<void>(!write(STDERR_FILENO, failure.data(), failure.size()));
  _exit(127);
}

void PartProcess::send(int signal) const {
  if (pidfd_) {
    syscall(SYS_pidfd_send_signal, pidfd_.get(), signal, nullptr, 0);
  }
}

void PartProcess::end_group() const {
  send(SIGKILL);
  if (process_ > 1) {
    kill(-process_, SIGKILL);
  }
}

std::optional<std::string> PartProcess::take_end() {
  pollfd ended{pidfd_.get(), POLLIN, 0};
  if (process_ == 0 || poll(&ended, 1, 0) <= 0) return std::nullopt;
  std::string how = "ended; how is not known, since an earlier supervisor had started it";
  if (is_child_) {
    kill(-process_, SIGKILL);  // what it had started does not live on without it
    int status = 0;
    waitpid(process_, &status, 0);
    how = WIFSIGNALED(status)
              ? fmt::format("was ended by signal {} ({})", WTERMSIG(status), strsignal(WTERMSIG(status)))
              : fmt::format("ended with code {}", WEXITSTATUS(status));
  }
  const bool by_itself = how.find("signal 9 ") == std::string::npos;
  if (const std::string words = last_words(); by_itself && !words.empty()) {
    how += ": " + words;
  }
  process_ = 0;
  pidfd_ = process::FileDescriptor();
  return how;
}

std::string PartProcess::last_words(std::string_view with) const {
  std::istringstream lines(file_end(log_, log_begin_, kLastWordsBytes));
  std::string said, line;
  const std::string own = name_ + ": ";
  while (std::getline(lines, line)) {
    const bool is_news = line.find(": info: ") != std::string::npos;  // told at any time, of no trouble
    if (!is_news && line.starts_with(own) && line.find(with) != std::string::npos)
      said = line.substr(own.size());
  }
  return input::terminal_text(without_time(said));
}

std::string PartProcess::kernel_state() const {
  const std::string text = file_text(fmt::format("/proc/{}/stat", worker()));
  const std::size_t name_end = text.rfind(')');
  const char state = name_end + 2 < text.size() ? text[name_end + 2] : ' ';
  switch (state) {
    case 'T':
      return "it was stopped (SIGSTOP)";
    case 't':
      return "it was stopped by a debugger";
    case 'D':
      return "it waited for a device or a disk";
    case 'R':
      return "it was busy";
    case 'S':
      return "it slept";
    default:
      return {};
  }
}

std::uint64_t PartProcess::rounds() const {
  std::uint64_t rounds = 0;
  std::error_code gone;
  for (std::filesystem::directory_iterator thread(fmt::format("/proc/{}/task", process_), gone), end;
       !gone && thread != end; thread.increment(gone)) {
    rounds += number_after(file_text(thread->path() / "status"), "voluntary_ctxt_switches:");
  }
  return rounds;
}

bool PartProcess::is_real_time() const {
  const pid_t process = worker();
  return process > 0 && sched_getscheduler(process) == SCHED_FIFO;
}

// A child of the same program.
pid_t PartProcess::worker() const {
  std::error_code unknown;
  const auto program = [&unknown](pid_t process) {
    return std::filesystem::read_symlink(fmt::format("/proc/{}/exe", process), unknown);
  };
  const std::filesystem::path own = program(process_);
  std::istringstream children(file_text(fmt::format("/proc/{0}/task/{0}/children", process_)));
  for (pid_t child = 0; children >> child;) {
    if (!own.empty() && program(child) == own) return child;
  }
  return process_;
}

}  // namespace gaitway::tools
