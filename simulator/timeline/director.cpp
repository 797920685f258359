// Orders in, the right process told.
#include "gaitway/timeline/director.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::timeline {
namespace {

using nlohmann::json;

constexpr std::int64_t kPaceWindow_ns = facts::kSecond_ns;
constexpr std::size_t kMostMarks = 200, kMostEventsTold = 20;
constexpr int kLivePatience_ms = 30'000;  // of a start

double seconds_of(std::int64_t time_ns) noexcept {
  return static_cast<double>(time_ns) * 1e-9;
}

double number_of(const json& order, const char* field, double least, double most, const char* unit) {
  const auto value = order.find(field);
  if (value == order.end() || !value->is_number()) {
    throw std::invalid_argument(
        fmt::format("{} is missing: it must be a number from {} to {} {}", field, least, most, unit));
  }
  const double number = value->get<double>();
  if (!(number >= least && number <= most)) {
    throw std::invalid_argument(
        fmt::format("{} is {}, but must be from {} to {} {}", field, value->dump(), least, most, unit));
  }
  return number;
}

// What the live simulation carries out, checked as far as it does not do so itself.
void check_passed_on(const json& order, const std::string& what) {
  if (what == "step") static_cast<void>(number_of(order, "milliseconds", 1, kMostSteps_ms, "ms"));
  if (what == "apply" && !(order.contains("event") && order.at("event").is_string())) {
    throw std::invalid_argument(
        "event is missing: it must be the text of a scenario's event, as {push: {...}}");
  }
}

json parsed(std::string_view text) {
  json order = json::parse(text, nullptr, false);
  if (!order.is_object() || !order.contains("order") || !order.at("order").is_string()) {
    throw std::invalid_argument("an order must be a JSON object whose field `order` names it");
  }
  return order;
}

// Never more than so many: of events that come thicker, each n-th.
json marks_of(std::span<const TimedEvent* const> events) {
  const std::size_t every = events.size() / kMostMarks + 1;
  json marks = json::array();
  for (std::size_t i = 0; i < events.size(); i += every) {
    marks.push_back({{"at_s", seconds_of(events[i]->at_ns)}, {"kind", mark_of(*events[i])}});
  }
  return marks;
}

}  // namespace

Director::Director(CopyHandle start, DirectorOptions options)
    : options_(std::move(options)),
      timeline_(std::move(start)),
      playing_(options_.playing),
      speed_(options_.speed),
      server_(
          options_.socket,
          [this](const Ticket& ticket, const simulation::Push& push) {
            require_simulation();
            pass_on(ticket, {{"order", "push"},
                             {"link", push.link},
                             {"force_N", push.force_N},
                             {"frame", static_cast<std::uint32_t>(push.frame)},
                             {"duration_s", push.duration_s}});
            return false;
          },
          [this](const Ticket& ticket, std::string_view text) { return obey(ticket, text); }) {
  go_live(timeline_.at(0));
}

void Director::step(int patience_ms) {
  std::array<pollfd, 3> wakes{pollfd{server_.wake_fd(), POLLIN, 0},
                              pollfd{live_ ? live_->channel().descriptor() : -1, POLLIN, 0},
                              pollfd{timeline_.wake_fd(), POLLIN, 0}};
  process::wait_until(process::monotonic_ns() + std::int64_t{patience_ms} * facts::kMillisecond_ns, wakes);
  hear_live();
  timeline_.keep_up();
  server_.step();
}

