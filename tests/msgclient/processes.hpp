// The memory block's server and its clients in processes of their own, for tests.
#pragma once

#include <gtest/gtest.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/memory_block_server.hpp"
#include "gaitway/process/file_descriptor.hpp"
#include "topic_error.hpp"

namespace gaitway::msgclient {

// A forked child must not outlive a test that fails.
inline void end_with_parent() {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
}

// A process that runs `work`, then waits to be killed; ready() returns when the work is done.
class Process {
 public:
  explicit Process(const std::function<void()>& work) {
    int ends[2];
    EXPECT_EQ(pipe(ends), 0);
    pid_ = fork();
    if (pid_ == 0) {
      end_with_parent();
      const auto say = [&](char c) { return write(ends[1], &c, 1) == 1; };
      try {
        work_ready_ = [&] { (void)say('+'); };
        work();
        (void)say('+');
        while (true) {
          pause();
        }
      } catch (const std::exception& error) {
        std::fprintf(stderr, "child: %s\n", error.what());
        (void)say('-');
        _exit(1);
      }
    }
    close(ends[1]);
    ready_ = process::FileDescriptor(ends[0]);
  }
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process() { end(); }

  // For work that doesn't return: called in the child.
  static void work_is_ready() { work_ready_(); }
  bool ready() {
    char c = 0;
    return read(ready_.get(), &c, 1) == 1 && c == '+';
  }
  void end() {
    if (pid_ > 0) {
      kill(pid_, SIGKILL);
      waitpid(pid_, nullptr, 0);
      pid_ = -1;
    }
  }

 private:
  inline static std::function<void()> work_ready_;
  process::FileDescriptor ready_;
  pid_t pid_ = -1;
};

inline void serve_forever(const std::filesystem::path& socket) {
  MemoryBlock block;
  MemoryBlockServer server(block, socket);
  Process::work_is_ready();
  for (std::int64_t beat = 1;; ++beat) {
    pollfd wake{server.wake_fd(), POLLIN, 0};
    poll(&wake, 1, 1000);
    block.beat(beat);
    server.step(beat);
  }
}

class Processes : public testing::Test {
 protected:
  void SetUp() override {
    char name[] = "/tmp/gaitway_test_XXXXXX";
    ASSERT_NE(mkdtemp(name), nullptr);
    folder = name;
    socket = folder / "block.sock";
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  void start_server() {
    server = std::make_unique<Process>([this] { serve_forever(socket); });
    ASSERT_TRUE(server->ready());
  }
  // Claims are given back when the server has seen the end of the process; asks until then.
  template <class T>
  std::optional<Writer<T>> claim_again(Client& client, std::string_view topic) {
    for (int attempt = 0; attempt < 1000; ++attempt) {
      try {
        return client.write<T>(topic);
      } catch (const TopicError&) {
        poll(nullptr, 0, 1);
      }
    }
    return std::nullopt;
  }

  std::filesystem::path folder;
  std::filesystem::path socket;
  std::unique_ptr<Process> server;
};

}  // namespace gaitway::msgclient
