// What a refused topic says.
#pragma once

#include <string>

#include "gaitway/msgclient/memory_block.hpp"

namespace gaitway::msgclient {

// The text of the TopicError that `action` throws, or "no error".
template <class Action>
std::string error_of(Action&& action) {
  try {
    action();
  } catch (const TopicError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace gaitway::msgclient
