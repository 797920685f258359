// Presses the ankles against the trunk's lean, and breaks exactly one rule: GAITWAY_FAULT_<name> says which.
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "fault_flags.hpp"
#include "gaitway/plugin/plugin.hpp"

namespace {

constexpr double kLargestTrim_rad = 0.2;
constexpr std::uint32_t kJoints = 22;

void crash() {
  std::abort();
}

double shared_lean = 0.0;  // of shares_static

[[gnu::noinline]] void* escape(void* memory) {
  asm volatile("" : "+r"(memory) : : "memory");
  return memory;
}

class Misbehaving final : public gaitway::Plugin {
 public:
  explicit Misbehaving(gaitway::Setup& setup)
      : memory_on_refusal_(keeps_memory_on_refusal ? escape(std::malloc(4096)) : nullptr),
        gain_(setup.live_parameter("gain", 0.25, "rad/rad", {.lowest = 0.0, .highest = 1.0})),
        filter_s_(setup.parameter("filter", 0.05, "s", {.lowest = bad_default ? 0.1 : 0.0, .highest = 10.0})),
        solver_(setup.parameter("solver", "auto")),
        imu_(setup.reads<gaitway::Imu>("imu")),
        joints_(setup.reads<gaitway::JointStates>("joint_states")),
        trim_(setup.writes<gaitway::TrimCommand>("trim")) {
    std::free(memory_on_refusal_);
    construct();
  }
  ~Misbehaving() override {
    if (crashes_on_destroy_without_activate && !activated_) crash();
  }
  void activate() override {
    if (crashes_on_second_activate && activated_) crash();
    activated_ = true;
  }
  void step(const gaitway::Tick& tick) override {
    before_step(tick);
    const gaitway::Imu& imu = imu_.read();
    const gaitway::JointStates& joints = joints_.read();
    if (!imu_.has_value() || !joints_.has_value()) {
      if (crashes_on_missing_input) crash();
      return;
    }
    if (crashes_on_joint_count && joints.joint_count > kJoints) crash();
    const double lean = imu.inclination[1];
    if (!std::isfinite(lean)) {
      poisoned_ = true;
      if (!publishes_nan_on_nan) return;
    }
    if (never_recovers && poisoned_) return;
    double& filtered = shares_static ? shared_lean : lean_;
    filtered += 0.01 / (0.01 + filter_s_) * (lean - filtered);
    publish(tick, filtered);
  }
  [[nodiscard]] std::uint32_t state_version() const override { return 1; }
  void save_state(gaitway::StateWriter& state) const override {
    state(steps_);
    if (!forgets_state) state(lean_);
  }
  void restore_state(gaitway::StateReader& state) override {
    state(steps_);
    if (!forgets_state) state(lean_);
    if (wrong_state_size) state(lean_);  // was never saved
    double ignored = 0.0;
    while (takes_any_state && state.remaining() >= sizeof ignored) state(ignored);
  }

 private:
  void construct();
  void before_step(const gaitway::Tick& tick);
  void publish(const gaitway::Tick& tick, double lean);

  void* memory_on_refusal_;
  gaitway::Live<double> gain_;
  double filter_s_;
  std::string solver_;
  gaitway::Input<gaitway::Imu> imu_;
  gaitway::Input<gaitway::JointStates> joints_;
  gaitway::Output<gaitway::TrimCommand> trim_;
  std::mutex mutex_;
  double lean_ = 0.0;
  double bias_ = 0.0;  // of what a plug-in may not depend on
  std::uint64_t steps_ = 0;
  bool activated_ = false;
  bool poisoned_ = false;
};

void Misbehaving::construct() {
  if (leaks_memory) escape(std::malloc(200));
  if (leaks_descriptor) static_cast<void>(open("/dev/null", O_RDONLY | O_CLOEXEC));
  if (starts_thread) std::thread([] { std::this_thread::sleep_for(std::chrono::hours(1)); }).detach();
  if (depends_on_address) bias_ = static_cast<double>(reinterpret_cast<std::uintptr_t>(this) >> 4U) * 1e-18;
  if (depends_on_uninitialised) {
    auto* const bytes = static_cast<unsigned char*>(escape(std::malloc(64)));
    bias_ = bytes[40] * 1e-5;
    std::free(bytes);
  }
  if (depends_on_time) {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    bias_ = static_cast<double>(now.count() % 1000003) * 1e-9;
  }
  if (hangs_in_create) std::this_thread::sleep_for(std::chrono::hours(1));
  if (fails_in_create) throw std::runtime_error("no calibration file");
  const bool odd = filter_s_ == 10.0;
  if (crashes_on_parameter && odd) crash();
  if (hangs_on_parameter && odd) std::this_thread::sleep_for(std::chrono::hours(1));
  if (nan_on_parameter && odd) filter_s_ = std::numeric_limits<double>::quiet_NaN();
}

void Misbehaving::before_step(const gaitway::Tick& tick) {
  ++steps_;
  if (allocates) std::free(escape(std::malloc(64)));
  if (locks) const std::lock_guard lock(mutex_);
  if (calls_system) syscall(SYS_getppid);
  if (throws_in_step && tick.tick % 100 == 99) throw std::runtime_error("matrix is singular");
  if (crashes_on_live_change && gain_ == 1.0) crash();
  if (too_slow && tick.batch) {
    volatile double sum = 0.0;  // each addition waits for the one before: some milliseconds on any machine
    for (int i = 0; i < 3'000'000; ++i) sum = sum + 1e-9;
  }
}

void Misbehaving::publish(const gaitway::Tick& tick, double lean) {
  gaitway::TrimCommand& trim = trim_.value();
  trim.stamp_ns = tick.now_ns;
  trim.channel_count = 8;
  const double angle = std::clamp(gain_ * lean, -kLargestTrim_rad, kLargestTrim_rad) + bias_;
  trim.angle[4] = trim.angle[5] = publishes_nan_on_nan && !std::isfinite(lean) ? lean : angle;
  if (nan_on_parameter && !std::isfinite(filter_s_)) trim.angle[4] = filter_s_;
  if (publishes_nan && tick.tick > 20) trim.angle[3] = std::numeric_limits<double>::quiet_NaN();
  if (out_of_range && tick.tick > 20) trim.softness = 1.5;
  if (jumps) trim.angle[3] = tick.tick % 64 < 32 ? 0.15 : -0.15;
  trim_.publish();
}

}  // namespace

GAITWAY_PLUGIN(Misbehaving, "misbehaving", bad_version ? "one" : "1.0.0", "Breaks one rule")
