// Three files from one set of tables.
#include "tools/api/api_command.hpp"

#include <CLI/CLI.hpp>

#include "gaitway/api/reference.hpp"
#include "gaitway/process/text_file.hpp"
#include "tools/program.hpp"

namespace gaitway::tools {

CLI::App* add_api_command(CLI::App& app, ApiOptions& options) {
  CLI::App* const command = add_command(app, "api");
  CLI::App* const document = command->add_subcommand(
      "document", "Write api.md, api_examples.json and api_schemas.json, as this version speaks");
  document->add_option("--out", options.out, "Folder")->capture_default_str();
  command->require_subcommand(1);
  document->footer(
      "Examples:\n"
      "  gaitway api document --out docs\n"
      "Exit code: 0 written, 1 the folder cannot be written to.");
  return command;
}

int document_api(const ApiOptions& options) {
  process::write_text_file(options.out / "api.md", api::api_reference());
  process::write_text_file(options.out / "api_examples.json", api::api_examples());
  process::write_text_file(options.out / "api_schemas.json", api::api_schemas());
  return kExitFine;
}

}  // namespace gaitway::tools

int main(int argc, char** argv) {
  gaitway::tools::ApiOptions options;
  return gaitway::tools::run_program(argc, argv, [&options](CLI::App& app) -> std::function<int()> {
    gaitway::tools::add_api_command(app, options);
    return [&options] { return gaitway::tools::document_api(options); };
  });
}
