gaitway_test(bus_server_tests SOURCES bus_server_test.cpp LINKS gaitway::can)
