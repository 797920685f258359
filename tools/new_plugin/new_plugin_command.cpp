// `gaitway new-plugin`: writes a plug-in's project, made from the templates, that builds, passes its test and
// moves the robot as it is.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/input/complaint.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/text_file.hpp"
#include "tools/command_line.hpp"

namespace gaitway::tools {
namespace {

struct NewPluginOptions {
  std::string name;
  std::string kind = "blank";
  std::filesystem::path folder;  // empty: ./NAME
};

struct Kind {
  std::string_view name;
  std::string_view library;  // of the shipped algorithms that the template uses; empty: none
  std::string_view does;
  bool has_tree = false;  // and so a file NAME.xml, too
};
constexpr std::array kKinds{
    Kind{"blank", "", "reads the estimate and reports steps; writes nothing yet"},
    Kind{"behaviour", "behaviour_plugin", "decides: a mission with a leaf of its own", true},
    Kind{"commander", "", "decides in code of its own, without a tree: walks a square"},
    Kind{"trajectory", "trajectory", "a gait: slow, with high steps"},
    Kind{"kinematics", "kinematics", "joint angles: arms that swing against the legs"},
    Kind{"stability", "", "balance: the ankles press against the trunk's lean"},
    Kind{"zmp", "zmp", "state estimation: says when a foot tips over its edge"},
    Kind{"vision", "kinematics", "turns the head to where the robot will walk"},
};

// Names that would clash with the words of C++ or with what the project's files define.
constexpr std::array kTakenNames =
    std::to_array<std::string_view>({"all",           "clean",       "help",
                                     "install",       "package",     "test",
                                     "alignas",       "alignof",     "and",
                                     "and_eq",        "asm",         "auto",
                                     "bitand",        "bitor",       "bool",
                                     "break",         "case",        "catch",
                                     "char",          "char8_t",     "char16_t",
                                     "char32_t",      "class",       "compl",
                                     "concept",       "const",       "consteval",
                                     "constexpr",     "constinit",   "const_cast",
                                     "continue",      "co_await",    "co_return",
                                     "co_yield",      "decltype",    "default",
                                     "delete",        "do",          "double",
                                     "dynamic_cast",  "else",        "enum",
                                     "explicit",      "export",      "extern",
                                     "false",         "float",       "for",
                                     "friend",        "goto",        "if",
                                     "inline",        "int",         "long",
                                     "mutable",       "namespace",   "new",
                                     "noexcept",      "not",         "not_eq",
                                     "nullptr",       "operator",    "or",
                                     "or_eq",         "private",     "protected",
                                     "public",        "register",    "reinterpret_cast",
                                     "requires",      "return",      "short",
                                     "signed",        "sizeof",      "static",
                                     "static_assert", "static_cast", "struct",
                                     "switch",        "template",    "this",
                                     "thread_local",  "throw",       "true",
                                     "try",           "typedef",     "typeid",
                                     "typename",      "union",       "unsigned",
                                     "using",         "virtual",     "void",
                                     "volatile",      "wchar_t",     "while"});
constexpr std::size_t kLongestName = 40;

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

void check_name(const std::string& name) {
  const bool characters =
      std::ranges::all_of(name, [](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; });
  std::string rule;
  if (name.empty() || !is_letter(name.front()) || !characters) {
    rule = "must begin with a letter and go on with letters, digits and '_', as an identifier of C does";
  } else if (name.size() > kLongestName) {
    rule = fmt::format("must have at most {} characters", kLongestName);
  } else if (std::ranges::find(kTakenNames, name) != kTakenNames.end()) {
    rule = "means something else already";
  }
  if (!rule.empty()) {
    throw std::invalid_argument(fmt::format("NAME '{}': {}. Write for example ankle_feedback", name, rule));
  }
}

const Kind& kind_of(const std::string& name) {
  std::vector<std::string> known;
  for (const Kind& kind : kKinds) {
    if (kind.name == name) {
      return kind;
    }
    known.emplace_back(kind.name);
  }
  throw std::invalid_argument(
      fmt::format("--kind {}: there is no such kind. {}", name, input::suggest(name, known)));
}

// ankle_feedback: AnkleFeedback.
std::string class_name(const std::string& name) {
  std::string result;
  bool begins = true;
  for (const char c : name) {
    if (c != '_') {
      result += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    }
    begins = c == '_';
  }
  // The class of the plug-in interface has that name.
  return result == "Plugin" || result == "Setup" || result == "Tick" ? result + "Plugin" : result;
}

std::string replaced(std::string text, std::string_view token, std::string_view by) {
  for (std::size_t at = text.find(token); at != std::string::npos; at = text.find(token, at + by.size())) {
    text.replace(at, token.size(), by);
  }
  return text;
}

std::string from_template(const std::string& file, const NewPluginOptions& options, const Kind& kind) {
  const std::filesystem::path path = process::template_directory() / file;
  std::ifstream in(path);
  if (!in) {
    throw std::runtime_error(fmt::format("{}: cannot be read. Install gaitway anew", path.string()));
  }
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::string library(kind.library);
  text = replaced(text, "plugin_components", "plugin simulator" + (library.empty() ? "" : " " + library));
  text = replaced(text, " plugin_links", library.empty() ? "" : " LINKS gaitway::" + library);
  text = replaced(text, "plugin_tree\n",
                  kind.has_tree ? "target_compile_definitions(plugin_name PRIVATE "
                                  "GAITWAY_PLUGIN_TREE=\"${CMAKE_CURRENT_SOURCE_DIR}/plugin_name.xml\")\n"
                                : "");
  return replaced(replaced(text, "PluginName", class_name(options.name)), "plugin_name", options.name);
}

struct ProjectFile {
  std::filesystem::path path;
  std::string text;
};

void write_all(const std::vector<ProjectFile>& files, const std::filesystem::path& folder) {
  for (const ProjectFile& file : files) {
    if (std::filesystem::exists(file.path)) {
      throw std::invalid_argument(
          fmt::format("{}: is there already. Choose another --dir, or remove it", file.path.string()));
    }
  }
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw std::invalid_argument(
        fmt::format("--dir {}: {}. Choose another one", folder.string(), error.message()));
  }
  std::vector<std::filesystem::path> written;
  try {
    for (const ProjectFile& file : files) {
      process::write_text_file(file.path, file.text);
      written.push_back(file.path);
    }
  } catch (...) {
    for (const std::filesystem::path& path : written) {
      std::filesystem::remove(path, error);
    }
    throw;
  }
}

// Where cmake looks anyway, it needs no telling.
std::string package_option() {
  const std::filesystem::path package = process::package_directory();
  const std::string text = package.string();
  const bool found_alone = text.starts_with("/usr/lib/") || text.starts_with("/usr/local/lib/");
  return found_alone ? "" : " -Dgaitway_DIR=" + text;
}

void print_next(const NewPluginOptions& options, const Kind& kind, const std::filesystem::path& folder) {
  const std::string dir = folder.string();
  fmt::print(
      "{0}/{1}.cpp  {0}/{1}_test.cpp  {0}/CMakeLists.txt{3}\n\n"
      "Next:\n"
      "  cmake -S {0} -B {0}/build{2}\n"
      "  cmake --build {0}/build\n"
      "  ctest --test-dir {0}/build --output-on-failure\n"
      "{4}"
      "  gaitway run --with {0}/build/lib{1}.so\n",
      dir, options.name, package_option(), kind.has_tree ? fmt::format("  {}/{}.xml", dir, options.name) : "",
      kind.has_tree ? fmt::format("  gaitway behaviour check {0}/{1}.xml --with {0}/build/lib{1}.so\n", dir,
                                  options.name)
                    : "");
}

std::string kinds_as_text() {
  std::string text = "Kinds:\n";
  for (const Kind& kind : kKinds) {
    text += fmt::format("  {:<11} {}\n", kind.name, kind.does);
  }
  return text;
}

int write_new_plugin(const NewPluginOptions& options) {
  check_name(options.name);
  const Kind& kind = kind_of(options.kind);
  const std::filesystem::path folder =
      options.folder.empty() ? std::filesystem::path(options.name) : options.folder;
  const std::string stem(kind.name);
  std::vector<ProjectFile> files{
      {folder / (options.name + ".cpp"), from_template(stem + ".cpp", options, kind)},
      {folder / (options.name + "_test.cpp"), from_template(stem + "_test.cpp", options, kind)},
      {folder / "CMakeLists.txt", from_template("CMakeLists.txt", options, kind)}};
  if (kind.has_tree)
    files.push_back({folder / (options.name + ".xml"), from_template(stem + ".xml", options, kind)});
  write_all(files, folder);
  print_next(options, kind, folder);
  return kExitFine;
}

}  // namespace

void declare_program(const CommandLine& app) {
  const CommandLine command = add_command(app, "new-plugin");
  NewPluginOptions& options = command.runs(write_new_plugin);
  command.option("NAME", options.name, "Name of the plug-in, as an identifier of C: ankle_feedback")
      .required();
  command.option("--kind", options.kind, "What it begins as; see below");
  command.option("--dir", options.folder, "Folder to write it to (default ./NAME)");
  command.footer(kinds_as_text() +
                 "Examples:\n"
                 "  gaitway new-plugin square --kind commander\n"
                 "  gaitway new-plugin my_gait --kind trajectory --dir ~/robot/my_gait\n"
                 "Exit code: 0 written, 1 the input was bad and nothing was.");
}

}  // namespace gaitway::tools
