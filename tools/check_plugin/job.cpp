// A job as one argument of a command line.
#include "tools/check_plugin/job.hpp"

#include <nlohmann/json.hpp>

namespace gaitway::plugin_check {

std::string to_text(const Job& job) {
  nlohmann::json parameters = nlohmann::json::array();
  for (const core::ParameterEntry& entry : job.parameters) {
    parameters.push_back({{"name", entry.name}, {"text", entry.text}, {"line", entry.line}});
  }
  return nlohmann::json{{"check", job.check},
                        {"variant", job.variant},
                        {"plugin", job.plugin.string()},
                        {"robot", job.robot.string()},
                        {"configuration", job.configuration.string()},
                        {"parameters", parameters},
                        {"seed", job.seed},
                        {"full", job.full},
                        {"budget_ms", job.budget_ms},
                        {"first_case", job.first_case}}
      .dump();
}

Job read_job(const std::string& text) {
  const nlohmann::json json = nlohmann::json::parse(text);
  Job job{.check = json.at("check"),
          .variant = json.at("variant"),
          .plugin = json.at("plugin").get<std::string>(),
          .robot = json.at("robot").get<std::string>(),
          .configuration = json.at("configuration").get<std::string>(),
          .parameters = {},
          .seed = json.at("seed"),
          .full = json.at("full"),
          .budget_ms = json.at("budget_ms"),
          .first_case = json.at("first_case")};
  for (const nlohmann::json& entry : json.at("parameters")) {
    job.parameters.push_back({entry.at("name").get<std::string>(), entry.at("text").get<std::string>(),
                              entry.at("line").get<int>()});
  }
  return job;
}

}  // namespace gaitway::plugin_check
