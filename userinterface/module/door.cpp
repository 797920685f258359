// The module's parts, in the order of their construction.
#include "gaitway/api/door.hpp"

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "gaitway/api/feed.hpp"
#include "gaitway/api/hub.hpp"
#include "gaitway/api/link_robot_port.hpp"
#include "gaitway/api/link_thread.hpp"
#include "gaitway/api/link_watch.hpp"
#include "gaitway/api/module_link.hpp"
#include "gaitway/api/publication_sink.hpp"
#include "gaitway/api/recorder.hpp"
#include "gaitway/api/server.hpp"
#include "gaitway/api/simulator_port.hpp"
#include "gaitway/api/stop_post.hpp"
#include "gaitway/api/view_hub.hpp"
#include "gaitway/api/view_source.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/page/asset_table.hpp"
#include "gaitway/page/bus_assets.hpp"
#include "gaitway/page/calibration_assets.hpp"
#include "gaitway/page/motion_assets.hpp"
#include "gaitway/page/robot_assets.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/urdf/description_text.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::api {
namespace {

std::unique_ptr<Recorder> recorder_of(const DoorOptions& options) {
  if (options.recordings.empty()) {
    return nullptr;
  }
  std::error_code reason;
  std::filesystem::create_directories(options.recordings, reason);
  if (reason) {
    throw std::runtime_error("--recordings '" + options.recordings.string() +
                             "': the folder cannot be made: " + reason.message() +
                             "; correct the path, or its rights");
  }
  return std::make_unique<Recorder>(options.recordings,
                                    RecorderOptions{.limits = {.file_bytes = options.recording_bytes}});
}

std::function<bool(std::string_view)> token_check(const ServerSetup& setup) {
  if (!setup.token()) {
    return {};
  }
  return [token = *setup.token()](std::string_view offered) { return token.matches(offered); };
}

std::unique_ptr<SimulatorPort> port_at(const std::filesystem::path& socket) {
  return socket.empty() ? nullptr : std::make_unique<SimulatorPort>(socket);
}

HubOptions hub_options(const DoorOptions& options, const ServerSetup& setup,
                       const SimulationPorts& simulation) {
  HubOptions result;
  result.simulation = simulation;
  result.limits = options.server.limits;
  result.parameters["robot_description"] = urdf::description_text(options.robot / "robot.urdf");
  result.is_token = token_check(setup);
  return result;
}

// Nothing: it is not wanted.
std::optional<stopgram::StopSocket> stop_socket(const DoorOptions& options, std::uint16_t server_port) {
  const int port = options.stop_port ? *options.stop_port : server_port + 1;
  if (port == 0) {
    return std::nullopt;
  }
  if (port > std::numeric_limits<std::uint16_t>::max()) {
    throw stopgram::StopSocketError("the server has the last port, " + std::to_string(server_port) +
                                    ", and stops would have the one after it: give them another by "
                                    "--stop-port (0: none)");
  }
  return stopgram::StopSocket(options.server.address, static_cast<std::uint16_t>(port));
}

stopgram::StopKey stop_key(const ServerOptions& server) {
  if (server.token_file.empty()) {
    return stopgram::StopKey();
  }
  std::string token = read_token(server.token_file);
  stopgram::StopKey key(token);
  explicit_bzero(token.data(), token.size());
  return key;
}

page::PushBounds push_bounds(const urdf::RobotModel& robot) {
  using namespace simulation;
  constexpr double kUsualShareOfWeight = 0.3;  // a push of a tenth of a second that a robot that stands bears
  const double weight_N = robot.total_mass_kg() * facts::kGravity_m_per_s2;
  return {.least_N = kLeastForce_N,
          .most_N = kLargestForce_N,
          .usual_N = std::clamp(std::round(kUsualShareOfWeight * weight_N), 1.0, kLargestForce_N),
          .shortest_s = kShortestPush_s,
          .longest_s = kLongestPush_s};
}

page::AssetTable assets_of(const urdf::RobotModel& robot, const Limits& limits, bool simulated) {
  constexpr double kSecond_ns = 1e9;
  page::AssetTable assets;
  page::add_page(assets);
  page::add_robot(assets, robot,
                  {.forward_m_per_s = limits.forward_m_per_s,
                   .turn_rad_per_s = limits.turn_rad_per_s,
                   .velocity_holds_s = static_cast<double>(limits.velocity_ns) / kSecond_ns,
                   .lease_s = static_cast<double>(limits.lease_ns) / kSecond_ns,
                   .push = simulated ? std::optional(push_bounds(robot)) : std::nullopt});
  page::add_bus(assets, robot);
  page::add_calibration(assets, robot);
  page::add_motions(assets, robot, process::prepared_motion_directories(robot.directory));
  return assets;
}

std::optional<CertificateWatch> certificate_watch(const ServerSetup& setup) {
  const auto& term = setup.certificate_term();
  return term ? std::optional<CertificateWatch>(*term) : std::nullopt;
}

constexpr std::uint8_t kWarning = 30;  // of ros::Log

}  // namespace

