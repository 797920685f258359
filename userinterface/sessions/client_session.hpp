// One client's conversation: rosbridge's operations, and what the client may do at all.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "client_services.hpp"
#include "client_topics.hpp"
#include "gaitway/api/authority.hpp"
#include "gaitway/api/hub.hpp"
#include "gaitway/api/session.hpp"
#include "outbox.hpp"
#include "robot_commands.hpp"
#include "service_call.hpp"
#include "service_desk.hpp"
#include "subscriptions.hpp"
#include "topic_share.hpp"

namespace gaitway::api {

class ClientSession;

// What all sessions of a hub share.
struct HubState {
  HubState(RobotPort& port, HubOptions hub_options);
  // Cuts who leaves most unread, until no more waits for all together than may. To be called when something
  // may have come to wait, and no list of sessions is being walked through.
  void keep_within_budget();
  // To its client, if that is still there.
  void answer(const ServiceCall& call, Frame frame);

  const RobotPort& robot;
  HubOptions options;
  RobotCommands commands;
  ClientTopics topics;
  ClientServices services;
  ServiceDesk desk;
  Publications publications;
  std::map<std::uint64_t, ClientSession*> sessions;  // by Claimant::number
  std::size_t waiting_bytes = 0;                     // of all sessions
  std::uint64_t last_number = 0;
  std::int64_t now_ns = 0;  // of the latest call
  HubStatistics counts;     // only what is counted since the start
};

// How many messages one client sends, against what it may: a bucket that fills with time.
class MessageRate {
 public:
  enum class Verdict : std::uint8_t {
    fine,
    too_many,  // this one is refused
    goes_on    // a second's worth of messages has been refused by now: enough
  };

  // `now_ns`: when the client came. It may send a second's worth at once.
  MessageRate(double messages_per_s, std::int64_t now_ns) noexcept
      : per_s_(messages_per_s), left_(messages_per_s), filled_ns_(now_ns) {}

  Verdict count(std::int64_t now_ns) noexcept {
    const double passed_s = static_cast<double>(std::max<std::int64_t>(now_ns - filled_ns_, 0)) * 1e-9;
    filled_ns_ = std::max(now_ns, filled_ns_);
    left_ = std::min(left_ + passed_s * per_s_, per_s_);
    refused_ = std::max(refused_ - passed_s * per_s_ * kForgiven, 0.0);
    if (left_ >= 1.0) {
      left_ -= 1.0;
      return Verdict::fine;
    }
    refused_ += 1.0;
    return refused_ > per_s_ ? Verdict::goes_on : Verdict::too_many;
  }

 private:
  static constexpr double kForgiven =
      0.1;  // of the refusals: so many of the allowed rate are forgotten again

  double per_s_;
  double left_;
  double refused_ = 0.0;
  std::int64_t filled_ns_;
};

class ClientSession final : public Session, private Subscriber {
 public:
  ClientSession(HubState& hub, Connection& connection, Claimant claimant, bool authorised);
  ~ClientSession() override;
  ClientSession(const ClientSession&) = delete;
  ClientSession& operator=(const ClientSession&) = delete;

  void take(std::string_view message, bool binary, std::int64_t wall_ns) override;
  void take_overtaken(std::string_view message, bool binary, std::int64_t wall_ns) override;
  [[nodiscard]] Urgency urgency(std::string_view message, bool binary) const noexcept override;
  std::optional<Frame> next_frame(std::int64_t wall_ns) override;
  [[nodiscard]] bool gives_orders() const noexcept override;
  [[nodiscard]] bool authorised() const noexcept override { return authorised_; }

  // For the hub.
  void step(std::int64_t now_ns);
  void answer(const ServiceCall& call, Frame frame);
  // A call of a service that this client offers. False: it leaves too much unread to be sent more.
  [[nodiscard]] bool take_call(Frame frame);
  // Closes it, and forgets what waits for it.
  void cut();
  [[nodiscard]] std::size_t subscriptions() const noexcept {
    return subscriptions_.count() + topics_.subscriptions();
  }
  [[nodiscard]] std::size_t waiting_bytes() const noexcept { return outbox_.waiting_bytes(); }

 private:
  using Json = nlohmann::json;
  enum class Level : std::uint8_t { none, error, warning, info };
  struct Operation {
    std::string_view name;
    void (ClientSession::*carry_out)(const Json& message, const Json& id);
  };
  static const Operation* find_operation(std::string_view name) noexcept;

  // Subscriber.
  [[nodiscard]] Encoding encoding(Topic topic) const noexcept override;
  void offer(Topic topic, const Frame& frame) override;

  // Operations; each throws what std::exception says for a client's fault.
  void authenticate(const Json& message, const Json& id);
  void advertise(const Json& message, const Json& id);
  void unadvertise(const Json& message, const Json& id);
  void publish(const Json& message, const Json& id);
  void subscribe(const Json& message, const Json& id);
  void unsubscribe(const Json& message, const Json& id);
  void call_service(const Json& message, const Json& id);
  void set_level(const Json& message, const Json& id);
  void ignore(const Json& message, const Json& id);
  void advertise_service(const Json& message, const Json& id);
  void unadvertise_service(const Json& message, const Json& id);
  void respond_to_call(const Json& message, const Json& id);
  void refuse_actions(const Json& message, const Json& id);
  void refuse_transformation(const Json& message, const Json& id);

  [[nodiscard]] bool within_rate(std::string_view message);
  void tell_rate(std::string_view message);
  void carry_out(std::string_view text);
  // Nothing in its message keeps a stop from being carried out: fields that could not be read count as
  // absent. What was wrong with them; empty: nothing, or this is no stop.
  [[nodiscard]] std::string leave_out_what_is_wrong_in_stop(Json& message) const;
  // The same of topics that are the clients' own.
  void advertise_own(const Json& message, const Json& id);
  void publish_own(const Json& message);
  void subscribe_own(const Json& message, const Json& id);
  // Each throws Refused.
  void require_room_to_advertise() const;
  void require_room_to_subscribe() const;
  // `usual_queue`: its length, where the client asks for none; `raw`: whether "cbor-raw" may be asked for.
  [[nodiscard]] Terms terms_of(const Json& message, std::size_t usual_queue, bool raw, const Json& id);
  [[nodiscard]] std::size_t fragment_bytes_of(const Json& message) const;
  void serve(Topic topic);  // as its subscriptions want it now
  void tell(Level level, std::string_view text, const Json& id);
  void tell_error(std::string_view text, const Json& id);
  void tell_drops();
  void push(Frame frame, std::size_t fragment_bytes = 0);
  void wake();
  void close(std::uint16_t code, std::string_view reason);
  void leave();

  HubState& hub_;
  Connection& connection_;
  Claimant claimant_;
  bool authorised_;
  bool closing_ = false;
  bool awake_ = false;  // the connection has been woken and not been told yet that nothing waits
  Level level_ = Level::warning;
  std::int64_t opened_ns_;
  std::optional<std::int64_t> told_rate_ns_, told_drops_ns_;
  MessageRate rate_;
  Outbox outbox_;
  Subscriptions subscriptions_;
  std::set<std::string> advertisements_;  // of the velocity: their ids
  TopicShare topics_;
};

}  // namespace gaitway::api
