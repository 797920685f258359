// Check `abi`: the file, its one exported symbol, and the numbers at the border.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "gaitway/instance/plugin_library.hpp"
#include "tools/check_plugin/check_run.hpp"
#include "tools/check_plugin/elf_symbols.hpp"

namespace gaitway::plugin_check {
namespace {

constexpr std::size_t kNamed = 5;  // of surplus symbols

void check_exports(CheckRun& run) {
  std::vector<std::string> surplus = read_elf_symbols(run.job().plugin).exported;
  std::erase(surplus, "gaitway_plugin_entry");
  // By which `gaitway behaviour --with` knows a plug-in's own leaves; nobody looks for them among all
  // symbols.
  std::erase_if(surplus, [](const std::string& name) {
    return name == "gaitway_behaviour_leaves" || name == "gaitway_behaviour_leaves_make";
  });
  // What the linker itself defines on some machines says nothing about the plug-in.
  std::erase_if(surplus, [](const std::string& name) {
    return name == "_init" || name == "_fini" || name == "_edata" || name == "_end" || name == "__bss_start";
  });
  if (surplus.empty()) {
    return;
  }
  const std::size_t count = surplus.size();
  surplus.resize(std::min(count, kNamed));
  run.finding(fmt::format("exports {} more symbol{} than gaitway_plugin_entry: {}{}", count,
                          count == 1 ? "" : "s", fmt::join(surplus, ", "), count > kNamed ? ", ..." : ""),
              run.job().plugin.filename().string(),
              "build it with gaitway_plugin(), or link with -Wl,--version-script=plugin.map and "
              "-Wl,--exclude-libs,ALL: equal names in two plug-ins would take each other's place");
}

}  // namespace

void check_abi(CheckRun& run) {
  try {
    run.board().enter(Call::load);
    const core::PluginLibrary library(run.job().plugin.string(), "/", {});
    run.figure("name", library.entry().name);
    run.figure("version", library.entry().version);
    run.board().enter(Call::none);
    check_exports(run);
    run.remark(fmt::format("ABI {}.{}, one entry", library.entry().abi, library.entry().abi_minor));
  } catch (const std::exception& error) {
    run.finding(error.what(), "", "the plug-in cannot be loaded by the main controller");
    run.not_usable("");
  }
}

}  // namespace gaitway::plugin_check
