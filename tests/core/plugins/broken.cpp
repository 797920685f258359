// A plug-in for each way to fail: all are built from this file, and the library's name chooses.
#include <unistd.h>

#include <array>
#include <cstdlib>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>

#include "gaitway/plugin/plugin.hpp"

namespace {

constexpr std::string_view kFault = GAITWAY_BROKEN;

// Built from another schema: it has Correction's name and size, but another unit, and so another hash.
struct InMillimetres {
  gaitway::Correction value;
};

}  // namespace

template <>
struct gaitway::TopicType<InMillimetres> {
  static constexpr std::string_view name = "Correction";
  static constexpr std::uint64_t hash = TopicType<Correction>::hash ^ 1;
  static constexpr std::array<FieldDescriptor, 1> kFields{
      {{"com_offset_mm", ScalarType::float64_value, 1, {2}, "mm", "base", "", 8}}};
  static constexpr std::span<const FieldDescriptor> fields{kFields};
};

namespace {

class FailsAtSetUp final : public gaitway::Plugin {
 public:
  explicit FailsAtSetUp(gaitway::Setup& setup) {
    if constexpr (kFault == "crashes_in_constructor") {
      std::abort();
    } else if constexpr (kFault == "hangs_in_constructor") {
      while (true) {
        pause();
      }
    } else if constexpr (kFault == "throws_in_constructor") {
      throw std::runtime_error("no calibration file");
    } else if constexpr (kFault == "other_type_hash") {
      static_cast<void>(setup.reads<InMillimetres>("out"));
    }
  }
  void activate() override {
    if constexpr (kFault == "throws_in_activate") {
      throw std::runtime_error("the camera does not answer");
    }
  }
  void step(const gaitway::Tick&) override {}
};

// Publishes first and throws then, at every third tick; at tick 4 it throws what is no std::exception.
class ThrowsInStep final : public gaitway::Plugin {
 public:
  explicit ThrowsInStep(gaitway::Setup& setup) : output_(setup.writes<gaitway::Correction>("out")) {}
  void step(const gaitway::Tick& tick) override {
    output_.value().com_offset[0] = static_cast<double>(tick.tick);
    output_.publish();
    if (tick.tick % 3 == 0) {
      throw std::runtime_error("matrix is singular");
    }
    if (tick.tick == 4) {
      throw 4;
    }
  }

 private:
  gaitway::Output<gaitway::Correction> output_;
};

// From tick 2 on one element of its output is not a number.
class PublishesNan final : public gaitway::Plugin {
 public:
  explicit PublishesNan(gaitway::Setup& setup) : output_(setup.writes<gaitway::TrimCommand>("out")) {}
  void step(const gaitway::Tick& tick) override {
    output_.value().channel_count = tick.tick;
    if (tick.tick >= 2) {
      output_.value().gain[1][6][3] = std::numeric_limits<double>::quiet_NaN();
    }
    output_.publish();
  }

 private:
  gaitway::Output<gaitway::TrimCommand> output_;
};

// A hundred numbers in each step: more than an answer to the manager holds.
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

template <bool first, class First, class Second>
using Either = std::conditional_t<first, First, Second>;
using Broken = Either<kFault == "throws_in_step", ThrowsInStep,
                      Either<kFault == "publishes_nan", PublishesNan,
                             Either<kFault == "reports_from_a_thread", ReportsFromAThread, FailsAtSetUp>>>;

}  // namespace

GAITWAY_PLUGIN(Broken, GAITWAY_BROKEN, "1.0.0", "Fails in the way that it is called by")
