// Thousands of seeded runs with everything that may happen to the link, and what holds whatever happens: no
// order is lost in silence, carried out twice or late; stops are counted once; the state converges when the
// fault is over.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <string>
#include <tuple>
#include <utility>

#include "gaitway/link/i2c_bus.hpp"
#include "link_pair.hpp"
#include "repeats.hpp"

namespace gaitway::link::test {
namespace {

#ifdef GAITWAY_LONG
constexpr int kRuns = gaitway::test::repeats(20'000);
#else
constexpr int kRuns = gaitway::test::repeats(2'000);
#endif
constexpr std::int64_t kPump_ns = kMs;
constexpr std::int64_t kValidity_ns = 200 * kMs;
constexpr std::int64_t kLongestWork_ns = 100 * kMs;  // from order to answer
// Hello, first status, all channels anew: on the slowest carrier of these tests.
constexpr std::int64_t kRecovery_ns = 1000 * kMs;

enum class Kind { noise, cut, held_cut, half_cut, module_restart, controller_restart, everything };
constexpr int kKinds = 7;

// A carrier of either sort, and its faults.
class FaultyCarrier {
 public:
  explicit FaultyCarrier(std::uint64_t seed)
      : on_i2c_(seed % 3 == 0), wire_(seed % 3 == 1 ? 0 : 20'000, 64, seed), bus_({}, seed) {}
  Carrier& left() { return on_i2c_ ? bus_.master() : wire_.left(); }
  Carrier& right() { return on_i2c_ ? bus_.slave() : wire_.right(); }
  void advance(std::int64_t until_ns) {
    wire_.advance(until_ns);
    while (bus_.advance(until_ns)) {
    }
  }
  void noise(bool on, std::mt19937_64& random) {
    const double strength =
        on ? std::pow(10.0, -1.5 - 2.5 * std::uniform_real_distribution(0.0, 1.0)(random)) : 0.0;
    wire_.set_faults({strength, strength, strength, strength});
    bus_.set_faults({.address_nack = strength * 10,
                     .data_nack = strength,
                     .arbitration_loss = strength * 10,
                     .stretch = strength,
                     .stuck = strength,
                     .flipped_bit = strength,
                     .stretch_ns = 40 * kMs});
  }
  void cut(bool on, bool holding) {
    wire_.cut(on, holding);
    bus_.stick(0, on ? std::numeric_limits<std::int64_t>::max() : 0);
  }
  void half_cut(bool on) {
    wire_.cut_to_right(on);
    bus_.set_faults({.address_nack = on ? 1.0 : 0.0});
  }

 private:
  bool on_i2c_;
  SimulatedWire wire_;
  I2cBus bus_;
};

struct Ledger {
  std::int64_t submitted_ns = 0, expiry_ns = 0;  // module's time, robot's time
  int module_run = 0;
  int carried_out = 0, outcomes = 0;
  Verdict verdict = Verdict::unanswered;
};

class Play {
 public:
  explicit Play(std::uint64_t seed)
      : random_(seed), carrier_(seed), kind_(static_cast<Kind>(seed / 3 % kKinds)) {
    restart_module();
    restart_controller();
  }

  void play() {
    const std::int64_t fault_ns = draw_ns(300, 500);
    const std::int64_t end_ns = fault_ns + fault_length_ns();
    until(fault_ns);
    begin_fault();
    until(end_ns);
    end_fault();
    until(end_ns + kRecovery_ns);
    busy_ = false;  // the last orders get their outcomes
    until(end_ns + kRecovery_ns + kValidity_ns + LinkSettings{}.answer_limit_ns + 300 * kMs);
    check(end_ns);
  }
  [[nodiscard]] std::int64_t converged_ns() const { return converged_ns_; }
  [[nodiscard]] std::size_t orders() const { return ledger_.size(); }
  [[nodiscard]] std::size_t count(Verdict verdict) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(ledger_, [&](const auto& each) { return each.second.verdict == verdict; }));
  }

 private:
  [[nodiscard]] std::int64_t robot_ns() const {  // another zero, and 100 ppm faster
    return kRobotAhead_ns + now_ns_ + now_ns_ / 10'000;
  }
  std::int64_t draw_ns(int least_ms, int most_ms) {
    return kMs * std::uniform_int_distribution<int>(least_ms, most_ms)(random_);
  }
  bool chance(double probability) { return std::bernoulli_distribution(probability)(random_); }
  std::int64_t fault_length_ns() {  // 0.1 to 10 s, the long ones rarely
    return static_cast<std::int64_t>(
               100.0 * std::pow(100.0, std::pow(std::uniform_real_distribution(0.0, 1.0)(random_), 3.0))) *
           kMs;
  }

  void restart_module() {
    module_ = std::make_unique<ModuleEnd>(module_identity(random_() | 1U), kChannels, LinkSettings{});
    ++module_run_;
    stops_asked_of_run_ = 0;
  }
  void restart_controller() {
    controller_ =
        std::make_unique<ControllerEnd>(controller_identity(random_() | 1U), kChannels, LinkSettings{});
    ++controller_run_;
    stops_before_ += stops_seen_;
    stops_seen_ = 0;
    working_.clear();
    published_.clear();
  }
  void begin_fault() {
    if (kind_ == Kind::noise || kind_ == Kind::everything) carrier_.noise(true, random_);
    if (kind_ == Kind::cut || kind_ == Kind::held_cut) carrier_.cut(true, kind_ == Kind::held_cut);
    if (kind_ == Kind::half_cut) carrier_.half_cut(true);
    restart();
  }
  void restart() {
    if (kind_ == Kind::module_restart || (kind_ == Kind::everything && chance(0.5))) restart_module();
    if (kind_ == Kind::controller_restart || (kind_ == Kind::everything && chance(0.5))) restart_controller();
  }
  void end_fault() {
    carrier_.noise(false, random_);
    carrier_.cut(false, false);
    if (kind_ == Kind::half_cut) carrier_.half_cut(false);
    fault_over_ = true;
  }

  void until(std::int64_t end_ns) {
    while (now_ns_ < end_ns) {
      now_ns_ += kPump_ns;
      if (kind_ == Kind::everything && !fault_over_ && chance(0.002)) restart();
      act_as_robot();
      act_as_module();
      carrier_.advance(now_ns_);
      pump(*module_, carrier_.left(), now_ns_);
      pump(*controller_, carrier_.right(), robot_ns());
      look_for_convergence();
    }
  }

  void act_as_module() {
    if (busy_ && chance(0.03)) submit();
    if (busy_ && chance(0.003)) {
      module_->stop(StopKind::stop);
      ++stops_asked_;
      ++stops_asked_of_run_;
    }
    while (const auto outcome = module_->next_outcome(now_ns_)) {
      const auto found = numbers_.find({module_run_, outcome->id.session, outcome->id.number});
      ASSERT_NE(found, numbers_.end()) << "an outcome of no order";
      Ledger& order = ledger_.at(found->second);
      ++order.outcomes;
      order.verdict = outcome->verdict;
      const std::int64_t took_ns = now_ns_ - order.submitted_ns;
      EXPECT_LE(took_ns, kValidity_ns + LinkSettings{}.answer_limit_ns + kPump_ns) << "its outcome was late";
      if (outcome->verdict != Verdict::unanswered) {
        EXPECT_EQ(order.carried_out, outcome->verdict == Verdict::answered ? 1 : 0);
      }
    }
  }

  void submit() {
    const auto robot = module_->robot_time_ns(now_ns_);
    if (!robot) return;
    EXPECT_LE(*robot, robot_ns());
    const std::int64_t expiry_ns = *robot + draw_ns(1, static_cast<int>(kValidity_ns / kMs));
    const std::uint32_t serial = next_serial_++;
    std::string text(4 + random_() % (chance(0.1) ? 600 : 60), 'o');
    std::memcpy(text.data(), &serial, sizeof serial);
    const Submission submission = module_->submit(1, bytes_of(text), expiry_ns, now_ns_);
    if (submission.refusal != Refusal::none) return;
    ledger_[serial] = {now_ns_, expiry_ns, module_run_};
    numbers_[{module_run_, submission.id.session, submission.id.number}] = serial;
  }

  void act_as_robot() {
    if (!fault_over_ && chance(0.1)) publish(0, 10);
    if (!fault_over_ && chance(0.02)) publish(1, 2900);
    if (!fault_over_ && chance(0.01)) publish(2, 100);
    while (const auto order = controller_->next_order(robot_ns())) {
      std::uint32_t serial = 0;
      ASSERT_GE(order->payload.size(), sizeof serial);
      std::memcpy(&serial, order->payload.data(), sizeof serial);
      Ledger& entry = ledger_.at(serial);
      EXPECT_EQ(++entry.carried_out, 1) << "carried out twice";
      EXPECT_LE(robot_ns(), entry.expiry_ns) << "carried out late";
      EXPECT_EQ(entry.expiry_ns, order->expiry_ns);
      EXPECT_GT(std::pair(order->id.session + 1000U * static_cast<unsigned>(controller_run_), serial),
                last_carried_out_);
      last_carried_out_ = {order->id.session + 1000U * static_cast<unsigned>(controller_run_), serial};
      working_.emplace(robot_ns() + (chance(0.5) ? 0 : draw_ns(0, static_cast<int>(kLongestWork_ns / kMs))),
                       order->id);
    }
    for (; !working_.empty() && working_.begin()->first <= robot_ns(); working_.erase(working_.begin())) {
      controller_->answer(working_.begin()->second, 1, bytes_of("done"));
    }
    stops_seen_ = controller_->stops_asked().stops;
    controller_->stops_obeyed(controller_->stops_asked());
  }

  void publish(std::size_t channel, std::size_t bytes) {
    std::string value(bytes, static_cast<char>('a' + random_() % 26));
    value += std::to_string(++values_);
    ASSERT_TRUE(controller_->publish(channel, bytes_of(value), robot_ns()));
    published_[channel] = value;
  }
  [[nodiscard]] bool agrees() const {
    return std::ranges::all_of(published_, [&](const auto& each) {
      return text_of(module_->state().value(each.first).bytes) == each.second;
    });
  }
  void look_for_convergence() {
    const bool open = module_->session().open() && controller_->session().open();
    if (fault_over_ && converged_ns_ < 0 && open && agrees()) converged_ns_ = now_ns_;
  }

  void check(std::int64_t end_ns) {
    EXPECT_TRUE(module_->session().open());
    EXPECT_EQ(module_->session().tag(), controller_->session().tag());
    EXPECT_TRUE(agrees()) << "the state has not converged";
    converged_ns_ -= end_ns;
    EXPECT_GE(converged_ns_, 0);
    EXPECT_LE(converged_ns_, kRecovery_ns);
    for (const auto& [serial, order] : ledger_) {
      if (order.module_run == module_run_) {
        EXPECT_EQ(order.outcomes, 1) << "order " << serial << " of " << order.submitted_ns;
      } else {
        EXPECT_LE(order.outcomes, 1);
      }
    }
    EXPECT_EQ(module_->stops().obeyed().stops, stops_asked_of_run_);
    const std::uint32_t heard = stops_before_ + stops_seen_;
    if (controller_run_ == 1) {
      EXPECT_LE(heard, stops_asked_) << "stops were doubled";
      EXPECT_TRUE(module_run_ > 1 || heard == stops_asked_) << "stops were lost";
    }
  }

  std::mt19937_64 random_;
  FaultyCarrier carrier_;
  Kind kind_;
  std::unique_ptr<ModuleEnd> module_;
  std::unique_ptr<ControllerEnd> controller_;
  int module_run_ = 0, controller_run_ = 0;
  std::int64_t now_ns_ = 0, converged_ns_ = -1;
  bool busy_ = true, fault_over_ = false;
  std::map<std::uint32_t, Ledger> ledger_;
  std::map<std::tuple<int, std::uint32_t, std::uint32_t>, std::uint32_t> numbers_;
  std::uint32_t next_serial_ = 1;
  std::pair<std::uint32_t, std::uint32_t> last_carried_out_{0, 0};
  std::multimap<std::int64_t, OrderId> working_;
  std::map<std::size_t, std::string> published_;
  int values_ = 0;
  std::uint32_t stops_asked_ = 0, stops_asked_of_run_ = 0, stops_seen_ = 0, stops_before_ = 0;
};

TEST(Faults, NoOrderIsLostInSilenceTwiceOrLateAndTheStateConverges) {
  std::int64_t longest_ns = 0;
  std::size_t orders = 0, answered = 0, late = 0;
  for (int seed = 0; seed < kRuns && !testing::Test::HasFailure(); ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Play run(static_cast<std::uint64_t>(seed));
    run.play();
    longest_ns = std::max(longest_ns, run.converged_ns());
    orders += run.orders();
    answered += run.count(Verdict::answered);
    late += run.count(Verdict::late);
  }
  std::printf(
      "%d runs: %zu orders, %zu answered, %zu late, %zu unanswered; converged after %.0f ms at most\n", kRuns,
      orders, answered, late, orders - answered - late, static_cast<double>(longest_ns) * 1e-6);
}

}  // namespace
}  // namespace gaitway::link::test