class Door::Impl {
 public:
  Impl(const DoorOptions& options, std::function<void(const std::string&)> tell)
      : tell_(std::move(tell)),
        robot_(msgcontroller::load_robot(options.robot, options.profile)),
        setup_(options.server),
        url_(setup_.url()),
        stop_socket_(stop_socket(options, setup_.port())),
        link_(robot_, {.boot = link::random_boot(), .name = "user_interface " + std::to_string(getpid())}),
        link_address_(link::text_of(options.link)),
        topics_(link_.topics("feed")),
        recorder_(recorder_of(options)),
        port_(link_, robot_, recorder_.get()),
        feed_(topics_, robot_),
        view_source_(topics_, robot_),
        simulation_(port_at(options.simulation)),
        twin_(port_at(options.twin)),
        assets_(assets_of(robot_, options.server.limits, simulation_ != nullptr)),
        hub_(port_, hub_options(options, setup_, {simulation_.get(), twin_.get()})),
        view_hub_(
            {.is_token = token_check(setup_), .authentication_ns = options.server.limits.authentication_ns}),
        certificate_(certificate_watch(setup_)),
        server_(hub_, std::move(setup_),
                {.on_tick = [this](std::int64_t now_ns) { on_tick(now_ns); },
                 .on_poll = [this](std::int64_t now_ns) { on_poll(now_ns); },
                 .on_refusals = tell_},
                {.assets = &assets_, .view = &view_hub_, .version = page::page_version()}),
        link_thread_(link_, options.link, tell_) {
    if (stop_socket_) {
      stop_url_ = "udp" + url_.substr(url_.find(':'), url_.rfind(':') - url_.find(':') + 1) +
                  std::to_string(stop_socket_->port());
      stop_post_.emplace(link_, std::move(*stop_socket_), stop_key(options.server));
    }
  }

  void run() {
    tell_(stop_post_ ? "listens for stops by datagram at " + stop_url_
                     : "takes no stops by datagram (--stop-port 0)");
    server_.run();
  }
  void stop() { server_.stop(); }
  [[nodiscard]] const std::string& url() const noexcept { return url_; }

