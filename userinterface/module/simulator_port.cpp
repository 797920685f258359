// Pushes as the control channel has them.
#include "gaitway/api/simulator_port.hpp"

#include <stdexcept>
#include <string>

namespace gaitway::api {

std::filesystem::path simulator_socket(std::string_view text) {
  constexpr std::string_view kUnix = "unix:";
  if (!text.starts_with(kUnix) || text.size() == kUnix.size()) {
    throw std::invalid_argument(
        "simulation '" + std::string(text) +
        "': must be unix:PATH, the socket of a simulator, as `gaitway serve` gives it");
  }
  return text.substr(kUnix.size());
}

std::uint32_t SimulatorPort::push(const LinkPush& push) {
  return client_.push({.link = push.link,
                       .force_N = push.force_N,
                       .frame = push.along_heading ? simulation::Frame::heading : simulation::Frame::world,
                       .duration_s = push.duration_s},
                      now_ns_);
}

std::optional<OrderResult> SimulatorPort::take_result() {
  auto answer = client_.take_answer();
  if (!answer) {
    return std::nullopt;
  }
  return OrderResult{answer->number, answer->accepted, answer->accepted ? "the push begins" : answer->text};
}

}  // namespace gaitway::api
