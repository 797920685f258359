// Counts its steps and hands the count on; in the tick that its parameter `at` names it does what its
// parameter `how` says ("always": aborts in each from the third on). Only for a process of its own.
#include <string>

#include "gaitway/plugin/plugin.hpp"
#include "misbehaviour.hpp"

namespace {

class Misbehaves final : public gaitway::Plugin {
 public:
  explicit Misbehaves(gaitway::Setup& setup)
      : how_(setup.parameter("how", "none")),
        at_(setup.parameter("at", 3)),
        misbehaviour_(how_ == "always" ? "abort" : how_),
        output_(setup.writes<gaitway::Correction>("out")) {}

  void step(const gaitway::Tick& tick) override {
    output_.value().com_offset[0] = static_cast<double>(++steps_);
    output_.publish();
    if (static_cast<std::int64_t>(tick.tick) == at_ || (how_ == "always" && tick.tick >= 3)) {
      misbehaviour_.begin();
    }
  }
  [[nodiscard]] std::uint32_t state_version() const override { return 1; }
  void save_state(gaitway::StateWriter& state) const override { state(steps_); }
  void restore_state(gaitway::StateReader& state) override { state(steps_); }

 private:
  std::string how_;
  std::int64_t at_;
  Misbehaviour misbehaviour_;
  std::uint32_t steps_ = 0;
  gaitway::Output<gaitway::Correction> output_;
};

}  // namespace

GAITWAY_PLUGIN(Misbehaves, "misbehaves", "1.0.0", "Fails in the way that it is told")
