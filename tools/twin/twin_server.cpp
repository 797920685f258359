// Orders as they come, and a look a hundred times a second.
#include "tools/twin/twin_server.hpp"

#include <poll.h>

#include <array>
#include <optional>
#include <stdexcept>
#include <utility>

namespace gaitway::tools {
namespace {

using nlohmann::json;

constexpr int kLook_ms = 10;

std::string obeyed(Twin& twin, std::string_view text) {
  const json order = json::parse(text, nullptr, false);
  if (!order.is_object() || !order.contains("order") || !order.at("order").is_string()) {
    throw std::invalid_argument("an order must be a JSON object whose field `order` names it");
  }
  const std::optional<json> answer = twin.obey(order);
  if (!answer) {
    throw std::invalid_argument("order is " + order.at("order").dump() + ", but must be one of a twin's");
  }
  return answer->dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace

TwinServer::TwinServer(const TwinOptions& options, const urdf::RobotModel& robot,
                       const std::filesystem::path& socket)
    : twin_(options, robot),
      server_(
          socket,
          [](const simulation::Ticket&, const simulation::Push&) -> bool {
            throw std::invalid_argument("a real robot is not pushed");
          },
          [this](const simulation::Ticket&, std::string_view text) {
            return std::optional(obeyed(twin_, text));
          }),
      thread_([this] { run(); }) {}

TwinServer::~TwinServer() {
  ending_ = true;
  thread_.join();
}

void TwinServer::run() {
  while (!ending_) {
    std::array<pollfd, 1> wake{pollfd{server_.wake_fd(), POLLIN, 0}};
    poll(wake.data(), wake.size(), kLook_ms);
    server_.step();
    SimulationPace pace;
    {
      const std::lock_guard lock(mutex_);
      pace = pace_;
    }
    twin_.look(pace);
    std::vector<std::string> lines = twin_.take_lines();
    const std::lock_guard lock(mutex_);
    lines_.insert(lines_.end(), std::make_move_iterator(lines.begin()), std::make_move_iterator(lines.end()));
  }
}

void TwinServer::set_pace(const SimulationPace& pace) {
  const std::lock_guard lock(mutex_);
  pace_ = pace;
}

std::vector<std::string> TwinServer::take_lines() {
  const std::lock_guard lock(mutex_);
  return std::exchange(lines_, {});
}

}  // namespace gaitway::tools
