// What can go wrong between a station and its bus: the text names the path, what was tried, why it failed and
// what to do.
#pragma once

#include <stdexcept>

namespace gaitway::can {

class BusError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace gaitway::can
