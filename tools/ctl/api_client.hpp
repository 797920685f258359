// What every order of `gaitway ctl` uses: where the robot is, and a client of its API that asks one thing
// after the other.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

#include "tools/command_line.hpp"

namespace gaitway::tools {

// The API cannot be reached, or what it says is not understood; for people, with the remedy.
class ApiError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Whether an error of the robot's is that an order came too late to be carried out.
[[nodiscard]] bool tells_of_lateness(std::string_view error) noexcept;

// Nobody listens there, or not yet.
class NobodyThere : public ApiError {
  using ApiError::ApiError;
};

// The server does not let us in: another token, another origin.
class NotLetIn : public ApiError {
  using ApiError::ApiError;
};

// The time-out has passed.
class NoAnswer : public NotDone {
  using NotDone::NotDone;
};

struct ApiAddress {
  std::string url = "ws://127.0.0.1:9090";  // or wss://
  std::filesystem::path token_file;         // empty: no token
  std::filesystem::path ca_file;            // of wss, PEM: whom to trust; empty: the system's
  double timeout_s = 10.0;                  // to connect, and of each answer
  // How long a robot that is not there is waited for, in case it is just coming back: the API to connect to,
  // and what it says of the robot until it has answered once.
  double wait_s = 0.0;
  bool any_name = false;  // of wss: whom `ca_file` vouches for may have another name

  [[nodiscard]] ApiAddress with_timeout(double seconds) const {
    ApiAddress address = *this;
    address.timeout_s = seconds;
    return address;
  }
  [[nodiscard]] ApiAddress with_wait(double seconds) const {
    ApiAddress address = *this;
    address.wait_s = seconds;
    return address;
  }
};

// Says once, on stderr, what is waited for, and how long.
class ReturnWait {
 public:
  explicit ReturnWait(double wait_s);
  // After an attempt that found nobody for this reason. False: the time is over. Else a moment has passed.
  bool once_more(std::string_view reason);

 private:
  double wait_s_;
  std::chrono::steady_clock::time_point end_;
  bool told_ = false;
};

// Blocks; for one thread. All calls throw ApiError and NoAnswer.
class ApiClient {
 public:
  explicit ApiClient(const ApiAddress& address);
  ~ApiClient();
  ApiClient(const ApiClient&) = delete;
  ApiClient& operator=(const ApiClient&) = delete;

  struct ServiceAnswer {
    bool result = false;  // whether the service could be called
    std::string problem;  // why not
  };
  // `values`: filled with what the service answers, `success` and `message` among it.
  ServiceAnswer call(const std::string& service, const nlohmann::json& arguments, nlohmann::json& values);
  // The server has answered a message of this topic with that the robot is not there: waits for a moment, and
  // begins anew, without what was acquired. False: it has told of something else, or the time is over.
  bool await_return(const std::string& topic, std::string_view problem);
  void advertise(const std::string& topic, const std::string& type);
  void publish(const std::string& topic, const nlohmann::json& message);
  // `period_ms`: between two messages at least; 0: all of them.
  void subscribe(const std::string& topic, int period_ms = 0);
  // As the other side names itself, "gaitway/0.1.0"; empty: it does not.
  [[nodiscard]] const std::string& server() const noexcept;
  // The next message of a topic that is subscribed to; nothing when none comes within the time-out. A status
  // of the server's that tells of an error is thrown.
  std::optional<nlohmann::json> next_message();
  // Errors that the server has told of since the last call.
  void throw_reported_errors();
  // Waits so long, and takes what comes meanwhile. Throws ApiError when the connection has ended.
  void rest(double seconds);
  // Calls `work` so often and so long, or until SIGINT or SIGTERM, which also interrupts the call() that it
  // waits in. A second signal ends the program.
  void repeat(const std::function<void()>& work, double period_s, double seconds);

 private:
  class Link;
  // What comes and nobody has asked for: kept for who asks for it.
  void keep(nlohmann::json message);
  ServiceAnswer call_once(const std::string& service, const nlohmann::json& arguments,
                          nlohmann::json& values);
  void connect();
  ApiAddress address_;
  ReturnWait wait_;
  std::unique_ptr<Link> link_;
  bool is_reached_ = false;  // the robot has answered once
  double timeout_s_;
  unsigned last_id_ = 0;
};

// A robot that was restarted is there again in that time.
inline constexpr double kReturn_s = 3.0;

inline constexpr int kExitRefused = 2;
inline constexpr int kExitNoAnswer = kExitNotDone;

struct CtlOptions {
  ApiAddress api = ApiAddress().with_wait(kReturn_s);
  std::optional<std::string> url;
  std::optional<int> port;       // of the API on this computer
  std::filesystem::path socket;  // of the memory block: orders to plug-ins without the API
};
using SharedCtlOptions = std::shared_ptr<CtlOptions>;

void add_address(const CommandLine& command, CtlOptions& options);
// One order below `parent`, with its examples; the robot's address may stand behind it, too.
CommandLine add_order(const CommandLine& parent, const SharedCtlOptions& options, const char* name,
                      const char* help, const char* examples);

// Throws ApiError, NoAnswer, or std::invalid_argument for options that contradict each other.
[[nodiscard]] ApiClient connect(const CtlOptions& options);
// Calls a service that answers `success` and `message`, prints the answer, and returns the exit code.
int call_and_print(ApiClient& client, const std::string& service, const nlohmann::json& arguments);
// The same of a connection of its own.
int order(const CtlOptions& options, const std::string& service, const nlohmann::json& arguments);

void add_robot_orders(const CommandLine& ctl, const SharedCtlOptions& options);
void add_command_orders(const CommandLine& ctl, const SharedCtlOptions& options);
void add_plugin_orders(const CommandLine& ctl, const SharedCtlOptions& options);

}  // namespace gaitway::tools