std::optional<std::string> Director::obey(const Ticket& ticket, std::string_view text) {
  static const std::vector<std::string> kOrders{"state", "geometry", "play", "pause", "step",
                                                "speed", "reset",    "seek", "apply", "plan"};
  json order = parsed(text);
  const auto what = order.at("order").get<std::string>();
  if (what == "state") return state().dump();
  if (std::ranges::find(kOrders, what) == kOrders.end()) {
    throw std::invalid_argument(fmt::format("order is '{}'. {}", what, input::suggest(what, kOrders)));
  }
  if (what == "seek") {
    const double most_s = seconds_of(timeline_.recorded_ns());
    go_to(std::llround(number_of(order, "time_s", 0.0, most_s, "s, what has been recorded") * 1e3) *
          facts::kMillisecond_ns);
    return json{{"time_s", seconds_of(now_ns_)}}.dump();
  }
  if (what == "reset") {
    const bool played = playing_;
    playing_ = false;
    go_live(timeline_.begin_anew());
    falls_ns_.clear();
    playing_ = played;
    set_pace();
    return "{}";
  }
  require_simulation();
  if (what == "plan") {
    if (!options_.plan_way) throw std::invalid_argument("this simulation plans no ways");
    const auto goal = order.find("goal");
    if (goal == order.end() || !goal->is_array() || goal->size() != 3 ||
        !std::ranges::all_of(*goal, [](const json& one) { return one.is_number(); })) {
      throw std::invalid_argument("goal must be a list of three numbers: x m, y m, yaw rad");
    }
    return options_.plan_way(goal->get<std::array<double, 3>>(), seen_).dump();
  }
  if (what == "play" || what == "pause") {
    playing_ = what == "play";
    set_pace();
    return "{}";
  }
  if (what == "speed") {
    speed_ = number_of(order, "times", kSlowest, kFastest, "times real time");
    set_pace();
    return "{}";
  }
  check_passed_on(order, what);
  if (what == "step") {
    playing_ = false;
    set_pace();
  }
  pass_on(ticket, std::move(order));
  return std::nullopt;
}

void Director::pass_on(const Ticket& ticket, json order) {
  passed_on_.emplace(++last_order_, ticket);
  live_->channel().send({{"do", "order"}, {"id", last_order_}, {"order", std::move(order)}});
}

void Director::require_simulation() const {
  if (!live_) {
    throw std::runtime_error(failure_ + ". Seek to an earlier instant, or reset");
  }
}

void Director::set_pace() {
  if (live_) live_->channel().send({{"do", "pace"}, {"playing", playing_}, {"speed", speed_}});
  paced_wall_ns_ = 0;
  pace_ = 0.0;
}

void Director::go_to(std::int64_t at_ns) {
  if (live_) live_->channel().send({{"do", "pace"}, {"playing", false}, {"speed", speed_}});
  try {
    CopyHandle copy = timeline_.at(std::min(at_ns, timeline_.recorded_ns()));
    hear_live();  // what it has done to the last
    playing_ = false;
    go_live(std::move(copy));
  } catch (const std::exception&) {
    set_pace();  // where there still is one, it goes on as it did
    throw;
  }
}

// What goes wrong leaves no simulation, and says so.
void Director::go_live(CopyHandle copy) {
  for (const auto& [number, ticket] : std::exchange(passed_on_, {})) {
    server_.answer(ticket, false, "the simulation went to another instant before it was done");
  }
  if (live_) live_->end_with_children();  // two of them would listen at one socket
  live_.reset();
  try {
    copy.channel().send({{"do", "live"}, {"playing", playing_}, {"speed", speed_}});
    const auto first = copy.receive(kLivePatience_ms);
    if (!first) throw std::runtime_error("it has not started within 30 s");
    live_.emplace(std::move(copy));
    failure_.clear();
    ++run_;
    paced_wall_ns_ = 0;
    now_ns_ = first->message.at("at_ns").get<std::int64_t>();
    seen_ = first->message.at("state");
  } catch (const std::exception& error) {
    fail(error.what());
    throw;
  }
}

std::optional<std::uint64_t> Director::finish() {
  playing_ = false;
  set_pace();
  hear_live();
  if (live_) live_->end_with_children();
  live_.reset();
  try {
    return timeline_.digest_at(timeline_.recorded_ns());
  } catch (const std::exception&) {
    return std::nullopt;  // a bar, or a replay that failed: it has been told of
  }
}

void Director::hear_live() {
  try {
    while (live_) {
      const auto packet = live_->receive(0);
      if (!packet) return;
      if (packet->message.contains("answer")) {
        take_answer(packet->message);
      } else {
        take_report(packet->message);
      }
    }
  } catch (const std::exception& error) {
    fail(error.what());
  }
}

