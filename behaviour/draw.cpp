// Draws a tree from left to right: one column a level, a box as large as its text, ports below the name.
#include "gaitway/behaviour/draw.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "xml_characters.hpp"

namespace gaitway::behaviour {
namespace {

constexpr double kMargin = 20.0, kGap = 10.0, kColumnGap = 44.0, kHeading = 34.0, kLegend = 40.0;
constexpr double kStripe = 7.0, kPadding = 9.0, kNameLine = 18.0, kPortLine = 15.0, kNarrowest = 84.0;
constexpr double kNameLetter = 9.2, kPortLetter = 6.7;  // mean widths at 13 px bold and 11 px
constexpr std::size_t kLongestLine = 36, kMostPorts = 6;
constexpr std::array<std::string_view, 5> kKindColours{"#3f6fb5", "#8a5bb0", "#6b7280", "#c08a1e", "#2a8f83"};
struct Look {
  std::string_view fill, edge, mark;
};
constexpr std::array<Look, 6> kLooks{{{"#ffffff", "#b6bcc6", ""},
                                      {"#ffe3b8", "#d98200", "\u25B6"},
                                      {"#d3f0d6", "#2e8b3d", "\u2713"},
                                      {"#fbd5d3", "#c3352b", "\u2717"},
                                      {"#e9ebee", "#8b929d", "\u00BB"},
                                      {"#e6d8f5", "#7d48b8", "\u25A0"}}};

// Letters, as far as they have a width of their own; those of East Asia have two.
std::size_t letters(std::string_view text) {
  std::size_t count = 0;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    count += (byte & 0xC0U) == 0x80 ? 0 : byte >= 0xE3 && byte < 0xF0 ? 2 : 1;
  }
  return count;
}

std::string one_line(const std::string& text) {
  if (letters(text) <= kLongestLine) return text;
  std::size_t end = 0, count = 0;
  while (count < kLongestLine - 1) {
    const std::size_t before = end;
    do ++end;
    while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80);
    count += letters(std::string_view(text).substr(before, end - before));
  }
  return text.substr(0, end) + "\u2026";
}

struct Box {
  std::string title;               // what it is
  std::vector<std::string> lines;  // its name, if it has one of its own, and its ports
  double x = 0.0, y = 0.0, width = 0.0, height = 0.0;
};

Box box_of(const DescribedNode& node) {
  Box box;
  box.title = one_line(node.kind == NodeKind::sub_tree ? "SubTree " + node.id : node.id);
  if (node.segment != node.id && !node.segment.starts_with(node.id + "#"))
    box.lines.push_back(one_line("\u201C" + node.segment + "\u201D"));
  for (const auto& [port, value] : node.written) {
    if (box.lines.size() > kMostPorts) {
      box.lines.emplace_back("\u2026");
      break;
    }
    box.lines.push_back(one_line(port + " = " + value));
  }
  box.width = kNameLetter * static_cast<double>(letters(box.title) + 2);  // and the status's mark
  for (const std::string& line : box.lines) {
    box.width = std::max(box.width, kPortLetter * static_cast<double>(letters(line)));
  }
  box.width = std::max(kNarrowest, box.width + kStripe + 2.0 * kPadding);
  box.height = kNameLine + kPadding + kPortLine * static_cast<double>(box.lines.size());
  return box;
}

class Picture {
 public:
  Picture(const Description& description, std::span<const NodeStatus> statuses)
      : description_(description), statuses_(statuses) {
    for (const DescribedNode& node : description.nodes) boxes_.push_back(box_of(node));
    place_columns();
    place_rows();
  }

  std::string svg() {
    fmt::format_to(
        std::back_inserter(text_),
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"DejaVu Sans, Verdana, sans-serif\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n"
        "<text x=\"{2:.0f}\" y=\"32\" font-size=\"16\" font-weight=\"bold\" fill=\"#1f2733\">{3}</text>\n",
        width_, height_, kMargin, xml_text(one_line(description_.main_tree)));
    for (std::size_t i = 1; i < boxes_.size(); ++i) draw_line(i);
    for (std::size_t i = 0; i < boxes_.size(); ++i) draw_box(i);
    draw_legend();
    text_ += "</svg>\n";
    return std::move(text_);
  }

