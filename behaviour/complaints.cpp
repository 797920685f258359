// Puts all complaints about a file into the file's order and into words.
#include "complaints.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace gaitway::behaviour {
namespace {

// The path of a deep node: its two ends tell enough.
std::string shortened(const std::string& path) {
  constexpr std::size_t kMost = 160;
  if (path.size() <= kMost) return path;
  return path.substr(0, kMost / 4) + " ... " + path.substr(path.size() - kMost * 3 / 4);
}

std::string in_words(const std::vector<TreeComplaint>& complaints) {
  std::string text;
  for (const TreeComplaint& complaint : complaints) {
    input::Complaint line = complaint;
    if (!complaint.path.empty())
      line.field = shortened(complaint.path) + (line.field.empty() ? "" : " " + line.field);
    text += (text.empty() ? "" : "\n") + input::in_words(line);
  }
  if (complaints.size() >= kMostComplaints) text += "\nMore is not told before these are mended.";
  return text;
}

}  // namespace

BadTree::BadTree(std::vector<TreeComplaint> complaints)
    : InputError(in_words(complaints)), complaints_(std::move(complaints)) {}

void Complaints::throw_if_any() {
  if (all_.empty()) return;
  std::ranges::stable_sort(all_, {}, [](const TreeComplaint& complaint) { return complaint.line; });
  throw BadTree(std::move(all_));
}

}  // namespace gaitway::behaviour