void Director::take_report(const json& report) {
  const std::int64_t before_ns = now_ns_;
  now_ns_ = report.at("at_ns").get<std::int64_t>();
  const std::vector<TimedEvent> events = events_from(report.at("events"));
  // Whoever goes on from an earlier instant has what came after it forgotten: now, when something has
  // happened.
  if (before_ns < timeline_.recorded_ns() && (now_ns_ > before_ns || !events.empty())) {
    timeline_.forget_after(before_ns);
    falls_ns_.erase(falls_ns_.upper_bound(before_ns), falls_ns_.end());
  }
  timeline_.extend(now_ns_, events);
  for (const json& one : report.at("digests")) {
    timeline_.note_digest(one.at(0).get<std::int64_t>(), one.at(1).get<std::uint64_t>());
  }
  if (const json& bar = report.at("bar"); !bar.is_null()) {
    timeline_.bar(bar.at(0).get<std::int64_t>(), bar.at(1).get<std::string>());
  }
  const bool fell_before = seen_.value("fallen", false);
  seen_ = report.at("state");
  if (seen_.at("fallen").get<bool>() && !fell_before && now_ns_ > before_ns) falls_ns_.insert(now_ns_);
  measure_pace();
}

void Director::take_answer(const json& answer) {
  const auto ticket = passed_on_.extract(answer.at("answer").get<std::uint64_t>());
  if (!ticket) return;
  const bool ok = answer.at("ok").get<bool>();
  server_.answer(ticket.mapped(), ok, ok ? answer.at("result").dump() : answer.at("text").get<std::string>());
}

void Director::fail(const std::string& why) {
  if (live_) live_->end_with_children();
  live_.reset();
  playing_ = false;
  failure_ = fmt::format("the simulation has ended at {:.3f} s: {}", seconds_of(now_ns_), why);
  for (const auto& [number, ticket] : std::exchange(passed_on_, {})) server_.answer(ticket, false, failure_);
}

void Director::measure_pace() {
  const std::int64_t wall_ns = process::monotonic_ns();
  if (paced_wall_ns_ == 0) {
    paced_wall_ns_ = wall_ns;
    paced_ns_ = now_ns_;
  } else if (wall_ns - paced_wall_ns_ >= kPaceWindow_ns) {
    pace_ = static_cast<double>(now_ns_ - paced_ns_) / static_cast<double>(wall_ns - paced_wall_ns_);
    paced_wall_ns_ = wall_ns;
    paced_ns_ = now_ns_;
  }
}

json Director::state() const {
  json result = seen_;
  const std::vector<const TimedEvent*> shown = without_renewals(timeline_.events());
  json marks = marks_of(shown);
  for (const std::int64_t at_ns : falls_ns_) marks.push_back({{"at_s", seconds_of(at_ns)}, {"kind", "fall"}});
  json events = json::array();
  for (const TimedEvent* const event : std::span(shown).last(std::min(shown.size(), kMostEventsTold))) {
    events.push_back({{"at_s", seconds_of(event->at_ns)}, {"text", event->text}});
  }
  std::string text = failure_;
  if (timeline_.differences() > 0) {
    text += fmt::format(
        "{}{} replays ended elsewhere than the simulation that ran: something in it is not "
        "deterministic",
        text.empty() ? "" : "; ", timeline_.differences());
  }
  result.update({{"recorded_s", seconds_of(timeline_.recorded_ns())},
                 {"state", !failure_.empty() ? "failed"
                           : playing_        ? "playing"
                                             : "paused"},
                 {"text", text},
                 {"speed", speed_},
                 {"pace", playing_ ? pace_ : 0.0},
                 {"world", options_.world},
                 {"run", run_},
                 {"process", live_ ? live_->process() : 0},  // for debuggers
                 {"events", events},
                 {"marks", marks}});
  return result;
}

}  // namespace gaitway::timeline
