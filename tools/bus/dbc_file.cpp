// Section after section, in the order that the format prescribes.
#include "tools/bus/network_description.hpp"

#include <fmt/format.h>

#include <iterator>
#include <set>
#include <vector>

#include "gaitway/facts/facts.hpp"

namespace gaitway::tools {
namespace {

constexpr std::size_t kLongestName = 32;
constexpr std::int64_t kMicrosecond_ns = 1'000;
using facts::kMillisecond_ns;

class DbcWriter {
 public:
  explicit DbcWriter(const NetworkDescription& network) : network_(network) {
    std::set<std::string> taken;
    for (const DescribedMessage& message : network.messages) {
      names_.push_back(short_name(message.name, taken));
    }
  }

  std::string run() {
    put("VERSION \"\"\n\nNS_ :\n\nBS_:\n\nBU_: {}", kMessageControllerName);
    for (const DescribedNode& node : network_.nodes) {
      put(" {}", node.name);
    }
    put("\n");
    for (std::size_t i = 0; i < network_.messages.size(); ++i) {
      message(network_.messages[i], names_[i]);
    }
    put("\n");
    comments();
    attribute_definitions();
    attributes();
    value_names();
    return std::move(text_);
  }

 private:
  template <class... Arguments>
  void put(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
  }

  static std::string short_name(const std::string& name, std::set<std::string>& taken) {
    std::string candidate = name.substr(0, kLongestName);
    for (int number = 2; !taken.insert(candidate).second; ++number) {
      const std::string tail = fmt::format("_{}", number);
      candidate = name.substr(0, kLongestName - tail.size()) + tail;
    }
    return candidate;
  }

  void message(const DescribedMessage& described, const std::string& name) {
    put("\nBO_ {} {}: {} {}\n", described.id, name, can::layout(described.kind).size, described.sender);
    for (const DescribedSignal& signal : described.signals) {
      put(" SG_ {} : {}|{}@1{} ({},0) [{}|{}] \"{}\" {}\n", signal.name, signal.field.first_bit,
          signal.field.width, signal.field.is_signed ? '-' : '+', number_text(signal.factor),
          number_text(signal.lowest), number_text(signal.highest), signal.unit,
          fmt::join(described.receivers, ","));
    }
  }

  void comments() {
    put("CM_ \"The message network of {}, profile {}: CAN 1 Mb/s, 11-bit identifiers. Made from the message "
        "table by gaitway bus dbc.\";\n",
        network_.robot, network_.profile.name);
    for (const DescribedNode& node : network_.nodes) {
      put("CM_ BU_ {} \"Local controller of this joint, node {}.\";\n", node.name, node.node);
    }
    for (const DescribedMessage& message : network_.messages) {
      put("CM_ BO_ {} \"{}\";\n", message.id, meaning_of(message.kind));
      for (const DescribedSignal& signal : message.signals) {
        if (!signal.field.name.starts_with("delta_")) {  // the message's comment says it
          put("CM_ SG_ {} {} \"{}\";\n", message.id, signal.name, comment_of(signal));
        }
      }
    }
  }

  static std::string comment_of(const DescribedSignal& signal) {
    std::string comment = signal.meaning;
    const char* separator = ": ";
    for (const NamedValue& value : signal.mask ? signal.values : std::span<const NamedValue>()) {
      comment += fmt::format("{}{} {}", separator, value.value, value.name);
      separator = ", ";
    }
    return comment;
  }

  void attribute_definitions() {
    put("BA_DEF_ \"BusType\" STRING ;\n"
        "BA_DEF_ \"Baudrate\" INT 0 1000000;\n"
        "BA_DEF_ BO_ \"GenMsgSendType\" ENUM \"cyclic\",\"event\";\n"
        "BA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 65535;\n"
        "BA_DEF_ BO_ \"GenMsgDelayTime\" INT 0 65535;\n"
        "BA_DEF_ BO_ \"GaitwayDeadline\" INT 0 1000000;\n"
        "BA_DEF_ BO_ \"SystemMessageLongSymbol\" STRING ;\n"
        "BA_DEF_DEF_ \"BusType\" \"CAN\";\n"
        "BA_DEF_DEF_ \"Baudrate\" 1000000;\n"
        "BA_DEF_DEF_ \"GenMsgSendType\" \"cyclic\";\n"
        "BA_DEF_DEF_ \"GenMsgCycleTime\" 0;\n"
        "BA_DEF_DEF_ \"GenMsgDelayTime\" 0;\n"
        "BA_DEF_DEF_ \"GaitwayDeadline\" 0;\n"
        "BA_DEF_DEF_ \"SystemMessageLongSymbol\" \"\";\n"
        "BA_ \"BusType\" \"CAN\";\n"
        "BA_ \"Baudrate\" 1000000;\n");
  }

  void attributes() {
    for (std::size_t i = 0; i < network_.messages.size(); ++i) {
      const DescribedMessage& message = network_.messages[i];
      const can::ProfileRow& row = network_.profile.row(message.kind);
      const std::int64_t period_ms = row.period_ns / kMillisecond_ns;
      if (row.on_event) {
        put("BA_ \"GenMsgSendType\" BO_ {0} 1;\nBA_ \"GenMsgDelayTime\" BO_ {0} {1};\n", message.id,
            period_ms);
      } else {
        // Of two identifiers that take turns, each comes in every other period.
        const int turns = can::has_toggle(row.rule) ? 2 : 1;
        put("BA_ \"GenMsgCycleTime\" BO_ {} {};\n", message.id, turns * period_ms);
      }
      put("BA_ \"GaitwayDeadline\" BO_ {} {};\n", message.id, row.deadline_ns / kMicrosecond_ns);
      if (names_[i] != message.name) {
        put("BA_ \"SystemMessageLongSymbol\" BO_ {} \"{}\";\n", message.id, message.name);
      }
    }
  }

  void value_names() {
    for (const DescribedMessage& message : network_.messages) {
      for (const DescribedSignal& signal : message.signals) {
        if (signal.values.empty() || signal.mask) {
          continue;
        }
        put("VAL_ {} {}", message.id, signal.name);
        for (const NamedValue& value : signal.values) {
          put(" {} \"{}\"", value.value, value.name);
        }
        put(" ;\n");
      }
    }
  }

  const NetworkDescription& network_;
  std::vector<std::string> names_;  // of the messages
  std::string text_;
};

}  // namespace

std::string dbc_text(const NetworkDescription& network) {
  return DbcWriter(network).run();
}

}  // namespace gaitway::tools
