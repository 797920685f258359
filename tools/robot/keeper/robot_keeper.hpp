// One supervisor for the whole robot: starts its parts in their order, watches that each makes progress,
// starts again what ends or hangs, says why, and takes the robot down in good order.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "gaitway/process/file_descriptor.hpp"
#include "tools/robot/keeper/event_log.hpp"
#include "tools/robot/keeper/page_probe.hpp"
#include "tools/robot/keeper/part_process.hpp"
#include "tools/robot/keeper/part_watch.hpp"
#include "tools/robot/keeper/robot_plan.hpp"
#include "tools/robot/keeper/robot_status.hpp"
#include "tools/robot/keeper/robot_view.hpp"
#include "tools/robot/keeper/service_notice.hpp"

namespace gaitway::tools {

// Held by the one supervisor of a folder as long as it lives.
class SupervisorLock {
 public:
  // Throws std::invalid_argument that names the supervisor that has it.
  explicit SupervisorLock(const std::filesystem::path& folder);
  // The process that has it; 0: nobody.
  [[nodiscard]] static pid_t holder(const std::filesystem::path& folder);

 private:
  process::FileDescriptor lock_;
};

using Tell = std::function<void(const std::string& text)>;

// Ends parts in the reverse of this order: what plans first, and what plays only once the robot stands.
// False: one of them had to be killed.
bool end_parts(const std::vector<PartPlan>& plans, std::vector<PartProcess>& processes, RobotView& view,
               const Tell& tell);

class RobotKeeper {
 public:
  struct Options {
    RobotFolders folders;
    std::string probe_address = {};  // of the interface
    int probe_port = 0;
    bool quiet = false;                   // events go to their file alone
    std::function<void()> on_ready = {};  // the robot may be commanded for the first time
  };
  RobotKeeper(std::vector<PartPlan> plans, Options options);

  // Until SIGINT or SIGTERM; then the robot is taken down. False: a part had to be killed for that. Throws
  // std::runtime_error before anything moves.
  bool run();

 private:
  struct Part {
    PartWatch watch;
    pid_t worker = 0;          // when it was last looked for
    std::uint64_t rounds = 0;  // likewise
    std::int64_t looked_ns = 0;
    std::int64_t moved_ns = 0;  // when it was last to move to new ground; 0: its next worker is not from that
    std::string start_complaint;  // that was told; it is not told again and again
  };

  void take_over();
  void round(std::int64_t now_ns);
  void look_at(std::size_t index, std::int64_t now_ns);
  void on_end(std::size_t index, const std::string& how, std::int64_t now_ns);
  void on_works(std::size_t index, std::int64_t downtime_ns, std::int64_t now_ns);
  void follow_progress(std::size_t index, std::int64_t now_ns);
  void start(std::size_t index, std::int64_t now_ns);
  void end_hung(std::size_t index);
  void look_for_worker(std::size_t index, std::int64_t now_ns);
  void follow_command(std::int64_t now_ns);
  [[nodiscard]] std::string why_not_commanded(std::int64_t now_ns);
  [[nodiscard]] std::string port_trouble(std::size_t index) const;
  void keep_house(std::int64_t now_ns);
  void wait(std::int64_t now_ns);
  [[nodiscard]] bool works(const std::string& name) const;
  [[nodiscard]] RobotStatus status(std::int64_t now_ns);
  void tell(const std::string& text);

  std::vector<PartPlan> plans_;
  Options options_;
  std::vector<PartProcess> processes_;
  std::vector<Part> parts_;
  RobotView view_;
  PageProbe probe_;
  EventFile events_;
  ServiceNotice notice_;
  std::int64_t up_ns_ = 0, kept_ns_ = 0, logs_ns_ = 0;
  bool commanded_ = false, was_ready_ = false;
  std::int64_t commanded_since_ns_ = 0, obeyed_ns_ = 0;
  std::string why_not_;            // it may not be commanded; empty: it may
  std::int64_t disturbed_ns_ = 0;  // the first end of a part since the robot could last be commanded; 0: none
  std::string disturbance_;
};

}  // namespace gaitway::tools
