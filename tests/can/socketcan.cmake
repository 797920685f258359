# The parts of the SocketCAN port that need no CAN; the port itself is tested in tests/vm.
gaitway_test(socketcan_tests SOURCES error_frame_test.cpp hardware_clock_test.cpp frame_heap_test.cpp
  LINKS gaitway::socketcan)
