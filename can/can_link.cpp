// Asks the kernel about a CAN interface and its bit rate: one question and one answer over rtnetlink, with
// libmnl.
#include "can_socket.hpp"

#include <libmnl/libmnl.h>
#include <linux/can/netlink.h>
#include <linux/if_link.h>
#include <linux/rtnetlink.h>

#include <array>
#include <cerrno>
#include <memory>

namespace gaitway::can {
namespace {

using NetlinkSocket = std::unique_ptr<mnl_socket, int (*)(mnl_socket*)>;
using Buffer = std::array<char, 16384>;

NetlinkSocket open_netlink() noexcept {
  NetlinkSocket socket(mnl_socket_open2(NETLINK_ROUTE, SOCK_CLOEXEC), mnl_socket_close);
  if (socket && mnl_socket_bind(socket.get(), 0, MNL_SOCKET_AUTOPID) < 0) {
    socket.reset();
  }
  return socket;
}

nlmsghdr* begin_message(Buffer& buffer, std::uint16_t type, int index) noexcept {
  nlmsghdr* const message = mnl_nlmsg_put_header(buffer.data());
  message->nlmsg_type = type;
  message->nlmsg_flags = NLM_F_REQUEST | NLM_F_ACK;
  message->nlmsg_seq = 1;
  auto* const link = static_cast<ifinfomsg*>(mnl_nlmsg_put_extra_header(message, sizeof(ifinfomsg)));
  link->ifi_family = AF_UNSPEC;
  link->ifi_index = index;
  return message;
}

// Sends the message and hands the answers to `callback`. 0, or an errno.
int ask(nlmsghdr* message, Buffer& buffer, mnl_cb_t callback, void* data) noexcept {
  const NetlinkSocket socket = open_netlink();
  if (!socket || mnl_socket_sendto(socket.get(), message, message->nlmsg_len) < 0) {
    return errno;
  }
  while (true) {
    const ssize_t bytes = mnl_socket_recvfrom(socket.get(), buffer.data(), buffer.size());
    if (bytes < 0) {
      return errno;
    }
    const int more = mnl_cb_run(buffer.data(), static_cast<std::size_t>(bytes), 1,
                                mnl_socket_get_portid(socket.get()), callback, data);
    if (more <= MNL_CB_STOP) {
      return more < 0 ? errno : 0;
    }
  }
}

int read_controller(const nlattr* attribute, void* data) {
  auto& link = *static_cast<CanLink*>(data);
  switch (mnl_attr_get_type(attribute)) {
    case IFLA_CAN_STATE: {
      const std::uint32_t state = mnl_attr_get_u32(attribute);
      link.state = state >= CAN_STATE_STOPPED         ? BusState::down
                   : state == CAN_STATE_BUS_OFF       ? BusState::bus_off
                   : state >= CAN_STATE_ERROR_PASSIVE ? BusState::error_passive
                                                      : BusState::error_active;
      break;
    }
    case IFLA_CAN_RESTART_MS:
      link.restart_ms = mnl_attr_get_u32(attribute);
      break;
    case IFLA_CAN_BITTIMING:
      link.bitrate_per_s = static_cast<const can_bittiming*>(mnl_attr_get_payload(attribute))->bitrate;
      break;
    case IFLA_CAN_BERR_COUNTER: {
      const auto* const counter = static_cast<const can_berr_counter*>(mnl_attr_get_payload(attribute));
      link.counters = {counter->txerr, counter->rxerr};
      break;
    }
    default:
      break;
  }
  return MNL_CB_OK;
}

int read_link_info(const nlattr* attribute, void* data) {
  auto& link = *static_cast<CanLink*>(data);
  if (mnl_attr_get_type(attribute) == IFLA_INFO_KIND) {
    link.kind = mnl_attr_get_str(attribute);
  } else if (mnl_attr_get_type(attribute) == IFLA_INFO_DATA && link.kind == "can") {
    mnl_attr_parse_nested(attribute, read_controller, data);  // the kind comes first
  }
  return MNL_CB_OK;
}

int read_attribute(const nlattr* attribute, void* data) {
  if (mnl_attr_get_type(attribute) == IFLA_LINKINFO) {
    mnl_attr_parse_nested(attribute, read_link_info, data);
  }
  return MNL_CB_OK;
}

int read_message(const nlmsghdr* message, void* data) {
  return mnl_attr_parse(message, sizeof(ifinfomsg), read_attribute, data);
}

int ignore_message(const nlmsghdr* /*message*/, void* /*data*/) {
  return MNL_CB_OK;
}

}  // namespace

std::optional<CanLink> read_link(int index) {
  Buffer buffer;
  CanLink link;
  if (ask(begin_message(buffer, RTM_GETLINK, index), buffer, read_message, &link) != 0) {
    return std::nullopt;
  }
  return link;
}

int restart_link(int index) noexcept {
  Buffer buffer;
  nlmsghdr* const message = begin_message(buffer, RTM_NEWLINK, index);
  nlattr* const info = mnl_attr_nest_start(message, IFLA_LINKINFO);
  mnl_attr_put_str(message, IFLA_INFO_KIND, "can");
  nlattr* const data = mnl_attr_nest_start(message, IFLA_INFO_DATA);
  mnl_attr_put_u32(message, IFLA_CAN_RESTART, 1);
  mnl_attr_nest_end(message, data);
  mnl_attr_nest_end(message, info);
  return ask(message, buffer, ignore_message, nullptr);
}

}  // namespace gaitway::can
