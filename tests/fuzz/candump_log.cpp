// Logs in candump's format, as users hand them to the replay (can/candump_log.hpp). Whatever the text:
// - a line is taken or refused with std::invalid_argument, a whole log with std::runtime_error,
// - a line that is taken is what its frame and time are written as, but for the interface's name, the case of
//   the digits, zeros in front of the seconds and the zero of a remote frame that asks for nothing,
// - a log that is taken and written again is read as the same frames.
#include "gaitway/can/candump_log.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "fuzz_input.hpp"
#include "memory_file.hpp"

namespace gaitway::fuzz {
namespace {

using can::LoggedFrame;

// A log may also hold what an interface reports about errors, where the reader knows that.
template <class Writer, class Logged>
void write(Writer& writer, const Logged& logged) {
  if constexpr (requires { logged.error; }) {
    if (logged.error) {
      writer.write_error(logged.time_ns, logged.frame.id, logged.frame.data);
      return;
    }
  }
  writer.write(logged.time_ns, logged.frame);
}

bool same(const LoggedFrame& one, const LoggedFrame& other) {
  return one.time_ns == other.time_ns && one.frame == other.frame;
}

std::optional<std::vector<LoggedFrame>> read(const MemoryFile& file) {
  try {
    return can::read_candump_log(file.path());
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

// "(0012.000001) vcan1 0aF#1a" becomes "12.000001 0AF#1A".
std::string without_choices(std::string_view line) {
  const std::size_t close = line.find(") "), interface = close + 2;
  std::string text(line.substr(1, close - 1));
  text.erase(0, std::min(text.find_first_not_of('0'), text.find('.') - 1));
  text += line.substr(line.find(' ', interface));
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char character) { return static_cast<char>(std::toupper(character)); });
  if (text.size() >= 3 && text.substr(text.size() - 3) == "#R0") {
    text.pop_back();
  }
  return text;
}

std::string written(const LoggedFrame& logged) {
  const MemoryFile file;
  can::CandumpWriter writer(file.path());
  write(writer, logged);
  writer.close();
  std::ifstream stream(file.path());
  std::string line;
  std::getline(stream, line);
  return line;
}

void check_line(std::string_view line) {
  std::optional<LoggedFrame> logged;
  try {
    logged = can::parse_candump_line(line);
  } catch (const std::invalid_argument&) {
    return;
  }
  require(logged->time_ns >= 0, "no time before zero");
  require(can::is_valid(logged->frame), "only frames that exist are read");
  require(without_choices(line) == without_choices(written(*logged)), "a line says what was read from it");
}

}  // namespace

void candump_log(std::span<const std::uint8_t> bytes) {
  const std::string_view text = Input(bytes).rest_as_text();
  check_line(text.substr(0, text.find('\n')));
  const auto frames = read(MemoryFile(text));
  if (!frames) {
    return;
  }
  const MemoryFile copy;
  can::CandumpWriter writer(copy.path());
  for (const LoggedFrame& logged : *frames) {
    write(writer, logged);
  }
  writer.close();
  const auto again = read(copy);
  require(again && std::equal(frames->begin(), frames->end(), again->begin(), again->end(), same),
          "a log that is written again is the same");
}

}  // namespace gaitway::fuzz
