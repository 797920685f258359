// The plug-in's parameters, as its configuration gives them.
#pragma once

#include <cstdint>
#include <string>

#include "gaitway/api/server_options.hpp"

namespace gaitway {
class Setup;
}

namespace gaitway::api {

struct ApiParameters {
  ServerOptions server;
  std::uint64_t recording_bytes = 0;  // a recording's size, at most
};

// Declares each of them, with its limits and what it is for. Throws SetupError.
ApiParameters declare_parameters(Setup& setup);

}  // namespace gaitway::api
