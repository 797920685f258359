// `gaitway api`: what concerns the robot API without a robot.

#include <filesystem>

#include "gaitway/api/reference.hpp"
#include "gaitway/process/text_file.hpp"
#include "tools/command_line.hpp"

namespace gaitway::tools {
namespace {

struct ApiOptions {
  std::filesystem::path out = "docs";
};

int document_api(const ApiOptions& options) {
  process::write_text_file(options.out / "api.md", api::api_reference());
  process::write_text_file(options.out / "api_examples.json", api::api_examples());
  process::write_text_file(options.out / "api_schemas.json", api::api_schemas());
  return kExitFine;
}

}  // namespace

void declare_program(const CommandLine& app) {
  const CommandLine command = add_command(app, "api");
  const CommandLine document = command.subcommand(
      "document", "Write api.md, api_examples.json and api_schemas.json, as this version speaks");
  ApiOptions& options = document.runs(document_api);
  document.option("--out", options.out, "Folder");
  command.needs_subcommand();
  document.footer(
      "Examples:\n"
      "  gaitway api document --out docs\n"
      "Exit code: 0 written, 1 the folder cannot be written to.");
  command.footer("Example:\n  gaitway api document --out docs");
}

}  // namespace gaitway::tools
