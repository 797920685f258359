// The reference is what the tables say, and its examples are messages that the protocol knows.
#include "gaitway/api/reference.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "gaitway/api/json_reader.hpp"
#include "gaitway/api/limits.hpp"
#include "gaitway/api/message_definition.hpp"
#include "gaitway/api/operation_table.hpp"
#include "gaitway/api/publication.hpp"
#include "gaitway/api/service_table.hpp"
#include "schema_check.hpp"

namespace gaitway::api {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using testing_messages::SchemaCheck;

constexpr const char* kRemedy = "is not up to date. Run ./dev gaitway api document";

std::string file_text(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(std::string(GAITWAY_SOURCE_DIR) + "/" + file).rdbuf();
  return text.str();
}

std::string between(std::string_view before, std::string_view name, std::string_view after) {
  std::string text(before);
  text.append(name).append(after);
  return text;
}

TEST(ApiReference, TheCheckedInFilesAreWhatTheTablesSay) {
  EXPECT_TRUE(file_text("docs/api.md") == api_reference()) << "docs/api.md " << kRemedy;
  EXPECT_TRUE(file_text("docs/api_examples.json") == api_examples()) << "docs/api_examples.json " << kRemedy;
  EXPECT_TRUE(file_text("docs/api_schemas.json") == api_schemas()) << "docs/api_schemas.json " << kRemedy;
}

TEST(ApiReference, NamesEveryOperationTopicServiceTypeAndLimit) {
  const std::string text = api_reference();
  for (const OperationRow& operation : kOperations) {
    EXPECT_THAT(text, HasSubstr(between("### `", operation.name, "`")));
  }
  for (const TopicRow& topic : kTopics) {
    EXPECT_THAT(text, HasSubstr(between("| `", topic.name, "` |")));
  }
  for (const ServiceRow& service : kServices) {
    EXPECT_THAT(text, HasSubstr(between("`", service.name, "`")));
  }
  for (const std::string_view type : message_types()) {
    EXPECT_THAT(text, HasSubstr(between("| `", type, "` |")));
  }
  const Limits limits;
  visit_limits(limits, [&text](const LimitRow& row, const auto&) {
    EXPECT_THAT(text, HasSubstr(between("| `", row.name, "` |")));
  });
}

TEST(ApiReference, EveryJsonBlockIsJson) {
  const std::string text = api_reference(), fence = "```json\n";
  int blocks = 0;
  for (std::size_t begin = text.find(fence); begin != std::string::npos;
       begin = text.find(fence, begin + 1)) {
    const std::size_t end = text.find("\n```", begin + fence.size());
    ASSERT_NE(end, std::string::npos);
    EXPECT_TRUE(json::accept(text.substr(begin + fence.size(), end - begin - fence.size())));
    ++blocks;
  }
  EXPECT_GT(blocks, 20);
}

TEST(ApiExamples, HoldEveryOperationOfAClientAndEveryService) {
  std::set<std::string> operations, services;
  for (const json& example : json::parse(api_examples())) {
    operations.insert(example.at("send").at("op").get<std::string>());
    services.insert(example.at("send").value("service", ""));
  }
  for (const OperationRow& operation : kOperations) {
    EXPECT_TRUE(operation.sender == Sender::robot || operations.contains(std::string(operation.name)))
        << operation.name;
  }
  for (const ServiceRow& service : kServices) {
    EXPECT_TRUE(services.contains(std::string(service.name))) << service.name;
  }
}

TEST(ApiExamples, SatisfyTheSchemasOfWhatTheySend) {
  const json schemas = json::parse(api_schemas());
  for (const json& example : json::parse(api_examples())) {
    const json& message = example.at("send");
    if (message.at("op") == "publish") {
      const SchemaCheck check(schemas.at("publish " + message.at("topic").get<std::string>()));
      EXPECT_TRUE(check.accepts(message.at("msg"))) << example;
    } else if (message.at("op") == "call_service") {
      const SchemaCheck check(schemas.at("call " + message.at("service").get<std::string>()));
      EXPECT_TRUE(check.accepts(message.at("args"))) << example;
    }
  }
}

TEST(ApiExamples, OfWhatTheRobotSendsSatisfyTheirSchemas) {
  const json schemas = json::parse(api_schemas());
  for (const OperationRow& operation : kOperations) {
    const json message = json::parse(operation.example);
    EXPECT_EQ(message.at("op"), operation.name);
    if (operation.sender == Sender::robot && operation.name == "publish") {
      const SchemaCheck check(schemas.at("message " + message.at("topic").get<std::string>()));
      EXPECT_TRUE(check.accepts(message.at("msg"))) << message;
    } else if (operation.sender == Sender::robot && operation.name == "service_response") {
      const SchemaCheck check(schemas.at("answer " + message.at("service").get<std::string>()));
      EXPECT_TRUE(check.accepts(message.at("values"))) << message;
    }
  }
}

}  // namespace
}  // namespace gaitway::api
