// The library under check and its instances, with every call noted on the board.
#pragma once

#include <array>
#include <filesystem>
#include <string_view>

#include "gaitway/instance/managed_plugin.hpp"
#include "gaitway/plugin/abi.h"
#include "tools/check_plugin/board.hpp"
#include "tools/check_plugin/replay_host.hpp"

namespace gaitway::plugin_check {

class SpecimenLibrary {
 public:
  // Loads the file itself, not a copy, so that addresses in it have its name. Throws std::runtime_error.
  SpecimenLibrary(const std::filesystem::path& file, Board& board);
  // Leaves the library loaded: a thread that the plug-in forgot may still run in it.
  ~SpecimenLibrary() = default;
  SpecimenLibrary(const SpecimenLibrary&) = delete;
  SpecimenLibrary& operator=(const SpecimenLibrary&) = delete;
  void unload() noexcept;

  [[nodiscard]] const gaitway_plugin& entry() const noexcept { return *entry_; }
  [[nodiscard]] Board& board() const noexcept { return board_; }

 private:
  Board& board_;
  void* handle_ = nullptr;
  const gaitway_plugin* entry_ = nullptr;
};

// What of the stack below a call is filled with before it, so that what a plug-in does not initialise is
// seen.
void set_stack_fill(int fill) noexcept;

class Specimen {
 public:
  Specimen(const SpecimenLibrary& library, const Job& job, const NominalRecord* record)
      : library_(library), host_(job, record) {}
  ~Specimen() { destroy(); }
  Specimen(const Specimen&) = delete;
  Specimen& operator=(const Specimen&) = delete;

  // All answer whether it went well; error() says why not.
  bool create() noexcept;
  bool activate() noexcept;
  bool deactivate() noexcept;
  void destroy() noexcept;
  // Leaves the instance to the end of the process.
  void abandon() noexcept { created_ = false; }
  bool set_parameter(const char* name, const gaitway_value& value) noexcept;
  bool save_state(core::PluginState& state, std::uint32_t capacity) noexcept;
  bool restore_state(const core::PluginState& state) noexcept;

  // A step, if one is due at this tick of the record: feeds, prepares, runs. True also if none is due.
  bool step(const NominalRecord& record, std::uint64_t n, const InputFault& fault = {}) noexcept;
  // The parts of it, for those who look at the call alone. False: none is due.
  [[nodiscard]] bool prepare_step(const NominalRecord& record, std::uint64_t n,
                                  const InputFault& fault = {}) noexcept;
  bool run_step() noexcept;

  [[nodiscard]] std::string_view error() const noexcept { return error_.data(); }
  [[nodiscard]] ReplayHost& host() noexcept { return host_; }
  [[nodiscard]] const gaitway_instance& functions() const noexcept { return instance_; }
  [[nodiscard]] Board& board() const noexcept { return library_.board(); }

 private:
  template <class Function>
  bool call(Call what, const Function& function) noexcept;
  [[nodiscard]] gaitway_text error_text() noexcept;
  void set_error(std::string_view text) noexcept;

  const SpecimenLibrary& library_;
  ReplayHost host_;
  gaitway_instance instance_{};
  gaitway_tick tick_{};
  bool created_ = false;
  std::array<char, 1024> error_{};
};

}  // namespace gaitway::plugin_check
