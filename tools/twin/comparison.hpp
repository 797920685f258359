// A real robot and a simulated one that is told the same, compared: how far behind the simulated one is, how
// far apart the two are in every joint, in attitude, load and place, and what of it is worth telling.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"
#include "tools/twin/robot_news.hpp"
#include "tools/twin/robot_watch.hpp"
#include "tools/twin/track.hpp"

namespace gaitway::tools {

struct Channel {
  std::string name;
  const char* unit = "rad";
  double limit = 0.0;  // a difference (RMS) above it is told; 0: it never is
};

// Of each channel; NaN: not known.
struct ChannelValues {
  double measured = std::numeric_limits<double>::quiet_NaN();
  double simulated = std::numeric_limits<double>::quiet_NaN();
  double difference = std::numeric_limits<double>::quiet_NaN();  // RMS over kWindow_s
};

class Comparison {
 public:
  enum class Robot : std::uint8_t { real, simulated };
  static constexpr double kWindow_s = 2.0;
  // Looked for from -kLongestLag_s. The simulated robot hears of an order when the real one has begun to obey
  // it, and obeys with a batch of its own; of a way, when it has planned it.
  static constexpr double kLongestLag_s = 0.6;
  // So long a difference lasts before it is told: the one at a beginning or an end is of the lag.
  static constexpr double kLasts_s = kWindow_s + 0.6;

  explicit Comparison(const urdf::RobotModel& robot);

  // False: the robot's clock was set anew, and what was measured before is forgotten.
  bool take(Robot robot, const ArrivedPoint& point);
  // What was measured before belongs to another life of that robot.
  void forget(Robot robot);
  // That robot does not do the same as the other one. Where it stands is still known.
  void pause(Robot robot);
  // Compares, five times a second. `now_s`: this computer's monotonic clock.
  void look(double now_s);

  [[nodiscard]] const std::vector<Channel>& channels() const noexcept { return channels_; }
  [[nodiscard]] const std::vector<ChannelValues>& values() const noexcept { return values_; }
  // s that the simulated robot is behind; nothing: neither has moved, so it is not known.
  [[nodiscard]] std::optional<double> lag_s() const noexcept { return lag_s_; }
  // Differences that have become worth telling since the last call, in a sentence; empty: there are none.
  [[nodiscard]] std::string take_news();

 private:
  // From a robot's clock to this computer's, by the messages of the last seconds that were under way the
  // shortest. A simulated robot's clock falls behind where the computer is too slow.
  class ClockFit {
   public:
    // The instant [s] here; nothing: that clock was set anew.
    [[nodiscard]] std::optional<double> here(double stamp_s, double arrived_s);
    void forget() noexcept { *this = {}; }

   private:
    std::optional<double> offset_s_, offset_before_s_;  // of this span of time, and of the one before
    double began_s_ = 0.0, last_stamp_s_ = 0.0;
  };
  struct Half {
    ClockFit clock;
    std::array<Track, kMeasurements> tracks;
  };

  [[nodiscard]] const Track& track(Robot robot, Measurement what) const;
  [[nodiscard]] static bool is_known(double now_s, const Track& track);
  void find_lag(double until_s);
  [[nodiscard]] std::optional<double> squared_difference(double lag_s, double from_s, double until_s) const;
  // Over the window that ends then, with the lag that was found in it.
  void compare(Measurement what, std::size_t first_channel, double until_s);
  void compare_places(std::size_t first_channel);
  void tell(double now_s);

  std::vector<Channel> channels_;
  std::vector<ChannelValues> values_;
  // Of each channel: since when its difference is above the limit; 0: it is not. And whether that was told.
  std::vector<double> above_since_s_;
  std::vector<bool> is_told_;
  std::string news_;
  std::array<Half, 2> halves_;
  std::optional<double> lag_s_;
  double looked_s_ = 0.0;
};

}  // namespace gaitway::tools
