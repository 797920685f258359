// Counts its steps and hands the count on; in the tick that its parameter `at` names it does what its
// parameter `how` says. Only for a process of its own.
#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>

#include "gaitway/core/plugin.hpp"

namespace {

class Misbehaves final : public gaitway::Plugin {
 public:
  explicit Misbehaves(gaitway::Setup& setup)
      : how_(setup.parameter("how", "none")),
        at_(setup.parameter("at", 3)),
        output_(setup.writes<gaitway::Correction>("out")) {}

  void step(const gaitway::Tick& tick) override {
    output_.value().com_offset[0] = static_cast<double>(++steps_);
    output_.publish();
    if (static_cast<std::int64_t>(tick.tick) == at_ || (how_ == "always" && tick.tick >= 3)) {
      misbehave();
    }
  }
  [[nodiscard]] std::uint32_t state_version() const override { return 1; }
  void save_state(gaitway::StateWriter& state) const override { state(steps_); }
  void restore_state(gaitway::StateReader& state) override { state(steps_); }

 private:
  void misbehave() {
    if (how_ == "segfault") {
      *static_cast<volatile int*>(nullptr_) = 1;
    } else if (how_ == "abort" || how_ == "always") {
      std::abort();
    } else if (how_ == "exit") {
      std::exit(7);
    } else if (how_ == "loop") {
      for (volatile bool on = true; on;) {
      }
    } else if (how_ == "memory") {
      for (;;) {
        leaked_ = new char[1U << 20U];
      }
    } else if (how_ == "descriptors") {
      while (open("/dev/null", O_RDONLY) >= 0) {
      }
      throw std::runtime_error(std::string("cannot open the camera: ") + std::strerror(errno));
    } else if (how_ == "fork") {
      if (fork() == 0) {
        _exit(0);
      }
    } else if (how_ == "garbage") {
      overwrite_exchange();
    }
  }
  static void overwrite_exchange() {
    std::FILE* const maps = std::fopen("/proc/self/maps", "r");
    char line[512];
    while (maps != nullptr && std::fgets(line, sizeof line, maps) != nullptr) {
      unsigned long begin = 0, end = 0;
      if (std::strstr(line, "exchange") != nullptr && std::sscanf(line, "%lx-%lx", &begin, &end) == 2) {
        std::memset(reinterpret_cast<void*>(begin), 0xa5, end - begin);
      }
    }
  }

  std::string how_;
  std::int64_t at_;
  void* volatile nullptr_ = nullptr;
  char* volatile leaked_ = nullptr;  // volatile: or the compiler leaves the leak out
  std::uint32_t steps_ = 0;
  gaitway::Output<gaitway::Correction> output_;
};

}  // namespace

GAITWAY_PLUGIN(Misbehaves, "misbehaves", "1.0.0", "Fails in the way that it is told")
