// Two of them bring about a crash beside the ticks: one that `leaves` waits, when it is destroyed, until the
// other one is being stepped, and then aborts. They meet by files in the folder `meeting`.
#include <sched.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "gaitway/plugin/plugin.hpp"

namespace {

class CrashesWhenItLeaves final : public gaitway::Plugin {
 public:
  explicit CrashesWhenItLeaves(gaitway::Setup& setup)
      : leaving_(setup.parameter("meeting", "/nowhere") + "/leaving"),
        stepping_(setup.parameter("meeting", "/nowhere") + "/stepping"),
        leaves_(setup.parameter("leaves", false)) {}
  ~CrashesWhenItLeaves() override {
    if (!leaves_ || !stepped_ || std::filesystem::exists(stepping_)) {
      return;
    }
    std::ofstream(leaving_).put('x');
    while (!std::filesystem::exists(stepping_)) {
      sched_yield();
    }
    std::abort();
  }

  void step(const gaitway::Tick&) override {
    stepped_ = true;
    if (!leaves_ && std::filesystem::exists(leaving_) && !std::filesystem::exists(stepping_)) {
      std::ofstream(stepping_).put('x');
      for (volatile bool on = true; on;) {
      }
    }
  }

 private:
  std::string leaving_, stepping_;
  bool leaves_;
  bool stepped_ = false;
};

}  // namespace

GAITWAY_PLUGIN(CrashesWhenItLeaves, "crashes_when_it_leaves", "1.0.0", "Aborts beside the ticks")
