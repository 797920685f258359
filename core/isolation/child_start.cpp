// Starts the child's process, answers what it asks, and waits for it without blocking the ticks. Declarations
// are handed on as if they had been made in this process.
#include "child_start.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <list>
#include <stdexcept>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::core {
namespace {

using facts::kMillisecond_ns;
constexpr std::int64_t kLastMoments_ns = 100 * kMillisecond_ns;

}  // namespace

void StartUp::require(State state, ChildMessage message) const {
  if (state_ != state) {
    throw PluginError(fmt::format("its process sent message {} at the wrong time in its start",
                                  static_cast<std::uint32_t>(message)));
  }
}

StartUp::Next StartUp::take(std::span<const std::byte> message) {
  PacketReader packet(message);
  const auto kind = packet.number<ChildMessage>();
  switch (kind) {
    case ChildMessage::open_topic:
      require(State::constructing, kind);
      return grant([&] { take_topic(packet); });
    case ChildMessage::parameter:
      require(State::constructing, kind);
      return grant([&] { take_parameter(packet); });
    case ChildMessage::set_period:
      require(State::constructing, kind);
      return grant([&] {
        const auto period = packet.number<gaitway_period>();
        check_period(period);
        declarations_.set_period(period);
      });
    case ChildMessage::report: {
      const auto severity = packet.number<gaitway_severity>();
      const std::string text = packet.text();
      declarations_.report(severity, std::string_view(text).substr(0, kLongestReport));
      return Next::wait;
    }
    case ChildMessage::created:
      require(State::constructing, kind);
      library_ = {packet.text(), packet.text(), packet.text(), packet.text()};
      state_ = State::attaching;
      return Next::attach;
    case ChildMessage::attached:
      require(State::attaching, kind);
      state_ = State::attached;
      return Next::done;
    case ChildMessage::constructor_failed:
      require(State::constructing, kind);
      text_ = packet.text();
      state_ = State::failed;
      return Next::failed;
    case ChildMessage::library_failed:
      state_ = State::failed;
      throw PluginError(packet.text());
    default:
      throw PluginError("its process sent a message that no plug-in's process sends");
  }
}

template <class Function>
StartUp::Next StartUp::grant(const Function& function) {
  if (++declared_ > kMostDeclarations) {
    throw PluginError(fmt::format("declares more than {} topics and parameters", kMostDeclarations));
  }
  answer_ = PacketWriter(ChildMessage::granted);
  std::string problem;
  try {
    function();
    return Next::answer;
  } catch (const std::runtime_error& error) {  // PluginError or ConfigurationError
    problem = error.what();
  }
  answer_ = PacketWriter(ChildMessage::refused);
  answer_.text(problem);
  return Next::answer;
}

void StartUp::take_topic(PacketReader& packet) {
  const std::string name = packet.text(), type_name = packet.text();
  gaitway_topic topic{name.c_str(), type_name.c_str(), packet.number<std::uint64_t>(), 0, 0, nullptr};
  topic.size = packet.number<std::uint32_t>();
  const auto access = packet.number<gaitway_access>();
  topic.float_field_count = packet.number<std::uint32_t>();
  std::list<std::string> names;
  std::vector<gaitway_float_field> fields;
  for (std::uint32_t i = 0; i < topic.float_field_count; ++i) {
    gaitway_float_field field{};
    field.name = names.emplace_back(packet.text()).c_str();
    field.offset = packet.number<std::uint32_t>();
    field.count = packet.number<std::uint32_t>();
    field.bytes = packet.number<std::uint32_t>();
    field.rows = packet.number<std::uint32_t>();
    field.lowest = packet.number<double>();
    field.highest = packet.number<double>();
    fields.push_back(field);
  }
  topic.float_fields = fields.data();
  check_topic(&topic, access);
  declarations_.open_topic(topic, access);
}

