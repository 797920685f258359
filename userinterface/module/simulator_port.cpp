// Pushes and orders as the control channel has them.
#include "gaitway/api/simulator_port.hpp"

#include <stdexcept>
#include <string>
#include <utility>

namespace gaitway::api {

std::filesystem::path simulator_socket(std::string_view text) {
  constexpr std::string_view kUnix = "unix:";
  if (!text.starts_with(kUnix) || text.size() == kUnix.size()) {
    throw std::invalid_argument("simulation '" + std::string(text) +
                                "': must be unix:PATH, the socket of a simulator, as `gaitway simulator` and "
                                "`gaitway serve` give it");
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

std::uint32_t SimulatorPort::order(const std::string& json, std::int64_t patience_ns) {
  return client_.order(json, now_ns_, patience_ns);
}

std::optional<OrderResult> SimulatorPort::take_result() {
  auto answer = client_.take_answer();
  if (!answer) {
    return std::nullopt;
  }
  return OrderResult{answer->number, answer->accepted, std::move(answer->text)};
}

}  // namespace gaitway::api
