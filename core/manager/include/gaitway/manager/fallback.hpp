// Who writes a plug-in's topics while it fails: in the same tick, before the plug-ins that depend on them.
#pragma once

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/manager/containment_settings.hpp"
#include "gaitway/manager/managed_plugin.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/plugin/tick.hpp"

namespace gaitway::core {

// Made at set-up, off the tick; its other calls are for the cycle.
class Fallback {
 public:
  Fallback() = default;
  Fallback(const Fallback&) = delete;
  Fallback& operator=(const Fallback&) = delete;
  virtual ~Fallback() = default;

  // The plug-in worked in this tick: should it fail in the next one, its last values are where to go on from.
  virtual void follow(const Tick& tick) noexcept = 0;
  // Writes the topics through the plug-in's own outputs. False: it cannot, for want of inputs.
  virtual bool act(const Tick& tick, ManagedPlugin& through) noexcept = 0;
};

struct FallbackSource {  // what fallbacks are made from
  msgclient::Client& client;
  const std::filesystem::path& robot_directory;
};

// The built-in one of a kind; nullptr where nothing is to be written. Defined above the manager, which knows
// none of them.
[[nodiscard]] std::unique_ptr<Fallback> make_fallback(FallbackKind kind, const FallbackSource& source);

// The kind that a standard topic asks for; none for all others.
[[nodiscard]] FallbackKind fallback_of_topic(std::string_view topic, std::uint64_t type_hash) noexcept;
// Standard topics that a kind writes, and those that it reads for it.
[[nodiscard]] std::span<const std::string_view> topics_written_by(FallbackKind kind) noexcept;
[[nodiscard]] std::span<const std::string_view> topics_read_by(FallbackKind kind) noexcept;

// All that stand in for one plug-in.
class FallbackSet {
 public:
  FallbackSet() = default;
  // As its topics ask for, or as is wanted. Throws PluginError if it writes none of the wanted kind's topics.
  FallbackSet(const ManagedPlugin& plugin, FallbackKind wanted, const FallbackSource& source);

  void follow(const Tick& tick) noexcept;
  // True: every topic of the plug-in was written.
  bool act(const Tick& tick, ManagedPlugin& through) noexcept;

  [[nodiscard]] const std::vector<FallbackKind>& kinds() const noexcept { return kinds_; }
  [[nodiscard]] const std::string& name() const noexcept { return name_; }  // of the kinds; for people
  [[nodiscard]] bool is_none() const noexcept { return kinds_.empty(); }

 private:
  std::vector<FallbackKind> kinds_;
  std::vector<std::unique_ptr<Fallback>> fallbacks_;
  std::string name_ = "none";
  bool complete_ = false;  // it has somebody for every topic
};

}  // namespace gaitway::core
