// What disturbs a robot from outside its processes: busy processors and disks, a crowd at its interface, a
// full disk. Each lasts as long as its object.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

namespace gaitway::tools {

class Noise {
 public:
  Noise() = default;
  Noise(const Noise&) = delete;
  Noise& operator=(const Noise&) = delete;
  virtual ~Noise() = default;
  // What there was of it, for people; empty: nothing to tell.
  [[nodiscard]] virtual std::string told() const { return {}; }
};

// As many processes of ordinary priority as there are processors, which never wait, and two that write to
// the disk of this folder and have it brought there.
class BusyComputer final : public Noise {
 public:
  explicit BusyComputer(const std::filesystem::path& folder);
  ~BusyComputer() override;

 private:
  std::vector<pid_t> processes_;
};

// Clients on the loopback: some make connection after connection and ask for the page, others order and ask
// as fast as they are answered.
class Crowd final : public Noise {
 public:
  explicit Crowd(int port);
  ~Crowd() override;
  [[nodiscard]] std::string told() const override;

 private:
  void ask_for_pages(const std::stop_token& end);
  void order(const std::stop_token& end);

  int port_;
  std::int64_t begun_ns_;
  std::atomic<std::uint64_t> pages_ = 0, orders_ = 0;
  std::vector<std::jthread> clients_;
};

// A file that takes all that is left of the disk. Throws std::runtime_error when the disk is larger than a
// trial's own: somebody else's is not filled.
class FullDisk final : public Noise {
 public:
  explicit FullDisk(const std::filesystem::path& folder);
  ~FullDisk() override;

 private:
  std::filesystem::path file_;
};

}  // namespace gaitway::tools
