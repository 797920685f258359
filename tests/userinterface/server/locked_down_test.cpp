// The server's thread under a filter that kills the process for any call that a locked-down one may not make.
#include <gtest/gtest.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <malloc.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cstddef>
#include <limits>
#include <vector>

#include "raw_client.hpp"
#include "running_server.hpp"
#include "secret_files.hpp"
#include "websocket_client.hpp"

namespace gaitway::api {
namespace {

// For the calling thread, and for ever. Before it gives memory back, glibc's allocator looks once into a file
// of the kernel, outside the first thread: so it keeps its memory here, as a locked-down process must have it
// do.
void forbid_opening_anything() {
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());  // refused by the sanitizers' allocator
  std::vector<sock_filter> program{BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr))};
  for (const auto number : {SYS_socket, SYS_socketpair, SYS_connect, SYS_bind, SYS_listen, SYS_openat,
                            SYS_clone, SYS_clone3, SYS_execve, SYS_accept, SYS_epoll_create1, SYS_eventfd2,
#ifdef SYS_open
                            SYS_open, SYS_creat, SYS_fork, SYS_vfork,
#endif
                            SYS_timerfd_create, SYS_memfd_create}) {
    program.push_back(BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(number), 0, 1));
    program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS));
  }
  program.push_back(BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW));
  const sock_fprog filter{static_cast<unsigned short>(program.size()), program.data()};
  ASSERT_EQ(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0), 0);
  ASSERT_EQ(prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &filter), 0);
}

void converse(RunningServer& server, const WebSocketClient::Options& options) {
  WebSocketClient client(server.port(), options);
  client.send("many 100");
  for (int count = 0; count < 100; ++count) {
    ASSERT_EQ(client.receive().text.size(), 16'384U);
  }
  client.close();
}

void meet_a_stranger(RunningServer& server) {
  RawClient stranger(server.port());
  stranger.send("nonsense\r\n\r\n");
  static_cast<void>(stranger.receive_all());
}

TEST(LockedDown, ServesPlainConnections) {
  RunningServer server(local(), forbid_opening_anything);
  converse(server, {});
  meet_a_stranger(server);
  server.stop();
}

TEST(LockedDown, ServesTlsConnections) {
  const SecretFiles files;
  ServerOptions options = local();
  options.token_file = files.token();
  options.certificate_file = files.certificate();
  options.key_file = files.key();
  RunningServer server(options, forbid_opening_anything);
  for (const int highest_tls : {0, 0x0303}) {
    converse(server, {.headers = {{"Authorization", "Bearer " + std::string(SecretFiles::kToken)}},
                      .tls = true,
                      .highest_tls = highest_tls});
  }
  EXPECT_ANY_THROW(
      converse(server, {.headers = {{"Authorization", "Bearer wrong"}}, .tls = true, .highest_tls = 0}));
  meet_a_stranger(server);
  server.stop();
}

}  // namespace
}  // namespace gaitway::api
