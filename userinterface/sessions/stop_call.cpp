// A search for the word first, then a look at the message's head.
#include "stop_call.hpp"

#include <cstddef>
#include <exception>

#include "gaitway/api/service_table.hpp"
#include "message_head.hpp"

namespace gaitway::api {

Urgency urgency_of_service(std::string_view service) noexcept {
  const ServiceRow* const row = find_service(service);
  if (row == nullptr) {
    return Urgency::none;
  }
  return row->name == "/emergency_stop" ? Urgency::emergency
         : row->name == "/stop"         ? Urgency::urgent
                                        : Urgency::none;
}

Urgency urgency_of_stop_call(std::string_view message) noexcept {
  constexpr std::size_t kMostStopBytes = 1024;
  if (message.size() > kMostStopBytes || message.find("stop") == std::string_view::npos) {
    return Urgency::none;
  }
  try {
    const auto head = head_of(message);
    return head && head->op == "call_service" ? urgency_of_service(head->service) : Urgency::none;
  } catch (const std::exception&) {
    return Urgency::none;  // no memory
  }
}

}  // namespace gaitway::api
