// Why plug-ins could not be loaded, put in order or activated.
#pragma once

#include <stdexcept>

namespace gaitway::core {

// Names the plug-in, the place in the configuration, what was found, the rule and the remedy. Thrown during
// set-up only.
class PluginError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace gaitway::core
