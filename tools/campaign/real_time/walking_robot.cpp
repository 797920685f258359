// Starts `gaitway robot up`, with what the campaign puts in.
#include "tools/campaign/real_time/walking_robot.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <yaml-cpp/yaml.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/text_file.hpp"
#include "tools/campaign/real_time/disturbance.h"

namespace gaitway::tools {
namespace {

constexpr const char* kSaboteur = "stability";
// Its process is known by this bound, which it gets as a word: no other plug-in has it.
constexpr int kSaboteurDescriptors = 61;
constexpr const char* kDiskSize = "size=8m,mode=0700";
constexpr int kNoDisk = 126;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

// Of the loopback, free at the moment.
int free_port() {
  const process::FileDescriptor held(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof place;
  if (bind(held.get(), reinterpret_cast<const sockaddr*>(&place), size) != 0 ||
      getsockname(held.get(), reinterpret_cast<sockaddr*>(&place), &size) != 0) {
    throw std::runtime_error(fmt::format("no free port on the loopback: {}", std::strerror(errno)));
  }
  return ntohs(place.sin_port);
}

// A disk of a few megabytes at this place, which its own processes alone see. False: the system does not let.
bool mount_small_disk(const char* place) noexcept {
  if (unshare(CLONE_NEWNS) != 0 && unshare(CLONE_NEWUSER | CLONE_NEWNS) != 0) return false;
  if (mount(nullptr, "/", nullptr, MS_REC | MS_PRIVATE, nullptr) != 0) return false;
  return mount("gaitway_campaign", place, "tmpfs", 0, kDiskSize) == 0;
}

std::vector<std::string> words_of(pid_t process) {
  std::vector<std::string> words;
  std::ifstream in(fmt::format("/proc/{}/cmdline", process));
  for (std::string word; std::getline(in, word, '\0');) words.push_back(word);
  return words;
}

}  // namespace

std::filesystem::path campaign_program(const std::string& name) {
  std::error_code unknown;
  const std::filesystem::path beside = std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path();
  for (const std::filesystem::path& folder : {beside, process::installation_root() / "bin"}) {
    if (access((folder / name).c_str(), X_OK) == 0) return folder / name;
  }
  throw std::runtime_error(
      fmt::format("the program {} is not in {}: build or install it", name, beside.string()));
}

std::filesystem::path campaign_library(const std::string& name) {
  const std::filesystem::path file = process::installation_root() / "lib/gaitway/campaign" / name;
  if (access(file.c_str(), R_OK) == 0) return file;
  throw std::runtime_error(
      fmt::format("'{}' is not there: it comes with the build tree and the package", file.string()));
}

WalkingRobot::WalkingRobot(const Options& options)
    : options_(options), folder_("gaitway_campaign"), port_(free_port()) {
  std::filesystem::create_directory(folder() / "log");
  if (options_.equipment == Equipment::for_faults) {
    write_configuration();
    disturb(0, 0);
  }
  const int code = run(words(), options_.equipment == Equipment::for_faults);
  if (code == kNoDisk) {
    throw std::runtime_error(
        "no disk of its own for the robot's logs: this system lets nobody mount one in a namespace. Leave "
        "those rows out (--except), or be root");
  }
  if (code != 0) {
    const std::string why = text_of(folder() / "supervisor.txt");
    take_down();
    throw std::runtime_error(fmt::format("the robot does not come up: {}", why));
  }
}

WalkingRobot::~WalkingRobot() {
  take_down();
}

void WalkingRobot::take_down() const {
  static_cast<void>(run({campaign_program("gaitway-robot"), "robot", "down", "--folder", folder()}, false));
}

std::string WalkingRobot::url() const {
  return fmt::format("ws://127.0.0.1:{}", port_);
}

std::filesystem::path WalkingRobot::logs() const {
  const auto status = read_status(folder() / "status.json");
  const pid_t supervisor = status ? status->supervisor : 0;
  return fmt::format("/proc/{}/root{}/log", supervisor, folder().string());
}

std::vector<std::string> WalkingRobot::words() const {
  std::vector<std::string> words{campaign_program("gaitway-robot"),
                                 "robot",
                                 "up",
                                 "--simulate",
                                 "--detach",
                                 "--quiet",
                                 "--robot",
                                 options_.robot,
                                 "--folder",
                                 folder(),
                                 "--log",
                                 folder() / "log",
                                 "--port",
                                 std::to_string(port_),
                                 "--seed",
                                 std::to_string(options_.seed)};
  if (options_.equipment == Equipment::for_faults) {
    words.insert(words.end(), {"--config", folder() / "campaign.yaml"});
  }
  return words;
}

void WalkingRobot::write_configuration() const {
  YAML::Node root = YAML::LoadFile((process::config_directory() / "serve.yaml").string());
  for (YAML::Node plugin : root["plugins"]) {
    if (plugin["name"].as<std::string>() != kSaboteur) continue;
    plugin["library"] = campaign_library("saboteur.so").string();
    plugin["isolation"] = "process";
    plugin["descriptors"] = kSaboteurDescriptors;
  }
  process::write_text_file(folder() / "campaign.yaml", YAML::Dump(root) + "\n");
}

void WalkingRobot::become(const std::vector<std::string>& words) const {
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  execv(arguments[0], arguments.data());
}

int WalkingRobot::run(const std::vector<std::string>& words, bool on_own_disk) const {
  const std::string said = folder() / "supervisor.txt", log = folder() / "log";
  const std::string preload =
      on_own_disk ? "LD_PRELOAD=" + campaign_library("disturbance.so").string() : std::string();
  const std::string file = GAITWAY_DISTURBANCE_VARIABLE "=" + (folder() / "disturbance").string();
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error(fmt::format("no process: {}", std::strerror(errno)));
  if (child == 0) {
    setpgid(0, 0);  // Ctrl-C is told to the campaign, which takes the robot down
    const int out = open(said.c_str(), O_CREAT | O_APPEND | O_WRONLY | O_CLOEXEC, 0600);
    dup2(open("/dev/null", O_RDONLY | O_CLOEXEC), STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    dup2(out, STDERR_FILENO);
    if (on_own_disk) {
      if (!mount_small_disk(log.c_str())) _exit(kNoDisk);
      putenv(const_cast<char*>(preload.c_str()));
      putenv(const_cast<char*>(file.c_str()));
    }
    become(words);
    _exit(127);
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

pid_t WalkingRobot::worker(const std::string& part) const {
  if (const auto status = read_status(folder() / "status.json")) {
    for (const PartStatus& one : status->parts) {
      if (one.name == part && one.worker > 1) return one.worker;
    }
  }
  throw std::runtime_error(fmt::format("the robot has no process {} at the moment", part));
}

pid_t WalkingRobot::plugin_host() const {
  const pid_t owner = worker("main_controller");
  std::error_code gone;
  for (std::filesystem::directory_iterator thread(fmt::format("/proc/{}/task", owner), gone), end;
       !gone && thread != end; thread.increment(gone)) {
    std::ifstream children(thread->path() / "children");
    for (pid_t child = 0; children >> child;) {
      const std::vector<std::string> words = words_of(child);
      if (words.size() > 3 && words[3] == std::to_string(kSaboteurDescriptors)) return child;
    }
  }
  throw std::runtime_error("the plug-in 'stability' has no process at the moment");
}

bool WalkingRobot::told_fall() const {
  return text_of(logs() / "virtual_robot.log").find("virtual_robot: fell after") != std::string::npos;
}

void WalkingRobot::set_parameter(const std::string& name, const std::string& value) const {
  if (run({campaign_program("gaitway-ctl"), "ctl", "plugin", "set", kSaboteur, name, value, "--socket",
           folder() / "memory.sock"},
          false) != 0) {
    throw std::runtime_error(fmt::format("'{}' of the plug-in '{}' cannot be set: {}", name, kSaboteur,
                                         text_of(folder() / "supervisor.txt")));
  }
}

void WalkingRobot::disturb(std::int64_t clock_shift_ns, std::int64_t write_ns) const {
  const gaitway_disturbance words{clock_shift_ns, write_ns};
  const process::FileDescriptor file(
      open((folder() / "disturbance").c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600));
  if (pwrite(file.get(), &words, sizeof words, 0) != static_cast<ssize_t>(sizeof words)) {
    throw std::runtime_error(fmt::format("no disturbance can be written: {}", std::strerror(errno)));
  }
}

}  // namespace gaitway::tools
