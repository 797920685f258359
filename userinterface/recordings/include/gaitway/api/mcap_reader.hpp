// Reads the messages of MCAP files (mcap.dev/spec, version 0) without compression, from front to back: also
// those of a file that a killed writer has left without its end.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace gaitway::api {

struct McapMessage {
  std::string_view topic, type;  // "/joint_states", "sensor_msgs/msg/JointState"
  std::string_view encoding;     // "cdr"
  std::string_view data;
  std::uint64_t log_ns = 0;
};

// `take` gets the messages in the file's order; its texts hold until it returns. Returns whether the file has
// its end. Throws input::InputError that names the file and what is wrong: no MCAP file, a chunk that is
// compressed or whose CRC differs, a record that is longer than what holds it (in the file itself that is its
// end), a message on a channel that was not described. What is thrown by `take` goes through.
bool read_mcap(const std::filesystem::path& file, const std::function<void(const McapMessage&)>& take);

}  // namespace gaitway::api
