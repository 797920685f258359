# The port to interfaces of the Linux kernel, in a library of its own, since it needs libmnl (for rtnetlink).
find_library(GAITWAY_MNL_LIBRARY mnl REQUIRED)
gaitway_library(socketcan SOURCES socketcan_port.cpp can_socket.cpp can_link.cpp error_frame.cpp socketcan_report.cpp finish_sending.cpp
  LINKS gaitway::can PRIVATE_LINKS ${GAITWAY_MNL_LIBRARY})
