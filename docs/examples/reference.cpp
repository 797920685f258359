// One plug-in that uses the whole interface in C++; docs/plugin-interface.md shows its parts. It smooths the
// trunk's lean, presses the ankles against it, warns, and publishes it as a topic of its own.
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "gaitway/plugin/plugin.hpp"
#include "reference/topics.hpp"

namespace {

constexpr std::int64_t kEstimateLifetime_ns = 100'000'000;

enum class Axes : std::uint8_t { both, pitch, roll };

Axes axes_of(const std::string& text) {
  if (text != "both" && text != "pitch" && text != "roll") {
    throw std::invalid_argument("axes '" + text + "': must be both, pitch or roll");
  }
  return text == "both" ? Axes::both : text == "pitch" ? Axes::pitch : Axes::roll;
}

// A part of the plug-in with a state of its own.
class Smoothed {
 public:
  // A number that is none would stay for ever.
  void update(double value, double share) noexcept {
    value_ += std::isfinite(value) ? share * (value - value_) : 0.0;
  }
  [[nodiscard]] double value() const noexcept { return value_; }
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.value_);
  }

 private:
  double value_ = 0.0;
};

class Lean final : public gaitway::Plugin {
 public:
  explicit Lean(gaitway::Setup& setup)
      : gain_(
            setup.live_parameter("gain", 0.25, "rad/rad",
                                 {.lowest = 0.0, .highest = 1.0, .doc = "ankle trim for the trunk's lean"})),
        share_(setup.parameter("share", 0.5, "1", {.lowest = 0.01, .highest = 1.0})),
        warn_at_rad_(setup.parameter("warn_at", 0.1, "rad", {.lowest = 0.0})),
        most_warnings_(setup.live_parameter("most_warnings", 10, "1", {.lowest = 0})),
        corrects_(setup.live_parameter("corrects", true, "turns the base upright, too")),
        axes_(axes_of(setup.parameter("axes", "both", "both, pitch or roll"))),
        estimate_(setup.reads<gaitway::Estimate>("estimate")),
        plan_(setup.reads_previous<gaitway::MotionPlan>("motion_plan")),
        command_(setup.reads_optional<gaitway::WalkCommand>("walk_command")),
        trim_(setup.writes<gaitway::TrimCommand>("trim")),
        correction_(setup.writes<gaitway::Correction>("correction")),
        lean_(setup.writes<gaitway::LeanState>("lean")),
        report_(setup.reporter()) {
    setup.period(gaitway::Period::tick);
    if (!std::filesystem::exists(setup.robot_directory() / "robot.yaml")) {
      throw gaitway::SetupError("needs the robot's description");
    }
  }

  void activate() override { trim_.value().channel_count = 8; }

  void step(const gaitway::Tick& tick) override {
    if (!estimate_.has_value() || estimate_.age_ns(tick.now_ns) > kEstimateLifetime_ns) {
      return;  // nothing is published: readers keep the last values, and see their age
    }
    if (estimate_.sequence() != seen_) {
      seen_ = estimate_.sequence();
      smooth(estimate_.read());
    }
    write_trim(tick);
    write_correction(tick);
    warn();
    lean_.value() = {.stamp_ns = tick.now_ns,
                     .lean = {lean_rad_[0].value(), lean_rad_[1].value()},
                     .warnings = warnings_,
                     .padding0 = {}};
    lean_.publish();
  }

  void deactivate() override { report_(gaitway::Severity::info, "leans no more"); }

  [[nodiscard]] std::uint32_t state_version() const override { return 1; }
  void save_state(gaitway::StateWriter& state) const override {
    state(lean_rad_[0], lean_rad_[1], seen_, warnings_, leant_);
  }
  void restore_state(gaitway::StateReader& state) override {
    state(lean_rad_[0], lean_rad_[1], seen_, warnings_, leant_);
  }

 private:
  void smooth(const gaitway::Estimate& estimate) {
    if (axes_ != Axes::pitch) lean_rad_[0].update(estimate.attitude[0], share_);
    if (axes_ != Axes::roll) lean_rad_[1].update(estimate.attitude[1], share_);
  }

  void write_trim(const gaitway::Tick& tick) {
    gaitway::TrimCommand& trim = trim_.value();
    trim.stamp_ns = tick.now_ns;
    trim.angle[4] = trim.angle[5] = gain_ * lean_rad_[1].value();  // ankle pitch, left and right
    trim.angle[6] = trim.angle[7] = gain_ * lean_rad_[0].value();  // ankle roll
    trim_.publish();
  }

  // While a plan is there and a walk is commanded, the base is turned upright.
  void write_correction(const gaitway::Tick& tick) {
    const bool walks = plan_.has_value() && plan_.read().sequence != 0 && command_.read().walk != 0;
    gaitway::Correction& correction = correction_.value();
    correction.stamp_ns = tick.now_ns;
    correction.base_attitude_offset[1] = corrects_ && walks ? -0.1 * lean_rad_[1].value() : 0.0;
    correction_.publish();
  }

  void warn() {
    const bool leans = std::hypot(lean_rad_[0].value(), lean_rad_[1].value()) > warn_at_rad_;
    if (leans && !leant_ && warnings_ < most_warnings_.get()) {
      std::array<char, 80> text{};
      std::snprintf(text.data(), text.size(), "leans by %.2f rad", lean_rad_[1].value());
      report_(gaitway::Severity::warning, text.data());
      ++warnings_;
    }
    leant_ = leans;
  }

  gaitway::Live<double> gain_;
  double share_, warn_at_rad_;
  gaitway::Live<std::int64_t> most_warnings_;
  gaitway::Live<bool> corrects_;
  Axes axes_;
  std::array<Smoothed, 2> lean_rad_{};  // roll, pitch
  std::uint64_t seen_ = 0;
  std::uint32_t warnings_ = 0;
  bool leant_ = false;
  gaitway::Input<gaitway::Estimate> estimate_;
  gaitway::Input<gaitway::MotionPlan> plan_;
  gaitway::Input<gaitway::WalkCommand> command_;
  gaitway::Output<gaitway::TrimCommand> trim_;
  gaitway::Output<gaitway::Correction> correction_;
  gaitway::Output<gaitway::LeanState> lean_;
  gaitway::Reporter report_;
};

}  // namespace

GAITWAY_PLUGIN(Lean, "lean", "1.0.0", "Presses the ankles against the trunk's lean")
