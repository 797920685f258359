// Any set of CAN messages, as a JSON list that users write:
//
//   [{"name": "brake", "id": 16, "bytes": 8, "period_us": 2500, "jitter_us": 0, "deadline_us": 2500}, ...]
//
// Times may be fractions. Optional: "extended": true for a 29-bit identifier; "fifo": "engine" for messages
// that wait in one FIFO transmit queue, whose name this is.
#pragma once

#include <filesystem>
#include <vector>

#include "gaitway/can/analysis/response_time.hpp"

namespace gaitway::tools {

// In the file's order. Throws std::invalid_argument that names file, entry, field, value and rule.
[[nodiscard]] std::vector<can::AnalysedMessage> read_message_list(const std::filesystem::path& file);

}  // namespace gaitway::tools
