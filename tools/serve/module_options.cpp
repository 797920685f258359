// Options in, words out.
#include "tools/serve/module_options.hpp"

namespace gaitway::tools {

void add_module_options(const CommandLine& command, ModuleOptions& options) {
  command.option("--port", options.port, "TCP port of the robot API; 0: any free one").between(0, 65535);
  command
      .option(
          "--stop-port", options.stop_port,
          "UDP port of stops by datagram (gaitway stop), at the same address; 0: none; without it one more "
          "than the TCP port")
      .between(0, 65535);
  command.option("--address", options.address,
                 "Address to listen on. Any but a loopback one needs --token-file, --certificate-file and "
                 "--key-file");
  command.option(
      "--origins", options.origins,
      "Web origins that may connect besides this computer's, with commas between them; null: pages "
      "from files");
  command.option("--token-file", options.token_file, "File with the token that clients must know");
  command.option("--certificate-file", options.certificate_file, "Certificate chain (PEM)");
  command.option("--key-file", options.key_file, "Its private key (PEM)");
  command.option(
      "--limits", options.limits,
      "Limits of clients (YAML: name: value) in place of the shipped ones; docs/api.md lists them");
}

std::vector<std::string> module_arguments(const ModuleOptions& options,
                                          const ModuleSurroundings& surroundings) {
  std::vector<std::string> words{"--robot",      surroundings.robot.string(),
                                 "--link",       surroundings.link,
                                 "--simulation", surroundings.simulation,
                                 "--address",    options.address,
                                 "--port",       std::to_string(options.port),
                                 "--recordings", std::filesystem::absolute(surroundings.recordings).string()};
  const auto add = [&words](const char* name, const std::string& value) {
    if (!value.empty()) words.insert(words.end(), {name, value});
  };
  add("--twin", surroundings.twin);
  add("--profile", surroundings.profile);
  add("--origins", options.origins);
  add("--token-file", options.token_file.string());
  add("--certificate-file", options.certificate_file.string());
  add("--key-file", options.key_file.string());
  add("--limits", options.limits.string());
  add("--stop-port", options.stop_port ? std::to_string(*options.stop_port) : "");
  return words;
}

}  // namespace gaitway::tools
