// A child from its first moment until its plug-in is constructed and its memory is shared: what StartUp
// decides is carried out here.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <string>

#include "child.hpp"
#include "gaitway/isolation/settings.hpp"
#include "gaitway/manager/loaded_plugin.hpp"
#include "start_up.hpp"

namespace gaitway::core {

// What each child of one plug-in is started with.
struct ChildPlan {
  // `entry` and `source` are copied. Makes the folder that it may write to. Throws PluginError.
  ChildPlan(const PluginEntry& entry, const PluginSource& source, const IsolationOptions& options);

  std::filesystem::path binary;
  ChildBounds bounds;
  std::int64_t start_limit_ns;
  std::string library;  // as the configuration names it
  PacketWriter create{ChildMessage::create};
};

class ChildStart {
 public:
  enum class Progress : std::uint8_t { waits, constructed, failed, attached };

  // Starts it. All outlive this. Throws PluginError.
  ChildStart(const ChildPlan& plan, PluginDeclarations& declarations);

  // Answers what it asks, for at most so long; for longer only if one message follows the other. Constructed:
  // now child() is to be attached; failed: the constructor, text() says why. Throws PluginError when it ends,
  // hangs or cannot be understood.
  Progress attend(std::int64_t wait_ns);
  [[nodiscard]] bool is_overdue() const noexcept;
  [[nodiscard]] const std::string& text() const noexcept { return start_up_.text(); }
  [[nodiscard]] Child& child() noexcept { return *child_; }
  [[nodiscard]] std::unique_ptr<Child> take_child() noexcept { return std::move(child_); }
  [[nodiscard]] const LibraryDescription& library() const noexcept { return start_up_.library(); }

 private:
  const ChildPlan& plan_;
  StartUp start_up_;
  std::unique_ptr<Child> child_;
  std::int64_t began_ns_;
};

}  // namespace gaitway::core
