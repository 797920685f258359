// A call that waits is a note of who asked whom: its arguments have been passed on.
#include "client_services.hpp"

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "client_message.hpp"
#include "gaitway/api/json_codec.hpp"
#include "resource_name.hpp"
#include "service_desk.hpp"

namespace gaitway::api {
namespace {

using nlohmann::json;

constexpr std::string_view kIdPrefix = "call:";

Frame call_frame(const std::string& id, const std::string& service, const json& arguments) {
  auto out = std::make_shared<std::string>(R"({"op":"call_service","id":)");
  append_json_string(*out, id);
  *out += R"(,"service":)";
  append_json_string(*out, service);
  *out += R"(,"args":)" + (arguments.is_null() ? std::string("{}") : arguments.dump()) + "}";
  return {std::move(out), false};
}

Frame response_frame(const ServiceCall& call, bool result, const json& values) {
  auto out = std::make_shared<std::string>();
  begin_response(*out, call, result);
  if (call.encoding == Encoding::cbor) {
    json::to_cbor(values, *out);
  } else {
    *out += values.dump();
  }
  end_response(*out, call);
  return {std::move(out), call.encoding == Encoding::cbor};
}

// Nothing: the id is none that was given to a provider.
std::optional<std::uint64_t> number_in(const json& id) {
  if (!id.is_string() || !id.get_ref<const std::string&>().starts_with(kIdPrefix)) {
    return std::nullopt;
  }
  const std::string_view digits = std::string_view(id.get_ref<const std::string&>()).substr(kIdPrefix.size());
  std::uint64_t number = 0;
  const char* const end = digits.data() + digits.size();
  const auto parsed = std::from_chars(digits.data(), end, number);
  return parsed.ec == std::errc() && parsed.ptr == end ? std::optional(number) : std::nullopt;
}

bool result_in(const json& message) {
  const auto result = message.find("result");
  if (result == message.end() || !result->is_boolean()) {
    throw Refused(result == message.end()
                      ? "result is missing"
                      : "result is " + shown_json(*result) + ", but must be true or false");
  }
  return result->get<bool>();
}

json values_in(const json& message, bool result) {
  const auto values = message.find("values");
  if (values == message.end() || values->is_null()) {
    return json::object();
  }
  if (result && !values->is_object()) {
    throw Refused("values is " + shown_json(*values) + ", but must be an object");
  }
  return *values;
}

}  // namespace

ClientServices::ClientServices(const Limits& limits, Send send, Forward forward)
    : limits_(limits), send_(std::move(send)), forward_(std::move(forward)) {}

void ClientServices::advertise(std::uint64_t provider, const std::string& name, const std::string& type) {
  const std::string service = absolute_name(name);
  if (const auto known = services_.find(service); known != services_.end()) {
    if (known->second.provider != provider) {
      throw Refused("service is " + shown(name) + ", which another connection offers");
    }
    known->second = {provider, type, name};
    return;
  }
  const auto own = std::ranges::count_if(
      services_, [provider](const auto& one) { return one.second.provider == provider; });
  if (static_cast<std::size_t>(own) >= limits_.services) {
    throw Refused("this connection offers " + std::to_string(own) +
                  " services already: unadvertise_service first");
  }
  if (services_.size() >= limits_.client_services) {
    throw Refused("clients offer " + std::to_string(services_.size()) + " services already, and at most " +
                  std::to_string(limits_.client_services) + " are kept");
  }
  services_.emplace(service, ClientService{provider, type, name});
}

bool ClientServices::unadvertise(std::uint64_t provider, const std::string& name) {
  const auto found = services_.find(absolute_name(name));
  if (found == services_.end() || found->second.provider != provider) {
    return false;
  }
  const std::string service = found->first;
  services_.erase(found);
  fail_if([&](const Waiting& waiting) { return waiting.service == service; },
          "its provider offers it no more");
  return true;
}

void ClientServices::require_room(const ServiceCall& call, std::uint64_t provider) const {
  const auto count = [this](const auto& counts) {
    return static_cast<std::size_t>(
        std::ranges::count_if(calls_, [&](const auto& one) { return counts(one.second); }));
  };
  const std::size_t of_caller =
      count([&](const Waiting& waiting) { return waiting.call.client == call.client; });
  if (of_caller >= Orders::kMostOfOneClient) {
    throw Refused("this connection waits for " + std::to_string(of_caller) +
                  " answers already: wait for one of them first");
  }
  const std::size_t of_provider = count([&](const Waiting& waiting) { return waiting.provider == provider; });
  if (of_provider >= limits_.calls_of_provider) {
    throw Refused("service is " + shown(call.service) + ", whose provider has " +
                  std::to_string(of_provider) + " calls to answer already");
  }
  if (calls_.size() >= limits_.calls_of_all) {
    throw Refused("clients have " + std::to_string(calls_.size()) +
                  " calls to answer already: try again later");
  }
}

void ClientServices::call(const ServiceCall& call, const json& arguments, std::int64_t now_ns) {
  const auto service = services_.find(absolute_name(call.service));
  const std::uint64_t provider = service->second.provider;
  try {
    if (!arguments.is_object() && !arguments.is_array() && !arguments.is_null()) {
      throw Refused("args is " + shown_json(arguments) + ", but must be an object or a list");
    }
    require_room(call, provider);
    const std::uint64_t number = ++last_call_;
    Frame frame =
        call_frame(std::string(kIdPrefix) + std::to_string(number), service->second.spelling, arguments);
    if (!forward_(provider, std::move(frame))) {
      throw Refused("service is " + shown(call.service) + ", whose provider takes its calls too slowly");
    }
    calls_.emplace(number, Waiting{call, service->first, provider,
                                   now_ns + std::min(call.timeout_ns, limits_.answer_ns)});
  } catch (const Refused& refused) {
    send_(call, service_failure(call, refused.what()));
  }
}

bool ClientServices::respond(std::uint64_t provider, const json& message) {
  const auto id = message.find("id");
  const auto number = id == message.end() ? std::nullopt : number_in(*id);
  const auto found = number ? calls_.find(*number) : calls_.end();
  if (found == calls_.end() || found->second.provider != provider) {
    return false;
  }
  const ServiceCall call = calls_.extract(found).mapped().call;
  try {
    const bool result = result_in(message);
    send_(call, response_frame(call, result, values_in(message, result)));
  } catch (const Refused& refused) {
    send_(call, service_failure(call, "the provider's answer is of no use: " + std::string(refused.what())));
    throw;
  }
  return true;
}

template <class Over>
void ClientServices::fail_if(const Over& over, std::string_view why) {
  // Who cannot be told may have to go, and ends calls of its own: so they are taken out first.
  std::vector<ServiceCall> ended;
  std::erase_if(calls_, [&](auto& one) {
    const bool is_over = over(one.second);
    if (is_over) {
      ended.push_back(std::move(one.second.call));
    }
    return is_over;
  });
  for (const ServiceCall& call : ended) {
    send_(call, service_failure(call, "service is " + shown(call.service) + ": " + std::string(why)));
  }
}

void ClientServices::step(std::int64_t now_ns) {
  fail_if([now_ns](const Waiting& waiting) { return now_ns >= waiting.ends_ns; },
          "its provider has not answered in time");
}

void ClientServices::leave(std::uint64_t client) {
  std::erase_if(calls_, [client](const auto& one) { return one.second.call.client == client; });
  std::erase_if(services_, [client](const auto& one) { return one.second.provider == client; });
  fail_if([client](const Waiting& waiting) { return waiting.provider == client; },
          "its provider's connection has ended");
}

const ClientService* ClientServices::find(std::string_view name) const {
  const auto found = services_.find(absolute_name(name));
  return found == services_.end() ? nullptr : &found->second;
}

}  // namespace gaitway::api
