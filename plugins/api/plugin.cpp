// The plug-in `api`: opens all that it needs while it is constructed, then serves from a thread of its own.
// Its steps only pass on what that thread has to report.
#include "gaitway/plugin/plugin.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <deque>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "gaitway/api/feed.hpp"
#include "gaitway/api/hub.hpp"
#include "gaitway/api/limits.hpp"
#include "gaitway/api/memory_robot_port.hpp"
#include "gaitway/api/recorder.hpp"
#include "gaitway/api/server.hpp"
#include "gaitway/api/view_hub.hpp"
#include "gaitway/api/view_source.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/page/asset_table.hpp"
#include "gaitway/page/robot_assets.hpp"
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

struct ApiParameters {
  ServerOptions server;
  std::uint64_t recording_bytes = 0;  // a recording's size, at most
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
        recorder_(
            recordings.empty()
                ? nullptr
                : std::make_unique<Recorder>(
                      recordings, RecorderOptions{.limits = {.file_bytes = parameters.recording_bytes}})),
        port_(client_, robot_, recorder_.get()),
        feed_(client_, robot_),
        view_source_(client_, robot_),
        assets_(assets_of(robot_, parameters.server.limits)),
        setup_(parameters.server),
        url_(setup_.url()),
        hub_(port_, hub_options(parameters.server.limits, setup_, robot_directory)),
        view_hub_({.is_token = token_check(setup_),
                   .authentication_ns = parameters.server.limits.authentication_ns}),
        server_(hub_, std::move(setup_),
                {.on_tick = [this](std::int64_t wall_ns) { on_tick(wall_ns); },
                 .on_poll = [this](std::int64_t wall_ns) { on_poll(wall_ns); },
                 .on_refusals = [this](const std::string& line) { reports_.put(Severity::warning, line); }},
                {.assets = &assets_, .view = &view_hub_}) {
    client_.seal();
    thread_ = std::thread([this] { server_.run(); });
    reports_.put(Severity::info, fmt::format("serves {}, and the page at http{}", url_, url_.substr(2)));
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
    options.is_token = token_check(setup);
    return options;
  }
  static std::function<bool(std::string_view)> token_check(const ServerSetup& setup) {
    if (!setup.token()) {
      return {};
    }
    return [token = *setup.token()](std::string_view offered) { return token.matches(offered); };
  }
  static page::AssetTable assets_of(const urdf::RobotModel& robot, const Limits& limits) {
    constexpr double kSecond_ns = 1e9;
    page::AssetTable assets;
    page::add_page(assets);
    page::add_robot(assets, robot,
                    {.forward_m_per_s = limits.forward_m_per_s,
                     .turn_rad_per_s = limits.turn_rad_per_s,
                     .velocity_holds_s = static_cast<double>(limits.velocity_ns) / kSecond_ns,
                     .lease_s = static_cast<double>(limits.lease_ns) / kSecond_ns});
    return assets;
  }
  void on_poll(std::int64_t wall_ns) {
    port_.observe(wall_ns);
    hub_.answer(wall_ns);
    GenericSink sink(
        [this](Topic topic) {
          return hub_.wanted(topic) || records(topic) || (view_hub_.watched() && ViewSource::wants(topic));
        },
        [this, wall_ns](Topic topic, const auto& message, std::int64_t robot_ns) {
          view_source_.take(topic, message, wall_ns);
          hub_.publish(topic, message);
          if (records(topic)) {
            recorder_->publish(topic, message, robot_ns);
          }
        });
    feed_.poll(wall_ns, sink);
    tell_commander(sink);
    if (view_hub_.due(wall_ns)) {
      view_hub_.show(
          view_source_.state(feed_.robot_ns(), feed_.heartbeat_age_ns(), hub_.commander(), wall_ns), wall_ns);
    }
  }
  void tell_commander(PublicationSink& sink) {
    if (commander_ && commander_->data == hub_.commander()) {
      return;
    }
    commander_ = ros::String{std::string(hub_.commander())};
    sink.publish(Topic::commander, *commander_, feed_.robot_ns());
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
  ViewSource view_source_;
  page::AssetTable assets_;
  ServerSetup setup_;
  std::string url_;
  Hub hub_;
  std::optional<ros::String> commander_;  // as told last
  ViewHub view_hub_;
  Server server_;
  std::thread thread_;
};

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) {
    const auto begin = part.find_first_not_of(' ');
    if (begin != std::string::npos) {
      parts.push_back(part.substr(begin, part.find_last_not_of(' ') - begin + 1));
    }
  }
  return parts;
}

// Declares one limit after the other; each kind of number has its own range.
struct LimitParameters {
  Setup& setup;

  void operator()(const LimitRow& row, std::size_t& count) const {
    count = static_cast<std::size_t>(
        setup.parameter(row.name, static_cast<std::int64_t>(count), "1", {1.0, 1e9, row.doc}));
  }
  void operator()(const LimitRow& row, std::int64_t& time_ns) const {
    constexpr double kSecond_ns = 1e9;
    time_ns = static_cast<std::int64_t>(kSecond_ns *
                                        setup.parameter(row.name, static_cast<double>(time_ns) / kSecond_ns,
                                                        row.unit, {0.05, 600.0, row.doc}));
  }
  void operator()(const LimitRow& row, double& number) const {
    number = setup.parameter(row.name, number, row.unit, {1e-3, 1e6, row.doc});
  }
};

// Declares each of them, with its limits and what it is for. Throws SetupError.
ApiParameters declare_parameters(Setup& setup) {
  ApiParameters parameters;
  ServerOptions& server = parameters.server;
  server.address =
      setup.parameter("address", server.address, "to listen on; not loopback: with TLS and token");
  server.port = static_cast<std::uint16_t>(setup.parameter("port", static_cast<std::int64_t>(server.port),
                                                           "1", {0.0, 65535.0, "TCP port; 0: any free one"}));
  server.origins = split(setup.parameter(
      "origins", "",
      "web origins that may connect besides this computer's, with commas between; null: pages from files"));
  server.token_file = setup.parameter("token_file", "", "file with the token that clients must know");
  server.certificate_file = setup.parameter("certificate_file", "", "certificate chain (PEM)");
  server.key_file = setup.parameter("key_file", "", "its private key (PEM)");
  parameters.recording_bytes = static_cast<std::uint64_t>(
      setup.parameter("recording_bytes", static_cast<std::int64_t>(kRecordingLimit_bytes), "1",
                      {1e6, 1e12, "a recording's size, at most"}));
  visit_limits(server.limits, LimitParameters{setup});
  return parameters;
}

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
