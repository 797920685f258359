// Reports a hundred numbers in each step, from a thread of its own: more than an answer to the manager holds.
#include <string>
#include <thread>

#include "gaitway/plugin/plugin.hpp"

namespace {

class ReportsFromAThread final : public gaitway::Plugin {
 public:
  explicit ReportsFromAThread(gaitway::Setup& setup) : report_(setup.reporter()) {}
  void step(const gaitway::Tick&) override {
    std::thread([this] {
      for (int i = 0; i < 100; ++i) {
        report_(gaitway::Severity::info, std::to_string(++reported_).c_str());
      }
    }).join();
  }

 private:
  gaitway::Reporter report_;
  int reported_ = 0;
};

}  // namespace

GAITWAY_PLUGIN(ReportsFromAThread, "reports_from_a_thread", "1.0.0", "Reports more than it should")