 private:
  void on_poll(std::int64_t now_ns) {
    port_.observe(now_ns);
    follow_session();
    const std::optional<PostedStops> stops = stop_post_ ? stop_post_->take_stops() : std::nullopt;
    if (stops) {
      link_.see_stops(stops->count);
      hub_.stopped_by_datagram();
    }
    for (SimulatorPort* const port : {simulation_.get(), twin_.get()}) {
      if (port != nullptr) port->step(now_ns);
    }
    hub_.answer(now_ns);
    tell_address(now_ns);
    GenericSink sink(
        [this](Topic topic) {
          return hub_.wanted(topic) || records(topic) || (view_hub_.watched() && ViewSource::wants(topic));
        },
        [this, now_ns](Topic topic, const auto& message, std::int64_t robot_ns) {
          view_source_.take(topic, message, now_ns);
          hub_.publish(topic, message);
          if (records(topic)) {
            recorder_->publish(topic, message, robot_ns);
          }
        });
    feed_.poll(now_ns, sink);
    tell_simulation(sink);
    tell_walk_command(sink);
    tell_commander(sink);
    tell_link_state(now_ns, sink);
    tell_certificate(sink);
    if (stops) {
      tell_stops(*stops, sink);
    }
    if (view_hub_.due(now_ns)) {
      view_hub_.show(view_source_.state(feed_.robot_ns(), feed_.heartbeat_age_ns(), hub_.commander(), now_ns),
                     now_ns);
    }
  }
  // Whoever commanded takes the command again when the link is back.
  void follow_session() {
    const std::uint32_t session = link_.session();
    if (std::exchange(session_, session) != session) {
      hub_.robot_lost();
    }
  }
  // When there is a robot to be shown, or after a while without.
  void tell_address(std::int64_t now_ns) {
    constexpr std::int64_t kPatience_ns = facts::kSecond_ns;
    began_ns_ = began_ns_ == 0 ? now_ns : began_ns_;
    const bool shows = port_.connected() && !port_.plugins().empty();
    if (!address_told_ && (shows || now_ns - began_ns_ >= kPatience_ns)) {
      address_told_ = true;
      tell_("serves " + url_ + ", and the page at http" + url_.substr(2));
    }
  }
  void tell_simulation(PublicationSink& sink) {
    if (const auto state = hub_.take_simulation_state()) {
      sink.publish(Topic::simulation_state, *state, feed_.robot_ns());
    }
    if (const auto twin = hub_.take_twin_state()) {
      sink.publish(Topic::twin_state, *twin, feed_.robot_ns());
    }
  }
  void tell_walk_command(PublicationSink& sink) {
    const auto velocity = hub_.take_walk_command();
    if (!velocity && walk_command_told_) {
      return;
    }
    walk_command_told_ = true;
    const Velocity told = velocity.value_or(Velocity{});
    ros::TwistStamped message;
    message.header.stamp = ros_time(feed_.robot_ns());
    message.twist.linear = {told.forward_m_per_s, told.left_m_per_s, 0.0};
    message.twist.angular.z = told.turn_rad_per_s;
    sink.publish(Topic::walk_command, message, feed_.robot_ns());
  }
  void tell_commander(PublicationSink& sink) {
    if (commander_ && commander_->data == hub_.commander()) {
      return;
    }
    commander_ = ros::String{std::string(hub_.commander())};
    sink.publish(Topic::commander, *commander_, feed_.robot_ns());
  }
  void tell_link_state(std::int64_t now_ns, PublicationSink& sink) {
    const LinkReport report = link_thread_.report();
    const bool news = !link_told_ || report.state != link_told_->state || report.text != link_told_->text;
    const bool goes_on = report.state != LinkReport::State::up && now_ns - link_told_ns_ >= facts::kSecond_ns;
    if (news || goes_on) {
      sink.publish(Topic::link_state, link_state_of(report, link_address_, now_ns), feed_.robot_ns());
      link_told_ = report;
      link_told_ns_ = now_ns;
    }
  }
  void tell_certificate(PublicationSink& sink) {
    const std::string trouble = certificate_ ? certificate_->trouble() : std::string();
    if (!certificate_told_ || certificate_told_->data != trouble) {
      certificate_told_ = ros::String{trouble};
      sink.publish(Topic::certificate_state, *certificate_told_, feed_.robot_ns());
    }
    if (certificate_news_) {
      tell_event(kWarning, *std::exchange(certificate_news_, std::nullopt), sink);
    }
  }
  void tell_event(std::uint8_t level, const std::string& text, PublicationSink& sink) {
    ros::Log event;
    event.stamp = ros_time(feed_.robot_ns());
    event.level = level;
    event.name = "user_interface";
    event.msg = text;
    tell_(event.msg);
    feed_.tell(event, sink);
  }
  void tell_stops(const PostedStops& stops, PublicationSink& sink) {
    tell_event(ros::Log().level, text_of(stops), sink);
  }
  void on_tick(std::int64_t now_ns) {
    if (certificate_) {
      if (auto news = certificate_->look(std::time(nullptr), server_.statistics().of(Refusal::tls))) {
        certificate_news_ = std::move(news);
      }
    }
    if (stop_post_) {
      for (const std::string& line : stop_post_->take_refusals()) {
        tell_(line);
      }
    }
    if (recorder_ == nullptr) {
      return;
    }
    recorder_->step(now_ns);
    if (const auto news = recorder_->take_report()) {
      tell_(*news);
    }
  }
  [[nodiscard]] bool records(Topic topic) const { return recorder_ != nullptr && recorder_->wants(topic); }

  std::function<void(const std::string&)> tell_;
  urdf::RobotModel robot_;
  ServerSetup setup_;
  std::string url_, stop_url_;
  std::optional<stopgram::StopSocket> stop_socket_;  // until the post has it
  ModuleLink link_;
  std::string link_address_;
  msgclient::Client topics_;
  std::unique_ptr<Recorder> recorder_;
  LinkRobotPort port_;
  Feed feed_;
  ViewSource view_source_;
  std::unique_ptr<SimulatorPort> simulation_;  // nullptr: the robot is no simulation
  std::unique_ptr<SimulatorPort> twin_;        // nullptr: the simulation is the twin of no robot
  page::AssetTable assets_;
  Hub hub_;
  bool walk_command_told_ = false;
  std::optional<ros::String> commander_;  // as told last
  std::uint32_t session_ = 0;             // of the link, as last seen
  std::optional<LinkReport> link_told_;
  std::int64_t link_told_ns_ = 0;
  std::optional<ros::String> certificate_told_;
  std::optional<std::string> certificate_news_;  // to be told
  std::int64_t began_ns_ = 0;                    // to serve
  bool address_told_ = false;
  ViewHub view_hub_;
  std::optional<CertificateWatch> certificate_;  // nothing: no TLS
  Server server_;
  LinkThread link_thread_;
  std::optional<StopPost> stop_post_;
};

Door::Door(const DoorOptions& options, std::function<void(const std::string&)> tell)
    : impl_(std::make_unique<Impl>(options, std::move(tell))) {}
Door::~Door() = default;

void Door::run() {
  impl_->run();
}
void Door::stop() {
  impl_->stop();
}
const std::string& Door::url() const noexcept {
  return impl_->url();
}

}  // namespace gaitway::api
