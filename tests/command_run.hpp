// A command as its user meets it: what it says, what it complains of, and its exit code.
#pragma once

#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace gaitway::test {

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

struct CommandRun {
  int code = -1;  // -1: it was ended by a signal
  std::string said, complaint;
  [[nodiscard]] std::string all() const { return said + complaint; }
};

// `line` as a shell takes it.
inline CommandRun run_command(const std::string& line) {
  std::string pattern = (std::filesystem::temp_directory_path() / "gaitway-command-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot make a folder like " + pattern);
  const std::filesystem::path folder = pattern, said = folder / "said", complaint = folder / "complaint";
  const int status = std::system((line + " >'" + said.string() + "' 2>'" + complaint.string() + "'").c_str());
  const CommandRun run{WIFEXITED(status) ? WEXITSTATUS(status) : -1, text_of(said), text_of(complaint)};
  std::filesystem::remove_all(folder);
  return run;
}

}  // namespace gaitway::test
