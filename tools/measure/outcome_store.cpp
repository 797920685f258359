// Reads and appends outcomes.
#include "tools/measure/outcome_store.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace gaitway::tools {

void ContentHash::add_file(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string content{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad()) {
    throw std::runtime_error(fmt::format("{}: cannot be read ({})", file.string(), std::strerror(errno)));
  }
  add(content);
  add(std::string_view("\0", 1));  // so that two files are not one
}

OutcomeStore::OutcomeStore(const std::filesystem::path& file, std::uint64_t fingerprint, const Check& check)
    : file_(file),
      fingerprint_(fingerprint),
      descriptor_(open(file.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644)) {
  if (!descriptor_) {
    throw std::invalid_argument(
        fmt::format("{}: cannot be opened ({}). Choose another --out", file.string(), std::strerror(errno)));
  }
  if (flock(descriptor_.get(), LOCK_EX | LOCK_NB) != 0) {
    throw std::invalid_argument(
        fmt::format("{}: another measurement is writing there. Wait for its end, or choose another --out",
                    file.string()));
  }
  read(check);
}

void OutcomeStore::read(const Check& check) {
  std::ifstream in(file_, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::size_t whole = text.rfind('\n') + 1;  // 0 if there is none
  if (whole < text.size() && ftruncate(descriptor_.get(), static_cast<off_t>(whole)) != 0) {
    throw std::runtime_error(fmt::format("{}: {}", file_.string(), std::strerror(errno)));
  }
  int number = 0;
  for (std::size_t start = 0; start < whole; ++number) {
    const std::size_t end = text.find('\n', start);
    const std::string_view line = std::string_view(text).substr(start, end - start);
    start = end + 1;
    try {
      const auto json = nlohmann::ordered_json::parse(line);
      check(json.at("outcome"));
      outcomes_.insert_or_assign(json.at("key").get<std::string>(), json.at("outcome"));
    } catch (const nlohmann::json::exception& error) {
      throw std::invalid_argument(
          fmt::format("{}:{}: no outcome of a trial ({}). Remove the line, or the file", file_.string(),
                      number + 1, error.what()));
    }
  }
}

std::string OutcomeStore::key_of(const std::string& description) const {
  ContentHash hash;
  hash.add(description);
  return fmt::format("{:016x}{:016x}", fingerprint_, hash.value());
}

const nlohmann::ordered_json* OutcomeStore::find(const std::string& description) const {
  const auto found = outcomes_.find(key_of(description));
  return found == outcomes_.end() ? nullptr : &found->second;
}

void OutcomeStore::keep(const std::string& description, const nlohmann::ordered_json& outcome) {
  const std::string key = key_of(description);
  const std::string line =
      fmt::format("{{\"key\":\"{}\",\"trial\":{},\"outcome\":{}}}\n", key, description, outcome.dump());
  // One call writes the whole line or, on a full disk, a part that the next start drops.
  if (write(descriptor_.get(), line.data(), line.size()) != static_cast<ssize_t>(line.size())) {
    throw std::runtime_error(
        fmt::format("{}: cannot be written to its end ({})", file_.string(), std::strerror(errno)));
  }
  outcomes_.insert_or_assign(key, outcome);
}

}  // namespace gaitway::tools
