// Parses by CLI11, with conversions of our own: its numbers may be nan, and too large ones are cut in
// silence.
#include "tools/command_line.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>

#include "gaitway/input/complaint.hpp"
#include "gaitway/input/number.hpp"
#include "gaitway/input/text.hpp"

namespace gaitway::tools {
namespace {

template <class Value>
struct Element {
  using Type = Value;
  static constexpr bool kList = false, kOptional = false;
};
template <class Value>
struct Element<std::optional<Value>> {
  using Type = typename Element<Value>::Type;
  static constexpr bool kList = Element<Value>::kList, kOptional = true;
};
template <class Value>
struct Element<std::vector<Value>> {
  using Type = Value;
  static constexpr bool kList = true, kOptional = false;
};

[[noreturn]] void refuse(const std::string& option, const std::string& text, const std::string& rule) {
  throw CLI::ConversionError(fmt::format("{} {}: {}", option, text, rule));  // it names the option itself
}

template <class Number>
Number number_in(const std::string& option, const std::string& text) {
  using Read = std::conditional_t<std::is_same_v<Number, int>, std::int64_t, Number>;
  try {
    const auto number = input::plain_number<Read>(text);
    if (number >= std::numeric_limits<Number>::lowest() && number <= std::numeric_limits<Number>::max()) {
      return static_cast<Number>(number);
    }
  } catch (const input::ValueError& error) {
    if (std::is_floating_point_v<Number> || !error.remedy.empty()) {
      refuse(option, text, error.what());
    }
  }
  refuse(option, text,
         fmt::format("must be a whole number from {} to {}", std::numeric_limits<Number>::lowest(),
                     std::numeric_limits<Number>::max()));
}

template <class Value>
Value value_in(const std::string& option, const std::string& text) {
  if constexpr (std::is_arithmetic_v<Value>) {
    return number_in<Value>(option, text);
  } else {
    return Value(text);
  }
}

template <class Value>
std::string text_of(const Value& value) {
  if constexpr (std::is_arithmetic_v<Value>) {
    return fmt::format("{}", value);
  } else if constexpr (std::is_same_v<Value, std::filesystem::path>) {
    return value.string();
  } else {
    return value;
  }
}

template <class Value>
std::string default_of(const Value& value) {
  if constexpr (Element<Value>::kOptional) {
    return {};
  } else if constexpr (Element<Value>::kList) {
    std::string text;
    for (const auto& one : value) {
      text += (text.empty() ? "" : ",") + text_of(one);
    }
    return text;
  } else {
    return text_of(value);
  }
}

template <class Value>
const char* type_name() {
  if constexpr (std::is_floating_point_v<Value>) {
    return "NUMBER";
  } else if constexpr (std::is_arithmetic_v<Value>) {
    return "COUNT";
  } else {
    return "TEXT";
  }
}

template <class Value>
CLI::Option& declare(CLI::App& app, const std::string& names, Value& value, const std::string& help) {
  using One = typename Element<Value>::Type;
  CLI::Option* const option = app.add_option(
      names,
      [names, &value](const CLI::results_t& texts) {
        if constexpr (Element<Value>::kList) {
          std::vector<One> values;
          for (const std::string& text : texts) {
            values.push_back(value_in<One>(names, text));
          }
          value = std::move(values);
        } else {
          value = value_in<One>(names, texts.front());
        }
        return true;
      },
      help);
  option->type_name(type_name<One>());
  if (Element<Value>::kList) {
    option->expected(1, CLI::detail::expected_max_vector_size);
  }
  if (const std::string text = default_of(value); !text.empty()) {
    option->default_str(text);
  }
  return *option;
}

// All commands below `app`, and their options.
void add_names(const CLI::App& app, std::vector<std::string>& known) {
  for (const CLI::App* const command :
       app.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); })) {
    known.push_back(command->get_name());
    for (const CLI::Option* const option : command->get_options()) {
      std::ranges::transform(option->get_lnames(), std::back_inserter(known),
                             [](const std::string& name) { return "--" + name; });
    }
    add_names(*command, known);
  }
}

// What is wrong with the line, in one line: the nearest command or option, which CLI11 leaves open, or the
// rule.
void explain(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<std::string> rest = app.remaining(true);
  if (rest.empty()) {
    fmt::print(stderr, "gaitway: {}. See --help\n", input::terminal_text(error.what()));
    return;
  }
  std::vector<std::string> known;
  add_names(app, known);
  fmt::print(stderr, "gaitway: '{}': there is no such command or option. {}\n",
             input::terminal_text(rest.front()), input::suggest(rest.front(), known));
}

int parse_and_run(int argc, char** argv, void (*declare)(const CommandLine& program)) {
  CLI::App app{
      "Gaitway: the main controller of a humanoid robot, and everything below it that makes it move."};
  app.require_subcommand(1);
  app.set_version_flag("--version", GAITWAY_VERSION);
  std::function<int()> action;
  declare(CommandLine(app, action));
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help_or_version) {
    return app.exit(help_or_version);
  } catch (const CLI::ParseError& error) {
    explain(app, error);
    return kExitBadInput;
  }
  return action();
}

}  // namespace

Option Option::required() const {
  option_->required();
  option_->default_str("");  // which nobody gets
  return *this;
}

Option Option::excludes(const Option& other) const {
  option_->excludes(other.option_);
  return *this;
}

Option Option::between(double lowest, double highest) const {
  option_->check([name = option_->get_name(), lowest, highest](const std::string& text) {
    const auto number = number_in<double>(name, text);
    if (number < lowest || number > highest) {
      refuse(name, text, fmt::format("must lie between {} and {}", lowest, highest));
    }
    return std::string();
  });
  return *this;
}

