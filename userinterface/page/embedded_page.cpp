// The bundle's files, taken in by the assembler.
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "gaitway/page/asset_table.hpp"

// GAITWAY_PAGE_BUNDLE: the folder. A file between two symbols that this file alone sees.
#define GAITWAY_EMBED(name, file)                                                                        \
  __asm__(".pushsection .rodata\n" #name "_begin:\n.incbin \"" GAITWAY_PAGE_BUNDLE "/" file "\"\n" #name \
          "_end:\n.byte 0\n.popsection\n");                                                              \
  extern "C" __attribute__((visibility("hidden"))) const char name##_begin[], name##_end[]

GAITWAY_EMBED(gaitway_page_html, "index.html");
GAITWAY_EMBED(gaitway_page_script, "page.js");
GAITWAY_EMBED(gaitway_page_style, "page.css");
GAITWAY_EMBED(gaitway_page_icon, "icon.svg");
GAITWAY_EMBED(gaitway_page_number, "version.json");

namespace gaitway::page {

void add_page(AssetTable& table) {
  table.add("/", "text/html; charset=utf-8", {gaitway_page_html_begin, gaitway_page_html_end}, false);
  table.add("/page.js", "text/javascript; charset=utf-8",
            {gaitway_page_script_begin, gaitway_page_script_end}, false);
  table.add("/page.css", "text/css; charset=utf-8", {gaitway_page_style_begin, gaitway_page_style_end},
            false);
  table.add("/icon.svg", "image/svg+xml", {gaitway_page_icon_begin, gaitway_page_icon_end}, false);
  table.add("/version.json", "application/json", {gaitway_page_number_begin, gaitway_page_number_end}, false);
}

const std::string& page_version() {
  static const std::string version =
      nlohmann::json::parse(gaitway_page_number_begin, gaitway_page_number_end).at("page");
  return version;
}

}  // namespace gaitway::page
