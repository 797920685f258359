// Puts a complaint into words that a terminal may show; edit distance, one row of the table at a time.
#include "gaitway/input/complaint.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "gaitway/input/text.hpp"

namespace gaitway::input {
namespace {

// Nobody reads a value to its end that is longer.
std::string shortened(const std::string& value) {
  constexpr std::size_t kMost = 200;
  return value.size() <= kMost ? value
                               : fmt::format("{}... ({} bytes)", value.substr(0, kMost), value.size());
}

std::string as_sentence(const std::string& text) {
  return text.ends_with('.') || text.ends_with('?') ? text : text + ".";
}

}  // namespace

std::string in_words(const Complaint& complaint) {
  std::string text = complaint.file.string();
  if (complaint.line > 0) {
    text += fmt::format(":{}", complaint.line);
  }
  text += ": ";
  if (!complaint.field.empty()) {
    text += shortened(complaint.field);
    text += complaint.value.empty() ? ": " : fmt::format(" = {}: ", shortened(complaint.value));
  }
  text += as_sentence(complaint.rule);
  if (!complaint.remedy.empty()) {
    text += ' ';
    text += as_sentence(complaint.remedy);
  }
  return terminal_text(text);
}

void refuse(const Complaint& complaint) {
  throw InputError(in_words(complaint));
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> before, row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::vector<std::size_t> next(b.size() + 1, i + 1);
    for (std::size_t j = 0; j < b.size(); ++j) {
      next[j + 1] = std::min({row[j] + (a[i] == b[j] ? 0 : 1), row[j + 1] + 1, next[j] + 1});
      if (i > 0 && j > 0 && a[i] == b[j - 1] && a[i - 1] == b[j]) {
        next[j + 1] = std::min(next[j + 1], before[j - 1] + 1);
      }
    }
    before = std::move(row);
    row = std::move(next);
  }
  return row.back();
}

std::optional<std::string> nearest_name(std::string_view name, std::span<const std::string> candidates) {
  const auto nearer = [name](const std::string& a, const std::string& b) {
    return edit_distance(name, a) < edit_distance(name, b);
  };
  const auto best = std::ranges::min_element(candidates, nearer);
  if (best == candidates.end() || edit_distance(name, *best) > std::max(name.size(), best->size()) / 2) {
    return std::nullopt;
  }
  return *best;
}

std::string suggest(std::string_view name, std::span<const std::string> candidates) {
  if (const auto nearest = nearest_name(name, candidates)) {
    return fmt::format("Did you mean '{}'?", *nearest);
  }
  return candidates.empty() ? "There is none." : fmt::format("Known here: {}.", fmt::join(candidates, ", "));
}

}  // namespace gaitway::input
