// A client of the robot API for programs that ask one thing after the other.
#pragma once

#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stdexcept>
#include <string>

namespace gaitway::tools {

// The API cannot be reached, or what it says is not understood; for people, with the remedy.
class ApiError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct ApiAddress {
  std::string url = "ws://127.0.0.1:9090";  // or wss://
  std::filesystem::path token_file;         // empty: no token
  std::filesystem::path ca_file;            // of wss, PEM: whom to trust; empty: the system's
  double timeout_s = 10.0;                  // of each answer
};

// Blocks; for one thread. All calls throw ApiError.
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
  void advertise(const std::string& topic, const std::string& type);
  void publish(const std::string& topic, const nlohmann::json& message);
  void subscribe(const std::string& topic);
  // The next message of a topic that is subscribed to; nothing when none comes within the time-out. A status
  // of the server's that tells of an error is thrown.
  std::optional<nlohmann::json> next_message();
  // Errors that the server has told of since the last call.
  void throw_reported_errors();

 private:
  class Link;
  std::unique_ptr<Link> link_;
  unsigned last_id_ = 0;
};

}  // namespace gaitway::tools
