// A pre-flight (`gaitway preflight`) in a process of its own: it makes copies of itself, which a process with
// threads must not. What is sent to a robot is sent by that process alone, after its own verdict.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::tools {

// What is to be tried, and sent.
struct FlightTask {
  std::vector<double> walk;  // empty, or m/s ahead, m/s to the left, rad/s
  double walk_s = 10.0;
  std::string motion;
  std::vector<double> goal;  // empty, or x m, y m, yaw rad
  std::vector<std::string> settings;
  std::string reason;  // to send it even if a robot falls

  [[nodiscard]] std::string text() const;  // for people
};

class FlightProcess {
 public:
  enum class State : std::uint8_t { idle, trying, sending, done, not_passed, failed, stopped };

  // `arguments`: of every flight (robot, address, world, how many try it); `out`: folder for verdict and
  // picture.
  FlightProcess(std::vector<std::string> arguments, std::filesystem::path out)
      : arguments_(std::move(arguments)), out_(std::move(out)) {}
  // Ends it, and so what it has the robot do.
  ~FlightProcess();
  FlightProcess(const FlightProcess&) = delete;
  FlightProcess& operator=(const FlightProcess&) = delete;

  // Throws std::invalid_argument while one is under way, std::runtime_error when it cannot be started.
  void start(const FlightTask& task);
  // Hears what it says, and whether it has ended.
  void look();
  // What it sends ends with its connection: a walk and a way, but not a motion, which only a stop of the
  // robot ends.
  void stop(const std::string& why);
  [[nodiscard]] bool is_under_way() const noexcept { return process_ != 0; }

  [[nodiscard]] State state() const noexcept { return state_; }
  [[nodiscard]] const std::string& what() const noexcept { return what_; }
  [[nodiscard]] const std::string& text() const noexcept { return text_; }  // verdict, or why it failed
  [[nodiscard]] std::uint32_t passed() const noexcept { return passed_; }
  [[nodiscard]] std::uint32_t tried() const noexcept { return tried_; }
  // Rises with each picture of the worst robot.
  [[nodiscard]] std::uint32_t pictures() const noexcept { return pictures_; }
  [[nodiscard]] std::filesystem::path picture() const { return out_ / "worst.png"; }

 private:
  void spawn(const std::vector<std::string>& words);
  void hear();
  void take_line(const std::string& line);
  void take_verdict();
  void take_end(int status);

  std::vector<std::string> arguments_;
  std::filesystem::path out_;
  State state_ = State::idle;
  std::string what_, text_, last_line_, heard_, stopped_text_;
  std::uint32_t passed_ = 0, tried_ = 0, pictures_ = 0;
  pid_t process_ = 0;
  bool is_stopped_ = false;
  process::FileDescriptor says_;
};

[[nodiscard]] const char* name(FlightProcess::State state) noexcept;

}  // namespace gaitway::tools
