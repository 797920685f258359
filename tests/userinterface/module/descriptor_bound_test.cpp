// Descriptors for all connections, in processes of their own, since a limit that went down stays there.
#include "gaitway/api/descriptor_bound.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <cstdio>
#include <cstdlib>
#include <exception>

namespace gaitway::api {
namespace {

// Ends the process: with 0 when there are descriptors enough.
[[noreturn]] void provide_of(rlim_t soft, rlim_t hard, std::size_t connections) {
  rlimit bound{soft, hard};
  setrlimit(RLIMIT_NOFILE, &bound);
  Limits limits;
  limits.connections = connections;
  try {
    provide_descriptors(limits);
  } catch (const std::exception& error) {
    std::fputs(error.what(), stderr);
    std::_Exit(1);
  }
  getrlimit(RLIMIT_NOFILE, &bound);
  std::_Exit(bound.rlim_cur >= most_descriptors(limits) ? 0 : 2);
}

TEST(DescriptorBoundDeathTest, GoesUpAsFarAsTheConnectionsNeed) {
  EXPECT_EXIT(provide_of(64, 512, 200), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(provide_of(512, 512, 10), testing::ExitedWithCode(0), "");
}

TEST(DescriptorBoundDeathTest, NamesTheLimitThatTheSystemDoesNotAllow) {
  EXPECT_EXIT(
      provide_of(64, 128, 200), testing::ExitedWithCode(1),
      "connections = 200: 296 descriptors are needed for them, but the system gives this process 128");
}

}  // namespace
}  // namespace gaitway::api
