// Stands in for gaitway_plugin_child: says to the manager what the file in GAITWAY_TEST_SCRIPT tells, one
// word a line and in that order, whatever is asked. Words: the names below, `hear` (waits for one message),
// `stay` (until the manager goes), `hang up` (closes its end, and lives on), and `ask N` (N questions in a
// row, without hearing the answers). `REAL child` as the first line: is that program instead, and the next
// time the rest.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "isolation/child_program.hpp"
#include "isolation/messages.hpp"

namespace {

using gaitway::core::ChildMessage;
using gaitway::core::PacketWriter;

constexpr std::array<std::pair<std::string_view, ChildMessage>, 8> kWords{
    {{"open_topic", ChildMessage::open_topic},
     {"parameter", ChildMessage::parameter},
     {"set_period", ChildMessage::set_period},
     {"report", ChildMessage::report},
     {"created", ChildMessage::created},
     {"library_failed", ChildMessage::library_failed},
     {"constructor_failed", ChildMessage::constructor_failed},
     {"attached", ChildMessage::attached}}};

PacketWriter message(const std::string& word) {
  const auto* const found =
      std::find_if(kWords.begin(), kWords.end(), [&](const auto& known) { return known.first == word; });
  if (found == kWords.end()) {
    return PacketWriter(static_cast<ChildMessage>(std::strtoul(word.c_str(), nullptr, 10)));
  }
  PacketWriter packet(found->second);
  switch (found->second) {
    case ChildMessage::open_topic:
      packet.text("topic").text("Type").number(std::uint64_t{1}).number(8U).number(GAITWAY_WRITE).number(0U);
      break;
    case ChildMessage::parameter:
      packet.text("gain").text("1").text("").value({GAITWAY_NUMBER, 0, 1.0, 0, nullptr});
      packet.number(0.0).number(2.0).number(0U);
      break;
    case ChildMessage::set_period:
      packet.number(GAITWAY_EVERY_TICK);
      break;
    case ChildMessage::report:
      packet.number(GAITWAY_INFO).text("says something");
      break;
    case ChildMessage::created:
      packet.text("it").text("1.0.0").text("Says what it is told").text("/it.so");
      break;
    case ChildMessage::library_failed:
    case ChildMessage::constructor_failed:
      packet.text("fails as it was told");
      break;
    default:
      break;
  }
  return packet;
}

}  // namespace

int main(int, char** argv) {
  using namespace gaitway;
  const std::string script = std::getenv("GAITWAY_TEST_SCRIPT");
  std::vector<std::string> words;
  {
    std::ifstream in(script);
    for (std::string word; std::getline(in, word);) {
      words.push_back(word);
    }
  }
  if (!words.empty() && words.front().starts_with("REAL ")) {
    std::ofstream out(script);
    std::for_each(words.begin() + 1, words.end(), [&](const std::string& word) { out << word << '\n'; });
    out.close();
    execv(words.front().c_str() + 5, argv);
    return 1;
  }
  process::FileDescriptor socket(core::kChildSocket);
  std::vector<std::byte> heard;
  for (const std::string& word : words) {
    if (word == "hear") {
      core::receive_packet(socket, heard, core::Wait::yes);
    } else if (word == "stay") {
      while (core::receive_packet(socket, heard, core::Wait::yes) == core::Receipt::packet) {
      }
    } else if (word == "hang up") {
      socket = gaitway::process::FileDescriptor();
      while (true) {
        pause();
      }
    } else if (word.starts_with("ask ")) {
      for (long i = std::strtol(word.c_str() + 4, nullptr, 10); i > 0; --i) {
        core::send_packet(socket, message("set_period").bytes(), core::Wait::yes);
      }
    } else {
      core::send_packet(socket, message(word).bytes(), core::Wait::yes);
    }
  }
  return 0;
}
