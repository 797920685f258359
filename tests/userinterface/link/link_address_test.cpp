// Where the other end is, as people write it: what can never be reached is refused at once.
#include "gaitway/link/link_address.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace gaitway::link {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string refusal(const std::string& text) {
  try {
    static_cast<void>(parse_link_address(text));
    return "";
  } catch (const LinkAddressError& error) {
    return error.what();
  }
}

TEST(LinkAddress, IsASocketOrASerialLine) {
  const LinkAddress socket = parse_link_address("unix:/run/gaitway/link.sock");
  EXPECT_EQ(socket.kind, LinkAddress::Kind::unix_socket);
  EXPECT_EQ(socket.path, "/run/gaitway/link.sock");
  const LinkAddress line = parse_link_address("serial:/dev/serial/by-path/pci:1:1000000");
  EXPECT_EQ(line.kind, LinkAddress::Kind::serial);
  EXPECT_EQ(line.path, "/dev/serial/by-path/pci:1");
  EXPECT_EQ(line.baud, 1'000'000U);
}

TEST(LinkAddress, NamesValueRuleAndRemedy) {
  for (const char* const text : {"", "tcp:1", "unix:", "serial:", "serial:/dev/ttyS1", "serial::9600",
                                 "serial:/dev/ttyS1:fast", "serial:/dev/ttyS1:0"}) {
    EXPECT_THAT(refusal(text),
                AllOf(HasSubstr("link '" + std::string(text) + "'"), HasSubstr("write unix:PATH")));
  }
}

TEST(LinkAddress, ASocketsPathIsNotTooLongForTheSystem) {
  EXPECT_EQ(refusal("unix:" + std::string(107, 'x')), "");
  EXPECT_THAT(refusal("unix:" + std::string(108, 'x')),
              AllOf(HasSubstr("1 to 107 characters"), HasSubstr("108")));
}

TEST(LinkAddress, ALinesRateIsOneThatThereIs) {
  EXPECT_THAT(refusal("serial:/dev/ttyS1:12345"), AllOf(HasSubstr("baud rate 12345 is none of 9600, 19200")));
}

}  // namespace
}  // namespace gaitway::link
