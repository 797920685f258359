// The loop of the simulation that runs.
#include "gaitway/timeline/live_simulation.hpp"

#include <signal.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/core/events.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/manager/plugin_requests.hpp"
#include "gaitway/msgclient/memory_block_thread.hpp"
#include "gaitway/process/real_time.hpp"
#include "gaitway/simulator/command_log.hpp"
#include "gaitway/simulator/pace.hpp"
#include "gaitway/simulator/push_taker.hpp"
#include "live_state.hpp"

namespace gaitway::timeline {
namespace {

using facts::kMillisecond_ns;
using nlohmann::json;

constexpr std::int64_t kReport_ns = 20 * kMillisecond_ns;  // by the wall clock
constexpr std::int64_t kPrint_ns = 100 * kMillisecond_ns;  // of the robot's time
constexpr int kPausedLook_ms = 20;
constexpr std::size_t kEventsAReport = 10;  // of 4,000 bytes each at most

// The robot's side of the robot API comes into a robot that has been without so far, and people's orders
// count from then on.
class PeoplesAccess {
 public:
  PeoplesAccess(const LiveOptions& options, ReplayedRun& run)
      : simulation_(run.run()),
        block_thread_(shared(run.memory_block()), options.memory_socket),
        requests_client_(run.memory_block().local_client("plugin_requests")),
        api_(options.api),
        requests_((start(), requests_client_), simulation_.plugins()),
        workshop_(requests_) {
    simulation_.hand_to_people();
  }

  // After each tick.
  void step(std::int64_t now_ns) {
    if (!coming_) return requests_.step(now_ns);
    const auto result = simulation_.plugins().changes().take_result();
    if (result && result->done) coming_ = false;
    if (result && !result->done) start();  // it was too slow in its first step, on a busy computer
  }
  [[nodiscard]] bool take_change() noexcept { return requests_.take_change(); }

 private:
  static msgclient::MemoryBlock& shared(msgclient::MemoryBlock& block) {
    block.share_anew();
    return block;
  }
  void start() {
    core::ChangeControl& changes = simulation_.plugins().changes();
    changes.schedule(changes.prepare_addition(api_));
  }

  simulator::Cosimulation& simulation_;
  msgclient::MemoryBlockThread block_thread_;
  msgclient::Client requests_client_;
  const core::PluginEntry& api_;
  bool coming_ = true;  // it is not in place yet: it comes with the next batch
  core::PluginRequests requests_;
  core::PluginWorkshop workshop_;
};

class LiveSimulation final : public simulator::CosimulationObserver {
 public:
  LiveSimulation(const LiveOptions& options, ReplayedRun& run, const CopyChannel& channel)
      : options_(options),
        replayed_(run),
        run_(run.run()),
        channel_(channel),
        access_(options, run),
        log_(run_),
        pushes_(run_),
        state_(run_) {
    replayed_.observe(this);
  }

  [[noreturn]] void serve(const json& told) {
    set_pace(told);
    report(true);
    while (true) {
      while (const auto packet = channel_.receive(0)) obey(packet->message);
      if (steps_left_ == 0 && !playing_) {
        report(false);
        std::array<pollfd, 1> wake{pollfd{channel_.descriptor(), POLLIN, 0}};
        poll(wake.data(), wake.size(), kPausedLook_ms);
        continue;
      }
      std::array<pollfd, 1> wake{pollfd{channel_.descriptor(), POLLIN, 0}};
      if (steps_left_ == 0 && !pace_.wait(wake)) continue;
      millisecond();
      if (steps_left_ > 0 && --steps_left_ == 0) finish_step();
      report(false);
    }
  }

 private:
  void on_frame(const can::SimulatedBus::Delivery&) override {}
  void on_millisecond(std::int64_t now_ns) override { log_.on_millisecond(now_ns - kMillisecond_ns); }
  void on_orders(const msgcontroller::PassedOrders& orders, std::int64_t now_ns) override {
    log_.on_orders(orders, now_ns);
  }

  void millisecond() {
    const std::int64_t now_ns = run_.now_ns();
    run_.advance_millisecond();
    if (core::is_tick(now_ns)) access_.step(now_ns);
    if (access_.take_change() && bar_.is_null()) bar_ = {now_ns, "a plug-in was changed"};
    if (run_.now_ns() % options_.digest_every_ns == 0)
      digests_.push_back({run_.now_ns(), replayed_.digest()});
    if (!options_.quiet && now_ns % kPrint_ns == 0) printer_.print(run_.main_controller().events());
  }

  void set_pace(const json& told) {
    const bool plays = told.at("playing").get<bool>();
    if (plays && !playing_) pace_.begin_anew();
    playing_ = plays;
    pace_.set_speed(told.at("speed").get<double>());
  }

