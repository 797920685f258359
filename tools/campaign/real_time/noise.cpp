// Child processes, client threads, one file.
#include "tools/campaign/real_time/noise.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/statvfs.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>

#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/process/real_time.hpp"
#include "tools/ctl/api_client.hpp"

namespace gaitway::tools {
namespace {

constexpr int kWriters = 2;
constexpr std::size_t kChunk_bytes = 1U << 20U;
constexpr int kChunksOfAFile = 64;
constexpr int kPageClients = 4, kOrderClients = 4;
constexpr int kOrdersOfAConnection = 50;
constexpr double kCrowdPatience_s = 2.0;
constexpr std::uint64_t kLargestOwnDisk_bytes = 64U << 20U;

// Of a child: ends with its parent, at ordinary priority.
void become_ordinary() noexcept {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const sched_param none{};
  sched_setscheduler(0, SCHED_OTHER, &none);
}

[[noreturn]] void spin() noexcept {
  for (volatile std::uint64_t round = 0;;) round = round + 1;
}

[[noreturn]] void write_without_end(const char* file) noexcept {
  static std::array<char, kChunk_bytes> chunk{};
  for (;;) {
    const int out = open(file, O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0600);
    for (int i = 0; i < kChunksOfAFile; ++i) {
      if (write(out, chunk.data(), chunk.size()) < 0) break;
      fdatasync(out);
    }
    close(out);
  }
}

process::FileDescriptor connected(int port) {
  process::FileDescriptor client(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in place{};
  place.sin_family = AF_INET;
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  place.sin_port = htons(static_cast<std::uint16_t>(port));
  const timeval patience{1, 0};
  setsockopt(client.get(), SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
  setsockopt(client.get(), SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  if (connect(client.get(), reinterpret_cast<const sockaddr*>(&place), sizeof place) != 0) return {};
  return client;
}

}  // namespace

BusyComputer::BusyComputer(const std::filesystem::path& folder) {
  const int spinners = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  for (int i = 0; i < spinners + kWriters; ++i) {
    const std::string file = folder / fmt::format("busy_{}", i);
    const pid_t child = fork();
    if (child == 0) {
      become_ordinary();
      if (i < spinners) spin();
      write_without_end(file.c_str());
    }
    if (child > 0) processes_.push_back(child);
  }
}

BusyComputer::~BusyComputer() {
  for (const pid_t one : processes_) kill(one, SIGKILL);
  for (const pid_t one : processes_) waitpid(one, nullptr, 0);
}

Crowd::Crowd(int port) : port_(port), begun_ns_(process::monotonic_ns()) {
  for (int i = 0; i < kPageClients; ++i) {
    clients_.emplace_back([this](const std::stop_token& end) { ask_for_pages(end); });
  }
  for (int i = 0; i < kOrderClients; ++i) {
    clients_.emplace_back([this](const std::stop_token& end) { order(end); });
  }
}

Crowd::~Crowd() {
  for (std::jthread& client : clients_) client.request_stop();
}

std::string Crowd::told() const {
  const double lasted_s = static_cast<double>(process::monotonic_ns() - begun_ns_) * 1e-9;
  return fmt::format("{:.0f} pages and {:.0f} orders answered each second",
                     static_cast<double>(pages_) / lasted_s, static_cast<double>(orders_) / lasted_s);
}

void Crowd::ask_for_pages(const std::stop_token& end) {
  constexpr std::string_view kRequest = "GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n\r\n";
  std::array<char, 65536> answer{};
  while (!end.stop_requested()) {
    const process::FileDescriptor client = connected(port_);
    if (!client || send(client.get(), kRequest.data(), kRequest.size(), MSG_NOSIGNAL) < 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));  // turned away
      continue;
    }
    bool answered = false;
    while (!end.stop_requested() && recv(client.get(), answer.data(), answer.size(), 0) > 0) answered = true;
    pages_ += answered ? 1U : 0U;
  }
}

void Crowd::order(const std::stop_token& end) {
  ApiAddress address;
  address.url = fmt::format("ws://127.0.0.1:{}", port_);
  while (!end.stop_requested()) {
    try {
      ApiClient client(address.with_timeout(kCrowdPatience_s));
      for (int i = 0; i < kOrdersOfAConnection && !end.stop_requested(); ++i) {
        nlohmann::json values;
        const bool takes = i % 2 == 0;  // who has the command keeps it
        const auto answer =
            client.call(takes ? "/command/acquire" : "/rosapi/topics",
                        takes ? nlohmann::json{{"name", "crowd"}} : nlohmann::json::object(), values);
        orders_ += answer.result || !answer.problem.empty() ? 1U : 0U;
      }
    } catch (const std::exception&) {  // turned away, or too slow: tries again
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
}

FullDisk::FullDisk(const std::filesystem::path& folder) : file_(folder / "filler") {
  struct statvfs disk {};
  if (statvfs(folder.c_str(), &disk) != 0 || disk.f_blocks * disk.f_frsize > kLargestOwnDisk_bytes) {
    throw std::runtime_error(
        fmt::format("'{}' is on no disk of a trial's own: it is not filled", folder.string()));
  }
  const process::FileDescriptor out(open(file_.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600));
  const std::array<char, 4096> block{};
  for (std::size_t size = block.size(); size > 0; size /= 2) {
    while (write(out.get(), block.data(), size) > 0) {
    }
  }
  if (errno != ENOSPC)
    throw std::runtime_error(fmt::format("'{}' is not full: {}", folder.string(), std::strerror(errno)));
}

FullDisk::~FullDisk() {
  unlink(file_.c_str());
}

}  // namespace gaitway::tools
