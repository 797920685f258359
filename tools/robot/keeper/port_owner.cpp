// The sockets that listen, from /proc/net/tcp*, and whose descriptors they are.
#include "tools/robot/keeper/port_owner.hpp"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <vector>

#include "gaitway/input/text.hpp"

namespace gaitway::tools {
namespace {

namespace fs = std::filesystem;

constexpr const char* kUnknown = "a program that cannot be looked at";

// Of a table of sockets: "sl: ADDRESS:PORT remote state queues timer retransmits uid timeout inode …".
void add_listeners(const char* table, int port, std::set<std::string>& found) {
  std::ifstream lines(table);
  std::string line;
  std::getline(lines, line);  // the heading
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    const std::vector<std::string> word{std::istream_iterator<std::string>(words), {}};
    constexpr std::size_t kLocal = 1, kState = 3, kInode = 9;
    if (word.size() <= kInode || word[kState] != "0A") continue;
    const std::string& local = word[kLocal];
    const std::size_t colon = local.rfind(':');
    int listened = 0;
    std::from_chars(local.data() + colon + 1, local.data() + local.size(), listened, 16);
    if (listened == port) found.insert("socket:[" + word[kInode] + "]");
  }
}

std::set<std::string> listeners(int port) {
  std::set<std::string> found;
  add_listeners("/proc/net/tcp", port, found);
  add_listeners("/proc/net/tcp6", port, found);
  return found;
}

std::optional<bool> has_one_of(const fs::path& process, const std::set<std::string>& sockets) {
  std::error_code failed;
  fs::directory_iterator descriptor(process / "fd", failed);
  if (failed) return std::nullopt;
  for (const fs::directory_iterator end; !failed && descriptor != end; descriptor.increment(failed)) {
    std::error_code closed;
    if (sockets.contains(fs::read_symlink(descriptor->path(), closed).string())) return true;
  }
  return false;
}

// The program's name; of a robot's interface also which robot's, by the folder of its link.
std::string describe(const fs::path& process) {
  std::ifstream in(process / "cmdline", std::ios::binary);
  std::vector<std::string> words;
  for (std::string word; std::getline(in, word, '\0');) words.push_back(word);
  std::string name = words.empty() ? "?" : fs::path(words.front()).filename().string();
  constexpr std::string_view kUnix = "unix:";
  for (std::size_t i = 0; i + 1 < words.size(); ++i) {
    if (words[i] == "--link" && words[i + 1].starts_with(kUnix)) {
      name += " of the robot in " + fs::path(words[i + 1].substr(kUnix.size())).parent_path().string();
    }
  }
  return fmt::format("process {} ({})", process.filename().string(), input::terminal_text(name));
}

}  // namespace

std::optional<bool> listens(pid_t process, int port) {
  const std::set<std::string> sockets = listeners(port);
  if (sockets.empty()) return std::nullopt;  // the table cannot be read here
  return has_one_of(fs::path("/proc") / std::to_string(process), sockets);
}

std::string describe_listener(int port) {
  const std::set<std::string> sockets = listeners(port);
  if (sockets.empty()) return {};
  std::error_code failed;
  fs::directory_iterator process("/proc", failed);
  for (const fs::directory_iterator end; !failed && process != end; process.increment(failed)) {
    const std::string name = process->path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    if (has_one_of(process->path(), sockets).value_or(false)) return describe(process->path());
  }
  return kUnknown;
}

}  // namespace gaitway::tools
