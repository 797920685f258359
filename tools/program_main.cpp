// The main of every program gaitway-NAME.
#include "tools/command_line.hpp"

int main(int argc, char** argv) {
  return gaitway::tools::run_program(argc, argv, gaitway::tools::declare_program);
}
