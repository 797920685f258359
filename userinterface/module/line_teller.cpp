// A pipe, a socket or a terminal that says it can be written to takes a page at once.
#include "gaitway/api/line_teller.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>

#include "gaitway/input/text.hpp"

namespace gaitway::api {

void LineTeller::tell(std::string_view line) {
  const std::scoped_lock lock(mutex_);
  if (left_out_ != 0 && put(fmt::format("{} lines could not be told", left_out_))) {
    left_out_ = 0;
  }
  if (left_out_ != 0 || !put(std::string(line))) {
    ++left_out_;
  }
}

bool LineTeller::put(std::string text) const {
  pollfd can_take{descriptor_, POLLOUT, 0};
  if (poll(&can_take, 1, 0) != 1 || (can_take.revents & POLLOUT) == 0) {
    return false;
  }
  text = fmt::format("{}: {}", program_, input::terminal_text(text));
  text.resize(std::min(text.size(), kMostBytes - 1));
  text += '\n';
  return write(descriptor_, text.data(), text.size()) == static_cast<ssize_t>(text.size());
}

}  // namespace gaitway::api