void StartUp::take_parameter(PacketReader& packet) {
  const std::string name = packet.text(), unit = packet.text(), doc = packet.text();
  std::string text;
  gaitway_parameter wanted{};
  wanted.name = name.c_str();
  wanted.unit = unit.c_str();
  wanted.doc = doc.c_str();
  wanted.fallback = packet.value(text);
  wanted.lowest = packet.number<double>();
  wanted.highest = packet.number<double>();
  wanted.live = packet.number<std::uint32_t>();
  check_parameter(&wanted);
  answer_.value(declarations_.declare_parameter(wanted));
}

ChildPlan::ChildPlan(const PluginEntry& entry, const PluginSource& source, const IsolationOptions& options)
    : binary(find_plugin_child(entry.library)),
      bounds{.memory_limit_bytes = options.memory_limit_bytes,
             .descriptor_limit = options.descriptor_limit,
             .local_sockets = entry.child.local_sockets},
      start_limit_ns(options.start_limit_ns),
      library(entry.library) {
  create.text(library).text(source.configuration_file.parent_path().native());
  create.text(source.robot_directory.native()).text(source.memory_socket.native());
  create.number(static_cast<std::uint32_t>(source.search_path.size()));
  for (const std::filesystem::path& folder : source.search_path) {
    create.text(folder.native());
  }
}

ChildStart::ChildStart(const ChildPlan& plan, PluginDeclarations& declarations)
    : plan_(plan),
      start_up_(declarations),
      child_(std::make_unique<Child>(plan.binary, plan.bounds, plan.library)),
      began_ns_(process::monotonic_ns()) {
  child_->send(plan.create.bytes());
}

bool ChildStart::is_overdue() const noexcept {
  return process::monotonic_ns() - began_ns_ > plan_.start_limit_ns;
}

ChildStart::Progress ChildStart::attend(std::int64_t wait_ns) {
  const std::int64_t end_ns = process::monotonic_ns() + wait_ns;
  for (;;) {
    const bool ended = child_->process().has_ended();  // before the look for messages: none comes after it
    const Receipt receipt = child_->receive();
    const StartUp::Next next =
        receipt == Receipt::packet ? start_up_.take(child_->packet()) : StartUp::Next::wait;
    switch (next) {
      case StartUp::Next::answer:
        child_->send(start_up_.answer());
        break;
      case StartUp::Next::attach:
        return Progress::constructed;
      case StartUp::Next::done:
        return Progress::attached;
      case StartUp::Next::failed:
        return Progress::failed;
      case StartUp::Next::wait:
        break;
    }
    if (ended && receipt != Receipt::packet) {
      throw PluginError(
          fmt::format("its process {} while it constructed the plug-in", child_->process().end()));
    }
    const std::int64_t now_ns = process::monotonic_ns();
    if (receipt == Receipt::closed) {  // one that ends closes it first
      hung_up_ns_ = hung_up_ns_ == 0 ? now_ns : hung_up_ns_;
      if (now_ns - hung_up_ns_ > kLastMoments_ns) {
        throw PluginError(
            "its process closed its connection to the manager while it constructed the plug-in");
      }
    }
    if (is_overdue()) {
      throw PluginError(fmt::format(
          "its process has not constructed the plug-in within {:g} s. Look for a loop or a wait in its "
          "constructor",
          static_cast<double>(plan_.start_limit_ns) * 1e-9));
    }
    if (now_ns >= end_ns) {
      return Progress::waits;  // also when one message follows the other: there are ticks to keep
    }
    if (receipt != Receipt::packet) {
      const bool hung_up = receipt == Receipt::closed;
      const std::int64_t until_ns = hung_up ? std::min(end_ns, hung_up_ns_ + kLastMoments_ns) : end_ns;
      child_->wait_for_message(static_cast<int>((until_ns - now_ns) / kMillisecond_ns + 1), hung_up);
    }
  }
}

}  // namespace gaitway::core
