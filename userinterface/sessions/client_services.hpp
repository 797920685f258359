// Services that clients offer: calls of others are passed on to their provider, and its answers back.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "gaitway/api/limits.hpp"
#include "gaitway/api/session.hpp"
#include "service_call.hpp"

namespace gaitway::api {

struct ClientService {
  std::uint64_t provider = 0;  // Claimant::number
  std::string type;
  std::string spelling;  // of the name, as the provider knows it
};

// Each call gets an id of its own on its way to the provider, and only that provider can answer it, once.
class ClientServices {
 public:
  // Takes an answer to its client, if that is still there.
  using Send = std::function<void(const ServiceCall& call, Frame frame)>;
  // Takes a call to a provider; false: it leaves too much unread.
  using Forward = std::function<bool(std::uint64_t provider, Frame frame)>;

  ClientServices(const Limits& limits, Send send, Forward forward);
  ClientServices(const ClientServices&) = delete;
  ClientServices& operator=(const ClientServices&) = delete;

  // Throws Refused: another client offers it, or there are too many. `name`: as the client wrote it.
  void advertise(std::uint64_t provider, const std::string& name, const std::string& type);
  // Its calls fail. False: this client does not offer it.
  bool unadvertise(std::uint64_t provider, const std::string& name);

  // Answers by `send`, now or later. The service is one that find() knows.
  void call(const ServiceCall& call, const nlohmann::json& arguments, std::int64_t now_ns);
  // A service_response. False: no call with this id waits for an answer of this client. Throws Refused for a
  // wrong field; the call has failed then.
  bool respond(std::uint64_t provider, const nlohmann::json& message);

  // Ends what has waited for too long.
  void step(std::int64_t now_ns);
  // The client is gone: calls of its services fail, its own calls are answered to nobody.
  void leave(std::uint64_t client);

  // Nothing: no client offers it.
  [[nodiscard]] const ClientService* find(std::string_view name) const;
  // By absolute name.
  [[nodiscard]] const std::map<std::string, ClientService, std::less<>>& all() const noexcept {
    return services_;
  }

 private:
  struct Waiting {
    ServiceCall call;
    std::string service;  // its absolute name
    std::uint64_t provider = 0;
    std::int64_t ends_ns = 0;
  };
  void require_room(const ServiceCall& call, std::uint64_t provider) const;
  // Those for which over(waiting) holds fail, and why.
  template <class Over>
  void fail_if(const Over& over, std::string_view why);

  const Limits& limits_;
  Send send_;
  Forward forward_;
  std::map<std::string, ClientService, std::less<>> services_;
  std::map<std::uint64_t, Waiting> calls_;  // by the number in their ids
  std::uint64_t last_call_ = 0;
};

}  // namespace gaitway::api
