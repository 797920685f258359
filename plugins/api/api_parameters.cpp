// Names, units and ranges of the parameters; their defaults are those of ServerOptions and Limits.
#include "gaitway/api/api_parameters.hpp"

#include <concepts>
#include <sstream>
#include <vector>

#include "gaitway/api/limit_table.hpp"
#include "gaitway/api/recorder.hpp"
#include "gaitway/plugin/plugin.hpp"

namespace gaitway::api {
namespace {

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) {
    const auto begin = part.find_first_not_of(' ');
    if (begin != std::string::npos) {
      parts.push_back(part.substr(begin, part.find_last_not_of(' ') - begin + 1));
    }
  }
  return parts;
}

// Declares one limit after the other; each kind of number has its own range.
struct LimitParameters {
  Setup& setup;

  void operator()(const LimitRow& row, std::size_t& count) const {
    count = static_cast<std::size_t>(
        setup.parameter(row.name, static_cast<std::int64_t>(count), "1", {1.0, 1e8, row.doc}));
  }
  void operator()(const LimitRow& row, std::int64_t& time_ns) const {
    constexpr double kSecond_ns = 1e9;
    time_ns = static_cast<std::int64_t>(kSecond_ns *
                                        setup.parameter(row.name, static_cast<double>(time_ns) / kSecond_ns,
                                                        row.unit, {0.05, 600.0, row.doc}));
  }
  void operator()(const LimitRow& row, double& number) const {
    number = setup.parameter(row.name, number, row.unit, {1e-3, 1e6, row.doc});
  }
};

}  // namespace

ApiParameters declare_parameters(Setup& setup) {
  ApiParameters parameters;
  ServerOptions& server = parameters.server;
  server.address =
      setup.parameter("address", server.address, "to listen on; not loopback: with TLS and token");
  server.port = static_cast<std::uint16_t>(setup.parameter("port", static_cast<std::int64_t>(server.port),
                                                           "1", {0.0, 65535.0, "TCP port; 0: any free one"}));
  server.origins = split(setup.parameter("origins", "", "web origins that may connect, with commas between"));
  server.token_file = setup.parameter("token_file", "", "file with the token that clients must know");
  server.certificate_file = setup.parameter("certificate_file", "", "certificate chain (PEM)");
  server.key_file = setup.parameter("key_file", "", "its private key (PEM)");
  parameters.recording_bytes = static_cast<std::uint64_t>(
      setup.parameter("recording_bytes", static_cast<std::int64_t>(kRecordingLimit_bytes), "1",
                      {1e6, 1e12, "a recording's size, at most"}));
  visit_limits(server.limits, LimitParameters{setup});
  return parameters;
}

}  // namespace gaitway::api
