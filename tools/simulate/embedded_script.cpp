// The page's script and style, taken in by the assembler.
#include "tools/simulate/simulation_report.hpp"

// GAITWAY_PAGE_FOLDER: where they are. A file between two symbols that this file alone sees.
#define GAITWAY_EMBED(name, file)                                                                        \
  __asm__(".pushsection .rodata\n" #name "_begin:\n.incbin \"" GAITWAY_PAGE_FOLDER "/" file "\"\n" #name \
          "_end:\n.byte 0\n.popsection\n");                                                              \
  extern "C" __attribute__((visibility("hidden"))) const char name##_begin[], name##_end[]

GAITWAY_EMBED(gaitway_simulation_script, "simulation.js");
GAITWAY_EMBED(gaitway_simulation_style, "simulation.css");

namespace gaitway::tools {

std::string_view page_script() {
  return {gaitway_simulation_script_begin, gaitway_simulation_script_end};
}

std::string_view page_style() {
  return {gaitway_simulation_style_begin, gaitway_simulation_style_end};
}

}  // namespace gaitway::tools
