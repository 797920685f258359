// The network as a .dbc file, which cantools, SavvyCAN and other bus tools read to decode frames.
#pragma once

#include <string>

#include "tools/bus/network_description.hpp"

namespace gaitway::tools {

// Deterministic. Names longer than the format's 32 characters are cut and given whole in the attribute that
// tools know for it. Times: GenMsgCycleTime for periodic messages; messages on events have GenMsgSendType
// "event" and their smallest distance in GenMsgDelayTime, both in milliseconds; GaitwayDeadline in
// microseconds.
[[nodiscard]] std::string dbc_text(const NetworkDescription& network);

}  // namespace gaitway::tools
