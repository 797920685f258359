// Copies `from` to `to`, both topics of type Correction, and adds its parameter `add`: the brick of data-flow
// tests. Without `from` it writes the tick's number.
#include <string>

#include "gaitway/plugin/plugin.hpp"

namespace {

using gaitway::Correction;

class Relay final : public gaitway::Plugin {
 public:
  explicit Relay(gaitway::Setup& setup)
      : add_(setup.parameter("add", 0.0, "m")),
        from_(setup.parameter("from", "")),
        access_(setup.parameter("access", "reads")),
        input_(open(setup)),
        output_(setup.writes<Correction>(setup.parameter("to", "out"))) {
    if (setup.parameter("every_batch", false)) {
      setup.period(gaitway::Period::batch);
    }
  }

  void step(const gaitway::Tick& tick) override {
    const double value = from_.empty()        ? static_cast<double>(tick.tick)
                         : input_.has_value() ? input_.read().com_offset[0]
                                              : -1.0;
    output_.value().com_offset[0] = value + add_;
    output_.publish();
  }

 private:
  gaitway::Input<Correction> open(gaitway::Setup& setup) {
    if (from_.empty()) {
      return setup.reads_optional<Correction>("nothing");
    }
    if (access_ == "reads_previous") {
      return setup.reads_previous<Correction>(from_);
    }
    if (access_ == "reads_previous_optional") {
      return setup.reads_previous_optional<Correction>(from_);
    }
    return access_ == "reads_optional" ? setup.reads_optional<Correction>(from_)
                                       : setup.reads<Correction>(from_);
  }

  double add_;
  std::string from_;
  std::string access_;
  gaitway::Input<Correction> input_;
  gaitway::Output<Correction> output_;
};

}  // namespace

GAITWAY_PLUGIN(Relay, "relay", "1.0.0", "Copies a topic")