  void obey(const json& told) {
    if (told.at("do") == "pace") return set_pace(told);
    const auto id = told.at("id").get<std::uint64_t>();
    json answer{{"answer", id}, {"ok", true}};
    try {
      if (auto result = carry_out(told.at("order"), id)) {
        answer["result"] = std::move(*result);
      } else {
        return;  // it comes later
      }
    } catch (const std::exception& error) {
      answer["ok"] = false;
      answer["text"] = error.what();
    }
    report(true);  // what it has done comes before its answer
    channel_.send(answer);
  }

  std::optional<json> carry_out(const json& order, std::uint64_t id) {
    const auto what = order.at("order").get<std::string>();
    if (what == "geometry") {
      const auto from = order.find("from");
      if (from != order.end() && !from->is_number_unsigned()) {
        throw std::invalid_argument("from is " + from->dump() +
                                    ", but must be the number of a solid, from 0");
      }
      return state_.geometry(from == order.end() ? 0 : from->get<std::size_t>());
    }
    if (what == "push") {
      log_.on_applied(pushes_.take(push_from(order)));
      return json::object();
    }
    if (what == "apply") {
      simulator::ScenarioEvent event =
          simulator::parse_action(order.at("event").get<std::string>(), "event", run_.robot());
      event.at_s = static_cast<double>(run_.now_ns()) * 1e-9;
      require_done_to_robot(event);
      require_replayable(event);
      run_.apply(event);
      log_.on_applied(event);
      return json::object();
    }
    if (steps_left_ > 0) throw std::invalid_argument("the simulation steps already: wait for that");
    steps_left_ = order.at("milliseconds").get<int>();
    step_id_ = id;
    return std::nullopt;
  }

  // What the robot is asked for comes through the robot API, where it is answered.
  void require_done_to_robot(const simulator::ScenarioEvent& event) const {
    const bool is_done = std::holds_alternative<simulator::PushEvent>(event.action) ||
                         mark_of(timed(event, run_.robot())) != "command";
    if (!is_done) {
      throw std::invalid_argument(
          "event is an order to the robot, but must be push, fault, spawn, move or remove: the robot API "
          "takes "
          "orders (/walk_to, /stand, /play_motion, ...)");
    }
  }

  // The plug-in through which people come is none of those that a replay has.
  void require_replayable(const simulator::ScenarioEvent& event) const {
    const auto* const fault = std::get_if<simulator::PluginFault>(&event.action);
    if (fault != nullptr && fault->plugin == options_.api.name) {
      throw std::invalid_argument(
          fault->plugin +
          " keeps the link to this page and is not part of what is simulated: choose another "
          "plug-in, or end its process");
    }
  }

  static simulation::Push push_from(const json& order) {
    return {.link = order.at("link").get<std::string>(),
            .force_N = order.at("force_N").get<std::array<double, 3>>(),
            .frame = static_cast<simulation::Frame>(order.at("frame").get<std::uint32_t>()),
            .duration_s = order.at("duration_s").get<double>()};
  }

  void finish_step() {
    report(true);
    channel_.send({{"answer", step_id_},
                   {"ok", true},
                   {"result", {{"time_s", static_cast<double>(run_.now_ns()) * 1e-9}}}});
  }

  // Where it must not be lost it waits until there is room.
  void report(bool must_arrive) {
    const std::int64_t wall_ns = process::monotonic_ns();
    if (!must_arrive && wall_ns - reported_ns_ < kReport_ns) return;
    std::vector<TimedEvent> events;
    const auto& logged = log_.events();
    const std::size_t told = std::min(logged.size(), events_told_ + kEventsAReport);
    for (std::size_t i = events_told_; i < told; ++i) events.push_back(timed(logged[i], run_.robot()));
    json message{{"at_ns", run_.now_ns()}, {"playing", playing_}, {"events", to_json(events)},
                 {"digests", digests_},    {"bar", bar_},         {"state", state_.describe()}};
    if (must_arrive) {
      channel_.send(message);
    } else if (!channel_.try_send(message)) {
      return;
    }
    reported_ns_ = wall_ns;
    events_told_ = told;
    digests_.clear();
    if (must_arrive && told < logged.size()) report(true);
  }

  const LiveOptions& options_;
  ReplayedRun& replayed_;
  simulator::Cosimulation& run_;
  const CopyChannel& channel_;
  PeoplesAccess access_;
  simulator::CommandLog log_;
  simulator::PushTaker pushes_;
  LiveState state_;
  simulator::Pace pace_{1.0};
  core::EventPrinter printer_{"gaitway simulator"};
  bool playing_ = false;
  int steps_left_ = 0;
  std::uint64_t step_id_ = 0;
  std::int64_t reported_ns_ = 0;
  std::size_t events_told_ = 0;
  std::vector<std::pair<std::int64_t, std::uint64_t>> digests_;
  json bar_;  // from which instant no replay goes on, and why; null: none
};

}  // namespace

void live(const LiveOptions& options, ReplayedRun& run, const CopyChannel& channel, const json& told) {
  signal(SIGCHLD, SIG_DFL);  // the plug-in's process is waited for
  LiveSimulation simulation(options, run, channel);
  simulation.serve(told);
}

}  // namespace gaitway::timeline
