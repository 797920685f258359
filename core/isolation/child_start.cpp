// Starts the child's process, answers what it asks, and waits for it without blocking the ticks.
#include "child_start.hpp"

#include <fmt/format.h>

#include "gaitway/facts/facts.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::core {
namespace {

using facts::kMillisecond_ns;

void make_folder(const std::filesystem::path& folder) {
  std::error_code problem;
  if (!folder.empty()) {
    std::filesystem::create_directories(folder, problem);
  }
  if (problem) {
    throw PluginError(
        fmt::format("its folder '{}' cannot be made: {}. Correct the key 'writes', or its rights",
                    folder.string(), problem.message()));
  }
}

}  // namespace

ChildPlan::ChildPlan(const PluginEntry& entry, const PluginSource& source, const IsolationOptions& options)
    : binary(find_plugin_child()),
      bounds{.memory_limit_bytes = options.memory_limit_bytes,
             .descriptor_limit = options.descriptor_limit,
             .serves_network = entry.child.serves_network},
      start_limit_ns(options.start_limit_ns),
      library(entry.library) {
  make_folder(entry.child.writes);
  create.text(library).text(source.configuration_file.parent_path().native());
  create.text(source.robot_directory.native()).text(source.memory_socket.native());
  create.text(entry.child.writes.native());
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
    if (is_overdue()) {
      throw PluginError(fmt::format(
          "its process has not constructed the plug-in within {:g} s. Look for a loop or a wait in its "
          "constructor",
          static_cast<double>(plan_.start_limit_ns) * 1e-9));
    }
    const std::int64_t now_ns = process::monotonic_ns();
    if (now_ns >= end_ns) {
      return Progress::waits;  // also when one message follows the other: there are ticks to keep
    }
    if (receipt != Receipt::packet) {
      child_->wait_for_message(static_cast<int>((end_ns - now_ns) / kMillisecond_ns + 1));
    }
  }
}

}  // namespace gaitway::core
