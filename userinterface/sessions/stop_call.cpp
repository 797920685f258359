// A search for the word first, then a look at the message's head.
#include "stop_call.hpp"

#include <cstddef>
#include <exception>

#include "gaitway/api/service_table.hpp"
#include "message_head.hpp"

namespace gaitway::api {

bool is_stop_service(std::string_view service) noexcept {
  const ServiceRow* const row = find_service(service);
  return row != nullptr && (row->name == "/stop" || row->name == "/emergency_stop");
}

bool is_stop_call(std::string_view message) noexcept {
  constexpr std::size_t kMostStopBytes = 1024;
  if (message.size() > kMostStopBytes || message.find("stop") == std::string_view::npos) {
    return false;
  }
  try {
    const auto head = head_of(message);
    return head && head->op == "call_service" && is_stop_service(head->service);
  } catch (const std::exception&) {
    return false;  // no memory
  }
}

}  // namespace gaitway::api
