// `gaitway motion adapt`: one robot's motion for another body, planned, checked and written into its folder.
#pragma once

#include <filesystem>

namespace gaitway::tools {

struct AdaptOptions {
  std::filesystem::path motion;  // its file
  std::filesystem::path from;    // folder of the robot that it was made for
  std::filesystem::path robot;   // folder of the robot that shall play it
  std::filesystem::path out;     // folder for NAME.yaml and NAME.motion
  bool force = false;            // these two may be there already, and are replaced
};

// As large as the limits of the other robot let it be. Prints what was changed. Throws what reading, adapting
// or planning throws, and std::invalid_argument if a file is there already and `force` is not given;
// nothing is written then.
void adapt_motion_file(const AdaptOptions& options);

}  // namespace gaitway::tools
