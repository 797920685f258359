// The plug-in `api`: opens all that it needs while it is constructed, then keeps the link to the user
// interface module from a thread of its own. Its steps only pass on what that thread has to report.
#include "gaitway/plugin/plugin.hpp"

#include <atomic>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "gaitway/api/link_host.hpp"
#include "gaitway/api/robot_desk.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/process/real_time.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::api {
namespace {

constexpr int kPeriod_ms = 1;

// Lines from the link's thread to the step, which alone may report.
class ReportQueue {
 public:
  void put(Severity severity, const std::string& text) {
    const std::scoped_lock lock(mutex_);
    if (lines_.size() < kCapacity) {
      lines_.push_back({severity, text});
    }
  }
  // Never waits: what cannot be had now comes in the next step.
  void pass_on(const Reporter& report) {
    const std::unique_lock lock(mutex_, std::try_to_lock);
    if (lock && !lines_.empty()) {
      report(lines_.front().severity, lines_.front().text.c_str());
      lines_.pop_front();
    }
  }

 private:
  static constexpr std::size_t kCapacity = 64;
  struct Line {
    Severity severity;
    std::string text;
  };
  std::mutex mutex_;
  std::deque<Line> lines_;
};

// Everything between the memory block and the link, in the order of its construction.
class Post {
 public:
  Post(const std::filesystem::path& memory_socket, const std::filesystem::path& robot_directory,
       const link::LinkAddress& address, ReportQueue& reports)
      : reports_(reports),
        client_(msgclient::Client::connect(memory_socket, "api")),
        robot_(urdf::load_robot(robot_directory)),
        desk_(client_, robot_,
              {.boot = link::random_boot(),
               .name = "controller of " + robot_.name,
               .narrow = address.narrow(),
               .link = {}}),
        host_(address) {
    client_.seal();
    thread_ = std::thread([this] { run(); });
  }
  Post(const Post&) = delete;
  Post& operator=(const Post&) = delete;
  ~Post() {
    stopping_ = true;
    thread_.join();
  }

 private:
  void run() {
    while (!stopping_) {
      host_.wait(kPeriod_ms);
      const std::int64_t now_ns = process::monotonic_ns();
      host_.pump(desk_.end(), now_ns);
      desk_.step(now_ns);
      host_.pump(desk_.end(), now_ns);
      if (const std::string report = host_.take_report(); !report.empty()) {
        reports_.put(Severity::info, report);
      }
    }
  }

  ReportQueue& reports_;
  msgclient::Client client_;
  urdf::RobotModel robot_;
  RobotDesk desk_;
  LinkHost host_;
  std::atomic<bool> stopping_ = false;
  std::thread thread_;
};

class Api final : public Plugin {
 public:
  explicit Api(Setup& setup) : report_(setup.reporter()) {
    const std::string address = setup.parameter(
        "link", "unix:/run/gaitway/link.sock",
        "where the user interface module connects: unix:PATH, or the line to it: serial:DEVICE:BAUD");
    // Where there is no memory block (a list of plug-ins, a check) there is nobody to speak for.
    if (!setup.memory_socket().empty()) {
      post_.emplace(setup.memory_socket(), setup.robot_directory(), link::parse_link_address(address),
                    reports_);
    }
  }
  void step(const Tick&) override { reports_.pass_on(report_); }

 private:
  Reporter report_;
  ReportQueue reports_;
  std::optional<Post> post_;
};

}  // namespace
}  // namespace gaitway::api

GAITWAY_PLUGIN(gaitway::api::Api, "api", "2.0.0",
               "The robot's side of the robot API: a narrow link to the user interface module")
