// The outcomes of trials, kept in a file: a line of JSON each, written as soon as it is known, so that a
// measurement may be interrupted and goes on where it was.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <unordered_map>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::tools {

// A 64-bit hash of texts and files: FNV-1a.
class ContentHash {
 public:
  void add(std::string_view bytes) noexcept {
    for (const char byte : bytes) {
      state_ = (state_ ^ static_cast<unsigned char>(byte)) * 0x0000'0100'0000'01B3ULL;
    }
  }
  // Its bytes. Throws std::runtime_error that names the file when it cannot be read.
  void add_file(const std::filesystem::path& file);
  [[nodiscard]] std::uint64_t value() const noexcept { return state_; }

 private:
  std::uint64_t state_ = 0xCBF2'9CE4'8422'2325ULL;
};

// One process at a time has the file.
class OutcomeStore {
 public:
  // Throws nlohmann::json::exception for what is no outcome.
  using Check = std::function<void(const nlohmann::ordered_json& outcome)>;

  // Reads what is there; a last line that was cut off is dropped. `fingerprint` becomes part of each key.
  // Throws std::invalid_argument for a line that is no trial, or while another process has the file.
  OutcomeStore(const std::filesystem::path& file, std::uint64_t fingerprint, const Check& check);

  // `description`: the trial's, as JSON. nullptr: not known.
  [[nodiscard]] const nlohmann::ordered_json* find(const std::string& description) const;
  // Throws std::runtime_error when the file cannot be written.
  void keep(const std::string& description, const nlohmann::ordered_json& outcome);
  // For a copy of the process that fork() made: the file stays the first process's alone, and can be
  // another's as soon as that one has ended. Nothing is kept any more.
  void leave_file() { descriptor_ = {}; }

 private:
  [[nodiscard]] std::string key_of(const std::string& description) const;
  void read(const Check& check);

  std::filesystem::path file_;
  std::uint64_t fingerprint_;
  process::FileDescriptor descriptor_;
  std::unordered_map<std::string, nlohmann::ordered_json> outcomes_;  // by key
};

}  // namespace gaitway::tools
