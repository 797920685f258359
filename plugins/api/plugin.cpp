// The plug-in `api`: opens all that it needs while it is constructed, then serves from a thread of its own.
// Its steps only pass on what that thread has to report.
#include "gaitway/plugin/plugin.hpp"

#include <fmt/format.h>

#include <deque>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "gaitway/api/api_parameters.hpp"
#include "gaitway/api/feed.hpp"
#include "gaitway/api/hub.hpp"
#include "gaitway/api/memory_robot_port.hpp"
#include "gaitway/api/recorder.hpp"
#include "gaitway/api/server.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::api {
namespace {

// Lines from the network's thread to the step, which alone may report.
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

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Everything between the memory block and the sockets, in the order of its construction.
class Door {
 public:
  Door(const std::filesystem::path& memory_socket, const std::filesystem::path& robot_directory,
       const std::filesystem::path& recordings, const ApiParameters& parameters, ReportQueue& reports)
      : reports_(reports),
        robot_(urdf::load_robot(robot_directory)),
        client_(msgclient::Client::connect(memory_socket, "api")),
        recorder_(recordings.empty() ? nullptr
                                     : std::make_unique<Recorder>(recordings, parameters.recording_bytes)),
        port_(client_, robot_, recorder_.get()),
        feed_(client_, robot_),
        setup_(parameters.server),
        url_(setup_.url()),
        hub_(port_, hub_options(parameters.server.limits, setup_, robot_directory)),
        server_(hub_, std::move(setup_),
                {.on_tick = [this](std::int64_t wall_ns) { on_tick(wall_ns); },
                 .on_poll = [this](std::int64_t wall_ns) { on_poll(wall_ns); }}) {
    client_.seal();
    thread_ = std::thread([this] { server_.run(); });
    reports_.put(Severity::info, fmt::format("serves {}", url_));
  }
  Door(const Door&) = delete;
  Door& operator=(const Door&) = delete;
  ~Door() {
    server_.stop();
    thread_.join();
  }

 private:
  static HubOptions hub_options(const Limits& limits, const ServerSetup& setup,
                                const std::filesystem::path& robot_directory) {
    HubOptions options;
    options.limits = limits;
    options.parameters["robot_description"] = read_text(robot_directory / "robot.urdf");
    if (setup.token()) {
      options.is_token = [token = *setup.token()](std::string_view offered) {
        return token.matches(offered);
      };
    }
    return options;
  }
  void on_poll(std::int64_t wall_ns) {
    port_.observe(wall_ns);
    hub_.answer(wall_ns);
    GenericSink sink([this](Topic topic) { return hub_.wanted(topic) || records(topic); },
                     [this](Topic topic, const auto& message, std::int64_t robot_ns) {
                       hub_.publish(topic, message);
                       if (records(topic)) {
                         recorder_->publish(topic, message, robot_ns);
                       }
                     });
    feed_.poll(wall_ns, sink);
  }
  void on_tick(std::int64_t wall_ns) {
    if (recorder_ == nullptr) {
      return;
    }
    recorder_->step(wall_ns);
    if (const auto news = recorder_->take_report()) {
      reports_.put(Severity::warning, *news);
    }
  }
  [[nodiscard]] bool records(Topic topic) const { return recorder_ != nullptr && recorder_->wants(topic); }

  ReportQueue& reports_;
  urdf::RobotModel robot_;
  msgclient::Client client_;
  std::unique_ptr<Recorder> recorder_;
  MemoryRobotPort port_;
  Feed feed_;
  ServerSetup setup_;
  std::string url_;
  Hub hub_;
  Server server_;
  std::thread thread_;
};

class Api final : public Plugin {
 public:
  explicit Api(Setup& setup) : report_(setup.reporter()) {
    const ApiParameters parameters = declare_parameters(setup);
    // Where there is no memory block (a list of plug-ins, a check) there is nothing to serve.
    if (!setup.memory_socket().empty()) {
      door_.emplace(setup.memory_socket(), setup.robot_directory(), setup.write_folder(), parameters,
                    reports_);
    }
  }
  void step(const Tick&) override { reports_.pass_on(report_); }

 private:
  Reporter report_;
  ReportQueue reports_;
  std::optional<Door> door_;
};

}  // namespace
}  // namespace gaitway::api

GAITWAY_PLUGIN(gaitway::api::Api, "api", "1.0.0", "The robot API: rosbridge v2 over WebSocket")
