// `gaitway api`: what concerns the robot API without a robot.

#include <filesystem>

#include "gaitway/api/reference.hpp"
#include "gaitway/page/view_frame.hpp"
#include "gaitway/process/text_file.hpp"
#include "tools/command_line.hpp"

namespace gaitway::tools {
namespace {

struct ApiOptions {
  std::filesystem::path out = "docs";
  std::filesystem::path web;  // the page's sources; empty: without them
};

int document_api(const ApiOptions& options) {
  process::write_text_file(options.out / "api.md", api::api_reference());
  process::write_text_file(options.out / "api_examples.json", api::api_examples());
  process::write_text_file(options.out / "api_schemas.json", api::api_schemas());
  process::write_text_file(options.out / "view.md", page::view_reference());
  if (!options.web.empty()) {
    process::write_text_file(options.web / "src/view_layout.ts", page::view_layout_ts());
    process::write_text_file(options.web / "test/view_golden.json", page::view_golden());
  }
  return kExitFine;
}

}  // namespace

void declare_program(const CommandLine& app) {
  const CommandLine command = add_command(app, "api");
  const CommandLine document = command.subcommand(
      "document", "Write api.md, api_examples.json, api_schemas.json and view.md, as this version speaks");
  ApiOptions& options = document.runs(document_api);
  document.option("--out", options.out, "Folder");
  document.option("--web", options.web, "Folder of the page's sources, for the layout that they decode");
  command.needs_subcommand();
  document.footer(
      "Examples:\n"
      "  gaitway api document --out docs --web userinterface/web\n"
      "Exit code: 0 written, 1 the folder cannot be written to.");
  command.footer("Example:\n  gaitway api document --out docs");
}

}  // namespace gaitway::tools