 private:
  void place_columns() {
    std::vector<double> widest;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      const auto depth = static_cast<std::size_t>(description_.nodes[i].depth);
      if (depth >= widest.size()) widest.resize(depth + 1, 0.0);
      widest[depth] = std::max(widest[depth], boxes_[i].width);
    }
    std::vector<double> left(widest.size() + 1, kMargin);
    for (std::size_t i = 0; i < widest.size(); ++i) left[i + 1] = left[i] + widest[i] + kColumnGap;
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      boxes_[i].x = left[static_cast<std::size_t>(description_.nodes[i].depth)];
    }
    constexpr double kNarrowestPicture = 560.0;  // room for the legend
    width_ = std::max(kNarrowestPicture, left.back() - kColumnGap + kMargin);
  }

  // Children lie below each other, their parent beside their middle, all as high as the columns allow
  // (Wetherell and Shannon 1979): what is shallow lies beside what is deep.
  void place_rows() {
    const double top = kMargin + kHeading;
    free_.assign(boxes_.size() + 1, top);
    lowered_.assign(boxes_.size(), 0.0);
    deepest_.assign(boxes_.size(), 0);
    std::vector<std::size_t> open;  // a node is placed when all below it are
    for (std::size_t i = 0; i < boxes_.size(); ++i) {
      while (!open.empty() && static_cast<NodeIndex>(i) >= description_.nodes[open.back()].end) {
        place(open.back());
        open.pop_back();
      }
      open.push_back(i);
    }
    for (; !open.empty(); open.pop_back()) place(open.back());
    for (std::size_t i = 1; i < boxes_.size(); ++i) {  // what was lowered takes along what is below it
      const auto parent = static_cast<std::size_t>(description_.nodes[i].parent);
      boxes_[i].y += lowered_[parent];
      lowered_[i] += lowered_[parent];
    }
    double bottom = top;
    for (const Box& box : boxes_) bottom = std::max(bottom, box.y + box.height);
    height_ = bottom + kLegend + kMargin;
  }

  void place(std::size_t node) {
    const DescribedNode& described = description_.nodes[node];
    const auto column = static_cast<std::size_t>(described.depth);
    Box& box = boxes_[node];
    box.y = free_[column];
    deepest_[node] = column;
    if (described.children > 0) {
      const Box& first = boxes_[node + 1];
      std::size_t last = node + 1;
      for (NodeIndex i = static_cast<NodeIndex>(last); i != kNoNode;
           i = description_.nodes[last].next_sibling) {
        last = static_cast<std::size_t>(i);
        deepest_[node] = std::max(deepest_[node], deepest_[last]);
      }
      const double middle = (first.y + first.height / 2.0 + boxes_[last].y + boxes_[last].height / 2.0) / 2.0;
      lowered_[node] = std::max(0.0, box.y - (middle - box.height / 2.0));
      box.y = middle - box.height / 2.0 + lowered_[node];
      for (std::size_t i = column + 1; i <= deepest_[node]; ++i) free_[i] += lowered_[node];
    }
    free_[column] = box.y + box.height + kGap;
  }

  void draw_line(std::size_t i) {
    const Box& child = boxes_[i];
    const Box& parent = boxes_[static_cast<std::size_t>(description_.nodes[i].parent)];
    const double x1 = parent.x + parent.width, y1 = parent.y + parent.height / 2.0;
    const double y2 = child.y + child.height / 2.0, middle = child.x - kColumnGap / 2.0;
    fmt::format_to(
        std::back_inserter(text_),
        "<path d=\"M{:.1f} {:.1f}H{:.1f}C{:.1f} {:.1f} {:.1f} {:.1f} {:.1f} {:.1f}\" fill=\"none\" "
        "stroke=\"#9aa3b0\" stroke-width=\"1.6\"/>\n",
        x1, y1, child.x - kColumnGap, middle, y1, middle, y2, child.x, y2);
  }

  void draw_box(std::size_t i) {
    const Box& box = boxes_[i];
    const DescribedNode& node = description_.nodes[i];
    const Look& look = kLooks[statuses_.empty() ? 0 : static_cast<std::size_t>(statuses_[i])];
    const double radius = node.kind == NodeKind::condition ? 12.0 : 4.0;
    auto out = std::back_inserter(text_);
    fmt::format_to(out, "<g transform=\"translate({:.1f} {:.1f})\"><title>{}</title>\n", box.x, box.y,
                   xml_text(fmt::format("{} {}, line {}", node.id, node.segment, node.line)));
    fmt::format_to(out,
                   "<rect width=\"{:.1f}\" height=\"{:.1f}\" rx=\"{:.0f}\" fill=\"{}\" stroke=\"{}\" "
                   "stroke-width=\"{}\"{}/>\n",
                   box.width, box.height, radius, look.fill, look.edge, look.mark.empty() ? "1.2" : "2",
                   node.kind == NodeKind::sub_tree ? " stroke-dasharray=\"6 3\"" : "");
    fmt::format_to(out, "<rect x=\"5\" y=\"6\" width=\"4\" height=\"{:.1f}\" rx=\"2\" fill=\"{}\"/>\n",
                   box.height - 12.0, kKindColours[static_cast<std::size_t>(node.kind)]);
    const double x = kStripe + kPadding;
    fmt::format_to(
        out, "<text x=\"{:.1f}\" y=\"18\" font-size=\"13\" font-weight=\"bold\" fill=\"#1f2733\">{}</text>\n",
        x, xml_text(box.title));
    if (!look.mark.empty()) {
      fmt::format_to(
          out, "<text x=\"{:.1f}\" y=\"18\" font-size=\"13\" text-anchor=\"end\" fill=\"{}\">{}</text>\n",
          box.width - 7.0, look.edge, look.mark);
    }
    for (std::size_t line = 0; line < box.lines.size(); ++line) {
      fmt::format_to(out, "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"11\" fill=\"#475061\">{}</text>\n", x,
                     18.0 + kPortLine * static_cast<double>(line + 1), xml_text(box.lines[line]));
    }
    text_ += "</g>\n";
  }

  void draw_legend() {
    legend_x_ = kMargin;
    if (statuses_.empty()) {
      for (std::size_t kind = 0; kind < kKindColours.size(); ++kind) {
        draw_sample({kKindColours[kind], kKindColours[kind], ""}, name(static_cast<NodeKind>(kind)));
      }
    } else {
      for (std::size_t status = 0; status < kLooks.size(); ++status) {
        draw_sample(kLooks[status], name(static_cast<NodeStatus>(status)));
      }
    }
  }

  void draw_sample(const Look& look, std::string_view what) {
    const double y = height_ - kMargin;
    fmt::format_to(
        std::back_inserter(text_),
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"16\" height=\"16\" rx=\"3\" fill=\"{}\" stroke=\"{}\"/>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"11\" text-anchor=\"middle\" fill=\"{}\">{}</text>"
        "<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"12\" fill=\"#475061\">{}</text>\n",
        legend_x_, y - 12.0, look.fill, look.edge, legend_x_ + 8.0, y, look.edge, look.mark, legend_x_ + 22.0,
        y, what);
    legend_x_ += 40.0 + 7.4 * static_cast<double>(what.size());
  }

  const Description& description_;
  std::span<const NodeStatus> statuses_;
  std::vector<Box> boxes_;
  std::vector<double> free_;          // of each column, where the next box may begin
  std::vector<double> lowered_;       // of each node, how far those below it still have to be
  std::vector<std::size_t> deepest_;  // of each node, the last column that it reaches with those below it
  double width_ = 0.0, height_ = 0.0, legend_x_ = 0.0;
  std::string text_;
};

}  // namespace

std::string draw(const Description& description, std::span<const NodeStatus> statuses) {
  if (description.nodes.empty()) throw std::invalid_argument("a behaviour tree without nodes can't be drawn");
  if (!statuses.empty() && statuses.size() != description.nodes.size()) {
    throw std::invalid_argument(
        fmt::format("{} statuses for {} nodes", statuses.size(), description.nodes.size()));
  }
  return Picture(description, statuses).svg();
}

}  // namespace gaitway::behaviour
