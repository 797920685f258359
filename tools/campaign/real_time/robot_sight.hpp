// Looks at a running robot from beside it: into the memory block that its message controller gives out, and
// at what its supervisor has written down.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "tools/campaign/real_time/recovery_watch.hpp"
#include "tools/robot/keeper/robot_status.hpp"

namespace gaitway::tools {

// Whether every part is there and makes progress, as far as the supervisor has seen by now. Its own silence
// counts as none.
[[nodiscard]] bool parts_work(const RobotStatus& status, std::int64_t now_ns);

class RobotEye {
 public:
  explicit RobotEye(std::filesystem::path folder);
  ~RobotEye();
  RobotEye(const RobotEye&) = delete;
  RobotEye& operator=(const RobotEye&) = delete;

  [[nodiscard]] RobotSight look();
  // The newest that the supervisor has written; none: there is none yet.
  [[nodiscard]] const std::optional<RobotStatus>& status() const noexcept { return status_; }

 private:
  struct Block;
  void look_into_block(RobotSight& sight);
  std::filesystem::path folder_;
  std::unique_ptr<Block> block_;
  std::optional<RobotStatus> status_;
  bool one_is_stopped_ = false;
  std::int64_t status_read_ns_ = 0, reported_ns_ = 0;
};

}  // namespace gaitway::tools
