// Writes trims and corrections of zero, and after some ticks, or while it is activated, takes its whole
// process down, or hangs it.
#include <csignal>
#include <cstdint>
#include <string>

#include "gaitway/plugin/plugin.hpp"

namespace {

using namespace gaitway;

class Crashes final : public Plugin {
 public:
  explicit Crashes(Setup& setup)
      : after_ticks_(setup.parameter("after_ticks", 600)),
        hangs_(setup.parameter("hangs", false)),
        signal_(setup.parameter("signal", 0)),
        in_activate_(setup.parameter("in_activate", false)),
        estimate_(setup.reads_optional<Estimate>("estimate")),
        trim_(setup.writes<TrimCommand>("trim")),
        correction_(setup.writes<Correction>("correction")) {}

  void activate() override {
    if (in_activate_) go_down();
  }
  void step(const Tick& tick) override {
    trim_.value().stamp_ns = correction_.value().stamp_ns = tick.now_ns;
    trim_.value().channel_count = kTrimChannels;
    trim_.publish();
    correction_.publish();
    if (++ticks_ >= after_ticks_) go_down();
  }

 private:
  void go_down() const {
    for (volatile bool on = hangs_; on;) {
    }
    if (signal_ != 0) std::raise(static_cast<int>(signal_));
    volatile int* const nowhere = nullptr;
    *nowhere = 1;
  }

  std::int64_t after_ticks_;
  bool hangs_;
  std::int64_t signal_;  // what takes the process down; 0: a write to nowhere
  bool in_activate_;
  std::int64_t ticks_ = 0;
  Input<Estimate> estimate_;
  Output<TrimCommand> trim_;
  Output<Correction> correction_;
};

}  // namespace

GAITWAY_PLUGIN(Crashes, "crashes", "1.0.0", "Takes its process down")
