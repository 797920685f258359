// Orders get their expiry here, from the robot's clock as the link last told it.
#include "gaitway/api/module_link.hpp"

#include <algorithm>
#include <random>
#include <span>
#include <utility>

#include "gaitway/api/state_messages.hpp"
#include "gaitway/msgclient/mails.hpp"

namespace gaitway::api {
namespace {

using contract::OrderKind;
using contract::OrderResultCode;

constexpr std::size_t kVelocitiesUnderWay = 4;  // more would only grow old on the way
constexpr std::size_t kMostResults = 65536;     // while nobody takes them

std::string text_of(link::Refusal refusal, const contract::OrderRow& row) {
  switch (refusal) {
    case link::Refusal::none:
      break;
    case link::Refusal::no_session:
      return "the robot is not there: the link to its main controller is down";
    case link::Refusal::full:
      return "the link to the main controller is busy: too many orders wait for their answers";
    case link::Refusal::too_long:
      return "the " + std::string(row.name) + " is longer than the link carries";
    case link::Refusal::expired:
      return "late: this " + std::string(row.name) + " is older than " +
             std::to_string(row.validity_ns / facts::kMillisecond_ns) + " ms, and was not carried out";
  }
  return {};
}

std::string text_of(OrderResultCode code, const contract::OrderRow& row) {
  switch (code) {
    case OrderResultCode::done:
      return {};
    case OrderResultCode::malformed:
      return "the main controller could not read the order";
    case OrderResultCode::unknown:
      return "the main controller does not know this kind of order";
    case OrderResultCode::full:
      return "the way to the robot is full: try again";
    case OrderResultCode::overtaken:
      return "another " + std::string(row.name) + " was asked for before this one could begin";
    case OrderResultCode::stopped:
      return "it was given before a stop, and is not carried out after it";
  }
  return "the main controller answered what this module does not know";
}

}  // namespace

ModuleLink::ModuleLink(const urdf::RobotModel& robot, const ModuleLinkOptions& options)
    : codec_{.joint_count = robot.joints.size()},
      orders_{.joint_count = robot.joints.size(), .exact = true},
      mirror_(codec_),
      robot_(robot.name),
      robot_directory_(robot.directory),
      calibration_hash_(contract::calibration_hash(robot)),
      end_(contract::identity_of(link::Role::module, options.boot, options.name, robot),
           contract::link_channels(codec_), options.link),
      last_number_(std::random_device{}()) {}

void ModuleLink::pump(link::Carrier* carrier, std::int64_t now_ns) {
  const std::scoped_lock lock(mutex_);
  if (carrier != nullptr) {
    link::pump(end_, *carrier, now_ns);
  } else if (end_.session().open()) {
    end_.cut(now_ns);
  } else {
    end_.step(now_ns);
  }
  collect(now_ns);
  if (carrier != nullptr && waiting_) {
    submit_waiting(now_ns);
    link::pump(end_, *carrier, now_ns);
  }
  mirror_.take(end_.state());
  if (const auto robot_ns = end_.robot_clock_ns()) {
    mirror_.beat(*robot_ns);
  }
}

void ModuleLink::step(std::int64_t now_ns) {
  const std::scoped_lock lock(mutex_);
  end_.step(now_ns);
  collect(now_ns);
}

bool ModuleLink::open() const {
  const std::scoped_lock lock(mutex_);
  return end_.session().open();
}
std::uint32_t ModuleLink::session() const {
  const std::scoped_lock lock(mutex_);
  return end_.session().open() ? end_.session().count() : 0;
}
std::string ModuleLink::description() const {
  const std::scoped_lock lock(mutex_);
  const bool of_the_robot = end_.session().why() == link::SessionEnd::wrong_robot;
  return end_.session().description() +
         (of_the_robot ? "; here it is '" + robot_ + "' of " + robot_directory_.native() : "");
}
link::SessionEnd ModuleLink::why() const {
  const std::scoped_lock lock(mutex_);
  return end_.session().why();
}
bool ModuleLink::same_calibration() const {
  const std::scoped_lock lock(mutex_);
  return end_.session().peer_calibration_hash() == calibration_hash_;
}
link::StopCounts ModuleLink::stops_asked() const {
  const std::scoped_lock lock(mutex_);
  return end_.stops().asked();
}
link::StopCounts ModuleLink::stops_obeyed() const {
  const std::scoped_lock lock(mutex_);
  return end_.stops().obeyed();
}
link::LinkStatistics ModuleLink::statistics() const {
  const std::scoped_lock lock(mutex_);
  return end_.statistics();
}

bool ModuleLink::awaits(OrderKind kind) const {
  const std::scoped_lock lock(mutex_);
  return std::ranges::find(given_, kind, &Given::kind) != given_.end();
}

std::uint32_t ModuleLink::next_number() {
  const std::scoped_lock lock(mutex_);
  last_number_ = std::max<std::uint32_t>(last_number_ + 1, 1);
  return last_number_;
}

std::uint32_t ModuleLink::order_untyped(OrderKind kind, const void* request, std::int64_t age_ns,
                                        std::int64_t now_ns) {
  const std::uint32_t number = next_number();
  {
    const std::scoped_lock lock(mutex_);
    const contract::OrderRow& row = contract::row(kind);
    std::array<std::uint8_t, link::kMostOrderBytes> room{};
    for (std::size_t i = 0; i < contract::kStopsSeenBytes; ++i) {
      room[i] = static_cast<std::uint8_t>(stops_seen_ >> (8 * i));
    }
    const std::size_t size =
        contract::kStopsSeenBytes +
        orders_.encode(*row.request, request, std::span(room).subspan(contract::kStopsSeenBytes));
    const std::int64_t expiry_ns = end_.robot_time_ns(now_ns).value_or(0) - age_ns + row.validity_ns;
    const link::Bytes payload = std::span(room).first(size);
    if (kind == OrderKind::walk && velocities_under_way_ >= kVelocitiesUnderWay) {
      if (waiting_) {
        refuse(waiting_->number, "a newer velocity came before this one could be sent");
      }
      waiting_ = WaitingVelocity{number, expiry_ns, {payload.begin(), payload.end()}};
    } else {
      submit(kind, payload, expiry_ns, number, now_ns);
    }
  }
  if (wake_) {
    wake_();
  }
  return number;
}

void ModuleLink::submit(OrderKind kind, link::Bytes payload, std::int64_t expiry_ns, std::uint32_t number,
                        std::int64_t now_ns) {
  const link::Submission submission =
      end_.submit(static_cast<std::uint16_t>(kind), payload, expiry_ns, now_ns);
  if (submission.refusal != link::Refusal::none) {
    return refuse(number, text_of(submission.refusal, contract::row(kind)));
  }
  given_.push_back({submission.id, number, kind});
  velocities_under_way_ += kind == OrderKind::walk ? 1U : 0U;
}

void ModuleLink::submit_waiting(std::int64_t now_ns) {
  if (waiting_ && velocities_under_way_ < kVelocitiesUnderWay) {
    const WaitingVelocity velocity = std::move(*waiting_);
    waiting_.reset();
    submit(OrderKind::walk, velocity.payload, velocity.expiry_ns, velocity.number, now_ns);
  }
}

void ModuleLink::ask_stop(link::StopKind kind) {
  end_.stop(kind);
  if (waiting_) {  // nobody walks on after a stop
    refuse(waiting_->number, text_of(OrderResultCode::stopped, contract::row(OrderKind::walk)));
    waiting_.reset();
  }
}

void ModuleLink::stop_unseen(link::StopKind kind) {
  {
    const std::scoped_lock lock(mutex_);
    ask_stop(kind);
  }
  if (wake_) {
    wake_();
  }
}

void ModuleLink::see_stops(std::uint32_t count) {
  const std::scoped_lock lock(mutex_);
  stops_seen_ += count;
}

std::uint32_t ModuleLink::stop(link::StopKind kind) {
  const std::uint32_t number = next_number();
  {
    const std::scoped_lock lock(mutex_);
    ask_stop(kind);
    ++stops_seen_;
    static constexpr std::array kMembers{&link::StopCounts::stops, &link::StopCounts::holds,
                                         &link::StopCounts::softs};
    const auto member = kMembers[static_cast<std::size_t>(kind)];
    stops_.push_back({number, member, end_.stops().asked().*member});
    if (stops_.size() > kMostResults) {
      stops_.pop_front();  // the oldest runs out of time unanswered
    }
  }
  if (wake_) {
    wake_();
  }
  return number;
}

std::optional<OrderResult> ModuleLink::take_result(std::int64_t now_ns) {
  const std::scoped_lock lock(mutex_);
  collect(now_ns);
  if (results_.empty()) {
    return std::nullopt;
  }
  OrderResult result = std::move(results_.front());
  results_.pop_front();
  return result;
}

void ModuleLink::collect(std::int64_t now_ns) {
  while (const auto outcome = end_.next_outcome(now_ns)) {
    const auto given = std::ranges::find(given_, outcome->id, &Given::id);
    if (given == given_.end()) {
      continue;
    }
    velocities_under_way_ -= given->kind == OrderKind::walk ? 1U : 0U;
    results_.push_back(result_of(*given, *outcome));
    given_.erase(given);
  }
  const link::StopCounts& obeyed = end_.stops().obeyed();
  std::erase_if(stops_, [&](const AwaitedStop& stop) {
    const bool done = static_cast<std::int32_t>(obeyed.*stop.kind - stop.count) >= 0;
    if (done) {
      results_.push_back(
          {stop.number, true,
           stop.kind == &link::StopCounts::stops ? "" : "the joints are stopped until /release"});
    }
    return done;
  });
  while (results_.size() > kMostResults) {
    results_.pop_front();
  }
}

OrderResult ModuleLink::result_of(const Given& given, const link::Outcome& outcome) const {
  const contract::OrderRow& row = contract::row(given.kind);
  switch (outcome.verdict) {
    case link::Verdict::late:
      return {given.number, false, text_of(link::Refusal::expired, row)};
    case link::Verdict::unanswered:
      return {given.number, false,
              "the link to the main controller was lost before it answered: the " + std::string(row.name) +
                  " may have been carried out or not"};
    case link::Verdict::answered:
      break;
  }
  const auto code = static_cast<OrderResultCode>(outcome.result);
  return code == OrderResultCode::done && row.answer != nullptr
             ? answer_of(given, outcome.payload)
             : OrderResult{given.number, code == OrderResultCode::done, text_of(code, row)};
}

OrderResult ModuleLink::answer_of(const Given& given, link::Bytes payload) const {
  const auto decode = [&](auto& answer) {
    return orders_.decode(*contract::row(given.kind).answer, payload, &answer) == payload.size() &&
           !payload.empty();
  };
  if (given.kind == OrderKind::motion) {
    MotionState state;
    if (decode(state)) {
      return {given.number, state.refused == 0, gaitway::api::text_of(state.text)};
    }
  } else if (given.kind == OrderKind::way) {
    NavigationState state;
    if (decode(state)) {
      namespace results = navigation_state::result;
      const bool refused = state.result == results::refused || state.result == results::failed;
      return {given.number, !refused, gaitway::api::text_of(state.text)};
    }
  } else if (given.kind == OrderKind::command) {
    CommandState state;
    if (decode(state)) {
      const bool done = state.commander != command_state::commander::emergency_stop;
      return {given.number, done, gaitway::api::text_of(state.text)};
    }
  } else if (given.kind == OrderKind::user_command) {
    UserCommandAnswer answer;
    if (decode(answer)) {
      const auto reason = static_cast<msgclient::Reason>(answer.reason);
      const bool done = reason == msgclient::Reason::none;
      return {given.number, done, done ? "" : std::string(msgclient::reason_text(reason))};
    }
  } else if (PluginAnswer answer; decode(answer)) {
    return {given.number, answer.done != 0, gaitway::api::text_of(answer.text)};
  }
  return {given.number, false, text_of(OrderResultCode::unknown, contract::row(given.kind))};
}

}  // namespace gaitway::api
