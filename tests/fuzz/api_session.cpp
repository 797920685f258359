// Conversations of three clients with the robot API (userinterface/sessions: hub.hpp, session.hpp): messages,
// whole, changed or arbitrary; time, publications, answers of the robot, lost connections. Whatever comes:
// nothing throws; no more waits for a client than may; what is sent is JSON, or CBOR where a client may have
// asked for it; what clients have among themselves goes with them; the robot is told something only on behalf
// of clients that are let in; it walks only while somebody has the command; and a second client drives only
// after the robot was told to stand for the first.
#include <array>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "fuzz_input.hpp"
#include "gaitway/api/hub.hpp"
#include "gaitway/facts/facts.hpp"
#include "tests/userinterface/sessions/recorded_robot.hpp"
#include "tests/userinterface/sessions/recorded_simulation.hpp"

namespace gaitway::fuzz {
namespace {

using nlohmann::json;
using namespace api;

constexpr std::size_t kClients = 3;
using facts::kMillisecond_ns;
constexpr std::size_t kMostActions = 500;

constexpr std::array<std::string_view, 76> kMessages{
    R"({"op":"publish","topic":"/cmd_vel","msg":{"linear":{"x":0.2},"angular":{"z":0.1}}})",
    R"({"op":"publish","topic":"/cmd_vel","msg":{"linear":{"x":-1.5}}})",
    R"({"op":"publish","topic":"cmd_vel","msg":{"linear":{"z":1}}})",
    R"({"op":"advertise","id":"a","topic":"/cmd_vel","type":"geometry_msgs/Twist"})",
    R"({"op":"unadvertise","id":"a","topic":"/cmd_vel"})",
    R"({"op":"subscribe","topic":"/joint_states","queue_length":5})",
    R"({"op":"subscribe","topic":"/joint_states","compression":"cbor"})",
    R"({"op":"subscribe","id":"s","topic":"/zmp","throttle_rate":50,"fragment_size":64})",
    R"({"op":"subscribe","id":2,"topic":"/zmp","throttle_rate":100000})",
    R"({"op":"subscribe","topic":"/robot_description","fragment_size":100})",
    R"({"op":"subscribe","topic":"/events"})",
    R"({"op":"unsubscribe","topic":"/zmp"})",
    R"({"op":"unsubscribe","id":"s","topic":"/zmp"})",
    R"({"op":"unsubscribe","topic":"/joint_states"})",
    R"({"op":"call_service","id":"c","service":"/stand"})",
    R"({"op":"call_service","service":"/stop"})",
    R"({"op":"call_service","service":"/emergency_stop","args":[true]})",
    R"({"op":"call_service","service":"/move_joint","args":["neck_yaw",0.2,1]})",
    R"({"op":"call_service","service":"/play_motion","args":{"motion":"wave"}})",
    R"({"op":"call_service","service":"/walk_to","args":{"x":1.0,"y":0.5,"yaw":0.0}})",
    R"({"op":"call_service","service":"/command/take"})",
    R"({"op":"call_service","service":"/command/let_go"})",
    R"({"op":"call_service","service":"/head/look","args":{"mode":"scan","extent":0.5,"period":4}})",
    R"({"op":"call_service","service":"/head/look","args":["point",0,0,0,0,1e400]})",
    R"({"op":"call_service","service":"/behaviour/start","args":{"mission":"patrol"}})",
    R"({"op":"call_service","service":"/behaviour/end"})",
    R"({"op":"call_service","service":"/behaviour/change"})",
    R"({"op":"call_service","service":"/plugins/list","compression":"cbor"})",
    R"({"op":"call_service","service":"/plugins/reload","args":{"name":"stability"},"timeout":0.1})",
    R"({"op":"call_service","service":"/plugins/get_parameters","args":{"plugin":"stability"}})",
    R"({"op":"call_service","service":"/plugins/set_parameter","args":["stability","gain","1"]})",
    R"({"op":"call_service","service":"/recording/start","args":{"name":"walk"}})",
    R"({"op":"call_service","service":"/recording/stop"})",
    R"({"op":"call_service","service":"/command/acquire","args":{"name":"a"}})",
    R"({"op":"call_service","service":"/command/keep_alive","args":{"lease":"0123456789abcdef"}})",
    R"({"op":"call_service","service":"/command/release","args":{"lease":"LEASE"}})",
    R"({"op":"call_service","service":"/command/keep_alive","args":{"lease":"LEASE"}})",
    R"({"op":"call_service","service":"/rosapi/topics_and_raw_types","fragment_size":500})",
    R"({"op":"call_service","service":"/rosapi/set_param","args":{"name":"stability:gain","value":"2"}})",
    R"({"op":"call_service","service":"/rosapi/message_details","args":{"type":"sensor_msgs/Imu"}})",
    R"({"op":"call_service","service":"/rosapi/get_param","args":["a:b"]})",
    R"({"op":"set_level","level":"info"})",
    R"({"op":"set_level","level":"none"})",
    R"({"op":"auth","token":"secret"})",
    R"({"op":"auth","mac":"wrong"})",
    R"({"op":"fragment","id":"1","data":"{","num":0,"total":1})",
    R"({"op":"advertise_service","service":"/x","type":"y/Z"})",
    R"({"op":"advertise","id":"t","topic":"/chat","type":"a/B","latch":true})",
    R"({"op":"advertise","topic":"chat","type":"a/msg/B"})",
    R"({"op":"advertise","topic":"/chat","type":"a/C"})",
    R"({"op":"unadvertise","topic":"/chat"})",
    R"({"op":"unadvertise","id":"t","topic":"chat"})",
    R"({"op":"publish","topic":"/chat","msg":{"data":"hello"}})",
    R"({"op":"publish","topic":"/chat","type":"a/B","latch":true,"msg":{"data":[1,2.5,null,{"a":"\u00e4"}]}})",
    R"({"op":"publish","topic":"/joint_states","msg":{}})",
    R"({"op":"subscribe","topic":"/chat","type":"a/B","queue_length":2})",
    R"({"op":"subscribe","id":"c","topic":"chat","compression":"cbor"})",
    R"({"op":"subscribe","topic":"/chat","type":"a/B","throttle_rate":50,"fragment_size":64})",
    R"({"op":"unsubscribe","topic":"/chat"})",
    R"({"op":"advertise_service","service":"x","type":"a/B"})",
    R"({"op":"unadvertise_service","service":"/x"})",
    R"({"op":"call_service","id":1,"service":"/x","args":{"a":[1]}})",
    R"({"op":"call_service","service":"x","timeout":0.1,"compression":"cbor"})",
    R"({"op":"service_response","service":"/x","id":"CALL","values":{"a":1},"result":true})",
    R"({"op":"service_response","service":"/x","id":"CALL","values":"no","result":false})",
    R"({"op":"status","id":[[[[[[]]]]]]})",
    R"({"op":"call_service","service":"/simulation/push","args":{"link":"trunk","force":{"x":5},"duration":0.1}})",
    R"({"op":"call_service","service":"/simulation/seek","args":[1.5]})",
    R"({"op":"call_service","service":"/simulation/plan","args":{"x":1.0},"compression":"cbor"})",
    R"({"op":"call_service","service":"/simulation/geometry","args":{"first":1}})",
    R"({"op":"call_service","service":"/simulation/set_simulation_state","args":{"state":{"state":1}}})",
    R"({"op":"call_service","service":"/simulation/get_entities","args":{"filters":{"filter":"^(a|b)[^c]*.$"}}})",
    R"({"op":"call_service","service":"/simulation/get_entities_states","args":{"filters":{"bounds":{"type":3,"points":[{},{"x":2}]}}}})",
    R"({"op":"call_service","service":"/simulation/spawn_entity","args":{"name":"a","entity_resource":{"uri":"gaitway:box?size=1,1,1"}}})",
    R"({"op":"call_service","service":"/simulation/set_entity_state","args":{"entity":"ball","set_pose":true}})",
    R"({"op":"call_service","service":"/simulation/delete_entity","args":["crate"],"timeout":0.1})"};

Limits tight() {
  Limits limits;
  limits.waiting_bytes = 8192;
  limits.message_bytes = 2048;
  limits.depth = 8;
  limits.subscriptions = 4;
  limits.advertisements = 2;
  limits.queue_length = 8;
  limits.client_topics = 3;
  limits.kept_bytes = 256;
  limits.services = 2;
  limits.client_services = 3;
  limits.calls_of_provider = 3;
  limits.calls_of_all = 5;
  limits.messages_per_s = 50.0;
  return limits;
}

struct Peer final : Connection {
  void wake() noexcept override { awake = true; }
  void shown_wrong_token() noexcept override {}
  void close(std::uint16_t, std::string_view reason) noexcept override {
    closed = true;
    reason_fits = reason.size() <= 123;
  }
  std::unique_ptr<Session> session;
  bool awake = false, closed = false, reason_fits = true;
  bool authorised = false;  // may be, at least
  bool wants_cbor = false;
};

class Trial {
 public:
  explicit Trial(Input& input) : input_(input), wants_token_(input.flag()), hub_(robot_, options()) {
    for (Peer& peer : peers_) {
      connect(peer);
    }
  }

  void run() {
    for (std::size_t i = 0; i < kMostActions && !input_.empty(); ++i) {
      const std::size_t told = robot_.told.size();
      const bool for_client = act();
      check(told, for_client);
    }
    for (Peer& peer : peers_) {
      peer.session.reset();
    }
    require(!robot_.walking, "nothing walks on when all have gone");
    require(hub_.statistics().clients == 0, "who has gone is gone");
    require(hub_.statistics().waiting_bytes == 0, "nothing waits for, or is kept of, who has gone");
  }

 private:
  HubOptions options() {
    HubOptions options;
    options.simulation = {&simulation_, &twin_};
    options.limits = tight();
    if (wants_token_) {
      options.is_token = [](std::string_view offered) { return offered == "secret"; };
    }
    return options;
  }
  void connect(Peer& peer) {
    peer.session.reset();
    peer.closed = peer.awake = peer.wants_cbor = false;
    peer.authorised = !wants_token_;
    peer.session = hub_.open(peer, "peer", !wants_token_, now_ns_);
    require(peer.session != nullptr, "there is room for a few clients");
  }

  // True: the client `peer_` has said something.
  bool act() {
    const std::size_t action = input_.choose(16);
    Peer& peer = peers_[input_.choose(kClients)];
    peer_ = &peer;
    switch (action) {
      case 8:
        say(peer, input_.take_text(input_.take<std::uint8_t>()), input_.choose(16) == 0);
        return true;
      case 9:
      case 10:
        now_ns_ += std::int64_t{input_.take<std::uint8_t>()} * 10 * kMillisecond_ns;
        hub_.step(now_ns_);
        return false;
      case 11:
        publish();
        return false;
      case 12:
        answer();
        return false;
      case 13:
        read(peer);
        return false;
      case 14:
        connect(peer);
        return false;
      case 15:
        robot_.is_connected = !input_.flag() || !input_.flag();
        robot_.is_blocked = input_.flag() && input_.flag();
        return false;
      default:
        say(peer, message(), false);
        return true;
    }
  }
  // One of the known messages; sometimes changed in one place, or with a lease that was given.
  std::string message() {
    std::string text(kMessages[input_.choose(kMessages.size())]);
    if (const std::size_t at = text.find("LEASE"); at != std::string::npos) {
      text.replace(at, 5, lease_);
    }
    if (const std::size_t at = text.find("CALL"); at != std::string::npos) {
      text.replace(at, 4, call_);
    }
    if (input_.choose(4) == 0) {
      const std::size_t at = input_.take<std::uint8_t>() % text.size();
      text.replace(at, input_.choose(3), input_.take_text(input_.choose(3)));
    }
    return text;
  }
  void say(Peer& peer, std::string_view text, bool binary) {
    // As loosely as can be: escapes may hide a field.
    peer.authorised = peer.authorised || text.find("secret") != std::string_view::npos ||
                      text.find('\\') != std::string_view::npos;
    peer.wants_cbor = peer.wants_cbor || text.find("cbor") != std::string_view::npos ||
                      text.find('\\') != std::string_view::npos;
    was_closed_ = peer.closed;
    peer.session->take(text, binary, now_ns_);
  }
  void publish() {
    const std::size_t which = input_.choose(4);
    const std::size_t size = input_.take<std::uint8_t>();
    if (which == 0) {
      ros::JointState state;
      state.position.resize(size, 0.25);
      hub_.publish(Topic::joint_states, state);
    } else if (which == 1) {
      hub_.publish(Topic::robot_description, ros::String{std::string(size * 50, 'x')});
    } else if (which == 2) {
      hub_.publish(Topic::zmp, ros::PointStamped{});
    } else {
      hub_.publish(Topic::events, ros::Log{});
    }
  }
  void answer() {
    const std::uint32_t number = robot_.last_number - static_cast<std::uint32_t>(input_.choose(4));
    robot_.results.push_back({number, input_.flag(), std::string(input_.take_text(8))});
    hub_.step(now_ns_);
  }
  void read(Peer& peer) {
    for (std::size_t left = 1 + input_.choose(32); left > 0; --left) {
      const auto frame = peer.session->next_frame(now_ns_);
      if (!frame) {
        peer.awake = false;
        return;
      }
      require(frame->bytes != nullptr, "a frame has bytes");
      const json message = frame->binary
                               ? json::from_cbor(*frame->bytes, true, false, json::cbor_tag_handler_t::ignore)
                               : json::parse(*frame->bytes, nullptr, false);
      require(message.is_object() && message.contains("op"), "what is sent is a message of rosbridge");
      require(!frame->binary || peer.wants_cbor, "CBOR is sent to who asked for it");
      remember_lease(message);
      if (message["op"] == "call_service") {
        require(message["id"].is_string(), "a call that is passed on has an id of the robot's");
        call_ = message["id"].get<std::string>();
      }
    }
  }
  void remember_lease(const json& message) {
    if (message.value("result", false) && message["values"].contains("lease") &&
        message["values"]["lease"].is_string()) {
      lease_ = message["values"]["lease"].get<std::string>();
    }
  }

  void check(std::size_t told_before, bool for_client) {
    const HubStatistics statistics = hub_.statistics();
    require(statistics.waiting_bytes <= kClients * tight().waiting_bytes, "what waits is bounded");
    require(statistics.subscriptions <= kClients * tight().subscriptions, "subscriptions are bounded");
    require(!robot_.walking || !statistics.commander.empty(), "it walks only while somebody commands");
    for (const Peer& peer : peers_) {
      require(peer.reason_fits, "the reason of a close fits in its frame");
    }
    for (std::size_t i = told_before; i < robot_.told.size(); ++i) {
      const std::string& what = robot_.told[i];
      const bool by_itself = what == "stand" || what == "order";  // the rest of a walk, or of a reading
      require(by_itself || (for_client && peer_->authorised && !was_closed_),
              "the robot does what a client that is let in asks for");
      if (what == "walk") {
        require(driver_ == nullptr || driver_ == peer_, "one drives at a time");
        driver_ = peer_;
      } else if (what == "stand" || what == "let_command_go") {  // whose walk the robot ends by itself
        driver_ = nullptr;
      }
    }
  }

  Input& input_;
  bool wants_token_;
  RecordedRobot robot_;
  RecordedSimulation simulation_, twin_;
  Hub hub_;
  std::array<Peer, kClients> peers_;
  std::int64_t now_ns_ = 1'000'000'000;
  std::string lease_ = "none", call_ = "none";
  const Peer* peer_ = nullptr;  // who acts
  bool was_closed_ = false;
  const Peer* driver_ = nullptr;  // who made the robot walk, until it was told to stand or he let go
};

}  // namespace

void api_session(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  Trial(input).run();
}

}  // namespace gaitway::fuzz
