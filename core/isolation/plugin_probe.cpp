// A child process constructs the plug-in and sends home what it declared.
#include "gaitway/isolation/plugin_probe.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>

#include "gaitway/manager/loaded_plugin.hpp"

namespace gaitway::core {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::string_view kDescription = "description", kProblem = "problem";

// A list of texts, each with its length in front.
class TextWriter {
 public:
  void add(std::string_view text) {
    const auto size = static_cast<std::uint32_t>(text.size());
    bytes_.append(reinterpret_cast<const char*>(&size), sizeof size).append(text);
  }
  void add_count(std::size_t count) { add(std::to_string(count)); }
  [[nodiscard]] const std::string& bytes() const noexcept { return bytes_; }

 private:
  std::string bytes_;
};

class TextReader {
 public:
  explicit TextReader(std::string_view bytes) : rest_(bytes) {}
  // Throws PluginError when the child was cut short.
  std::string next() {
    std::uint32_t size = 0;
    if (rest_.size() >= sizeof size) {
      std::memcpy(&size, rest_.data(), sizeof size);
      rest_.remove_prefix(sizeof size);
      if (rest_.size() >= size) {
        const std::string text(rest_.substr(0, size));
        rest_.remove_prefix(size);
        return text;
      }
    }
    throw PluginError("its process ended before it had said everything");
  }
  std::size_t next_count() { return std::stoul(next()); }

 private:
  std::string_view rest_;
};

void write_description(const LoadedPlugin& plugin, TextWriter& out) {
  const gaitway_plugin& entry = plugin.library().entry();
  out.add(kDescription);
  for (const char* const text : {entry.name, entry.version, entry.description}) {
    out.add(text);
  }
  out.add(std::filesystem::absolute(plugin.library().file()).lexically_normal().string());
  out.add(plugin.period() == Period::tick ? "tick" : "batch");
  const DataFlowNode node = plugin.node();
  out.add_count(node.uses.size());
  for (const TopicUse& use : node.uses) {
    out.add(use.topic);
    out.add(use.type_name);
    out.add_count(static_cast<std::size_t>(use.access));
  }
  out.add_count(plugin.parameters().declared().size());
  for (const Parameter& parameter : plugin.parameters().declared()) {
    for (const std::string_view text :
         {std::string_view(parameter.name), parameter_kind_name(parameter.kind),
          std::string_view(parameter.unit), std::string_view(parameter.fallback),
          std::string_view(parameter.doc)}) {
      out.add(text);
    }
    out.add(fmt::format("{}", parameter.lowest));
    out.add(fmt::format("{}", parameter.highest));
    out.add(parameter.live ? "live" : "fixed");
  }
}

PluginDescription read_description(TextReader& in) {
  PluginDescription description;
  description.name = in.next();
  description.version = in.next();
  description.text = in.next();
  description.file = in.next();
  description.every_tick = in.next() == "tick";
  for (std::size_t count = in.next_count(); count > 0; --count) {
    DescribedTopic topic{in.next(), in.next(), Access::read};
    topic.access = static_cast<Access>(in.next_count());
    description.topics.push_back(topic);
  }
  for (std::size_t count = in.next_count(); count > 0; --count) {
    DescribedParameter parameter{in.next(), in.next(), in.next(), in.next(), in.next()};
    parameter.lowest = std::stod(in.next());
    parameter.highest = std::stod(in.next());
    parameter.live = in.next() == "live";
    description.parameters.push_back(parameter);
  }
  return description;
}

// Everything that the child does.
[[noreturn]] void describe_and_exit(const PluginEntry& entry, const std::filesystem::path& configuration,
                                    const ProbeOptions& options, int pipe) {
  TextWriter out;
  try {
    EventLog events;
    const PluginSource source{configuration, options.robot_directory, options.plugin_path};
    const LoadedPlugin plugin(entry, source, events);
    write_description(plugin, out);
  } catch (const std::exception& error) {
    out = {};
    out.add(kProblem);
    out.add(error.what());
  }
  std::string_view rest = out.bytes();
  while (!rest.empty()) {
    const ssize_t written = write(pipe, rest.data(), rest.size());
    if (written < 0 && errno != EINTR) {
      break;
    }
    rest.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
  }
  _exit(0);  // nothing of the parent's is destroyed twice
}

// All that comes out of the pipe until its other end is closed; false: not within the time.
bool read_all(int pipe, std::chrono::milliseconds patience, std::string& bytes) {
  const auto deadline = Clock::now() + patience;
  std::array<char, 4096> buffer{};
  while (true) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now());
    pollfd waiting{pipe, POLLIN, 0};
    const int ready = poll(&waiting, 1, static_cast<int>(std::max<std::int64_t>(left.count(), 0)));
    if (ready == 0) {
      return false;
    }
    const ssize_t got = ready < 0 ? -1 : read(pipe, buffer.data(), buffer.size());
    if (got == 0) {
      return true;
    }
    if (got > 0) {
      bytes.append(buffer.data(), static_cast<std::size_t>(got));
    } else if (errno != EINTR) {
      return true;
    }
  }
}

int wait_for(pid_t child) {
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

bool PluginDescription::writes(std::string_view topic) const noexcept {
  return std::any_of(topics.begin(), topics.end(), [topic](const DescribedTopic& other) {
    return other.access == Access::write && other.name == topic;
  });
}

PluginDescription probe_plugin(const PluginEntry& entry, const std::filesystem::path& configuration,
                               const ProbeOptions& options) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) {
    throw PluginError(fmt::format("no pipe for a probe: {}", std::strerror(errno)));
  }
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    describe_and_exit(entry, configuration, options, ends[1]);
  }
  close(ends[1]);
  if (child < 0) {
    close(ends[0]);
    throw PluginError(fmt::format("no process for a probe: {}", std::strerror(errno)));
  }
  std::string bytes;
  const bool ended = read_all(ends[0], options.patience, bytes);
  close(ends[0]);
  if (!ended) {
    kill(child, SIGKILL);
  }
  const int status = wait_for(child);
  if (!ended) {
    throw PluginError(
        fmt::format("{}: its constructor did not end within {} ms. Look for a loop or a lock in it",
                    entry.library, options.patience.count()));
  }
  if (WIFSIGNALED(status)) {
    throw PluginError(
        fmt::format("{}: crashed while it was constructed and destroyed ({}). Run it in a debugger",
                    entry.library, strsignal(WTERMSIG(status))));
  }
  TextReader in(bytes);
  if (in.next() != kDescription) {
    throw PluginError(in.next());
  }
  return read_description(in);
}

PluginDescription probe_plugin(const std::filesystem::path& library, const ProbeOptions& options) {
  const std::filesystem::path file = std::filesystem::absolute(library);
  return probe_plugin({.name = file.filename().string(), .library = file.string()}, file, options);
}

bool is_plugin_library(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(in), {}};
  return bytes.starts_with(
             "\x7f"
             "ELF") &&
         bytes.find(std::string("\0gaitway_plugin_entry\0", 22)) != std::string::npos;
}

}  // namespace gaitway::core