Option Option::above(double limit) const {
  option_->check([name = option_->get_name(), limit](const std::string& text) {
    if (number_in<double>(name, text) <= limit) {
      refuse(name, text, fmt::format("must be above {}", limit));
    }
    return std::string();
  });
  return *this;
}

Option Option::one_of(std::vector<std::string> words) const {
  option_->check(CLI::IsMember(std::move(words)));
  return *this;
}

Option Option::values(int count) const {
  option_->expected(count);
  return *this;
}

Option Option::existing_folder() const {
  option_->check(CLI::ExistingDirectory);
  return *this;
}

Option Option::hidden() const {
  option_->group("");
  return *this;
}

CommandLine CommandLine::subcommand(const std::string& name, const std::string& help) const {
  return {*app_->add_subcommand(name, help), *action_};
}

CommandLine CommandLine::group(const std::string& title, bool one_of_them) const {
  CLI::App& group = *app_->add_option_group(title);
  if (one_of_them) {
    group.require_option(1);
  }
  return {group, *action_};
}

template <class Value>
Option CommandLine::option(const std::string& names, Value& value, const std::string& help) const {
  if constexpr (std::is_same_v<Value, bool>) {
    return Option(*app_->add_flag(names, value, help));
  } else {
    CLI::Option& option = declare(*app_, names, value, help);
    if (Element<Value>::kList) {
      option.delimiter(',');
    }
    return Option(option);
  }
}

template <class Value>
Option CommandLine::repeated(const std::string& names, std::vector<Value>& values,
                             const std::string& help) const {
  return Option(*declare(*app_, names, values, help).allow_extra_args(!names.starts_with('-')));
}

template Option CommandLine::option(const std::string&, bool&, const std::string&) const;
template Option CommandLine::option(const std::string&, double&, const std::string&) const;
template Option CommandLine::option(const std::string&, int&, const std::string&) const;
template Option CommandLine::option(const std::string&, std::int64_t&, const std::string&) const;
template Option CommandLine::option(const std::string&, std::uint64_t&, const std::string&) const;
template Option CommandLine::option(const std::string&, std::string&, const std::string&) const;
template Option CommandLine::option(const std::string&, std::filesystem::path&, const std::string&) const;
template Option CommandLine::option(const std::string&, std::optional<double>&, const std::string&) const;
template Option CommandLine::option(const std::string&, std::optional<int>&, const std::string&) const;
template Option CommandLine::option(const std::string&, std::optional<std::uint64_t>&,
                                    const std::string&) const;
template Option CommandLine::option(const std::string&, std::optional<std::string>&,
                                    const std::string&) const;
template Option CommandLine::option(const std::string&, std::optional<std::filesystem::path>&,
                                    const std::string&) const;
template Option CommandLine::option(const std::string&, std::vector<double>&, const std::string&) const;
template Option CommandLine::option(const std::string&, std::vector<std::string>&, const std::string&) const;
template Option CommandLine::option(const std::string&, std::optional<std::vector<double>>&,
                                    const std::string&) const;
template Option CommandLine::repeated(const std::string&, std::vector<std::string>&,
                                      const std::string&) const;
template Option CommandLine::repeated(const std::string&, std::vector<std::filesystem::path>&,
                                      const std::string&) const;

void CommandLine::footer(const std::string& text) const {
  app_->footer(text);
}

void CommandLine::renamed(const std::string& old_name, const std::string& new_name) const {
  CLI::App& old = *app_->add_subcommand(old_name, "");
  old.group("");  // not in --help
  old.prefix_command();
  CommandLine(old, *action_).runs([path = app_->get_name() + " " + old_name, new_name] {
    fmt::print(stderr, "gaitway: 'gaitway {}' is called 'gaitway {}'\n", path, new_name);
    return kExitBadInput;
  });
}

void CommandLine::needs_subcommand() const {
  app_->require_subcommand(1);
}

void CommandLine::runs(std::function<int()> action) const {
  // A part of the command that was given has its own.
  app_->callback([app = app_, given = action_, action = std::move(action)] {
    if (app->get_subcommands().empty()) *given = action;
  });
}

CommandLine add_command(const CommandLine& program, std::string_view name) {
  const auto* const command = std::ranges::find(kCommands, name, &Command::name);
  if (command == kCommands.end()) {
    throw std::logic_error(fmt::format("'{}' is missing in the list of commands", name));
  }
  return program.subcommand(command->name, command->help);
}

int run_program(int argc, char** argv, void (*declare)(const CommandLine& program)) {
  try {
    return parse_and_run(argc, argv, declare);
  } catch (const std::exception& error) {
    fmt::print(stderr, "gaitway: {}\n", input::terminal_text(error.what()));
    return dynamic_cast<const NotDone*>(&error) != nullptr ? kExitNotDone : kExitBadInput;
  }
}

ProgressLine::ProgressLine(bool wanted) : shown_(wanted && isatty(STDERR_FILENO) != 0) {}

void ProgressLine::show(const std::string& text) const {
  if (shown_) {
    fmt::print(stderr, "\r{:78}\r{}", "", text);
    std::fflush(stderr);
  }
}

void prepare_output(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const std::filesystem::path probe = folder / ".gaitway_writable";
  const bool writable = !error && std::ofstream(probe).is_open();
  if (!writable) {
    throw std::invalid_argument(
        fmt::format("--out {}: must be a folder that can be written to{}. Choose another one",
                    folder.string(), error ? " (" + error.message() + ")" : ""));
  }
  std::filesystem::remove(probe, error);
}

}  // namespace gaitway::tools
