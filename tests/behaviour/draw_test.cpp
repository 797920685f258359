// Pictures of trees: whole, well-formed, and nothing lies over anything else. How they look was judged by
// eye: GAITWAY_PICTURES names a folder into which this test writes some.
#include "gaitway/behaviour/draw.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "deep_tree.hpp"
#include "random_tree.hpp"
#include "scripted_leaves.hpp"
#include "xml_document.hpp"

namespace gaitway::behaviour::test {
namespace {

struct Rectangle {
  double x, y, width, height;
};

double number(const XmlElement& element, const char* attribute) {
  return std::stod(element.find(attribute)->value);
}

// Of the nodes: the first rectangle of each group.
std::vector<Rectangle> boxes(const std::string& svg) {
  const auto elements = parse_xml(svg, "drawing.svg");
  std::vector<Rectangle> found;
  for (std::size_t i = 0; i + 2 < elements.size(); ++i) {
    if (elements[i].name != "g") continue;
    const std::string place = elements[i].find("transform")->value;  // translate(x y)
    const std::size_t open = place.find('('), blank = place.find(' ');
    found.push_back({std::stod(place.substr(open + 1)), std::stod(place.substr(blank)),
                     number(elements[i + 2], "width"), number(elements[i + 2], "height")});
  }
  return found;
}

bool apart(const Rectangle& a, const Rectangle& b) {
  return a.x + a.width <= b.x || b.x + b.width <= a.x || a.y + a.height <= b.y || b.y + b.height <= a.y;
}

void keep(const std::string& name, const std::string& svg) {
  const char* const folder = std::getenv("GAITWAY_PICTURES");
  if (folder != nullptr) std::ofstream(std::filesystem::path(folder) / (name + ".svg")) << svg;
}

TEST(Drawing, EveryNodeHasABoxOfItsOwn) {
  bool kept = false;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    RandomLeaves leaves(seed);
    Tree tree(parse_tree(random_file(seed, 60), "r.xml", leaves.registry()), leaves.registry());
    const std::string svg = draw(tree.description());
    const auto all = boxes(svg);
    ASSERT_EQ(all.size(), tree.description().nodes.size());
    const XmlElement picture = parse_xml(svg, "drawing.svg")[0];
    for (std::size_t i = 0; i < all.size(); ++i) {
      EXPECT_GE(all[i].x, 0.0);
      EXPECT_LE(all[i].x + all[i].width, number(picture, "width"));
      EXPECT_LE(all[i].y + all[i].height, number(picture, "height"));
      for (std::size_t j = i + 1; j < all.size(); ++j)
        ASSERT_TRUE(apart(all[i], all[j])) << seed << ": " << i << ", " << j;
    }
    if (!kept && all.size() > 45) {
      kept = true;
      for (int tick = 0; tick < 7; ++tick) (void)tree.tick(tick * kTick_ns);
      keep("random", draw(tree.description(), tree.statuses()));
    }
  }
}

const char* const kPatrol = R"(<root BTCPP_format="4" main_tree_to_execute="Patrol">
  <BehaviorTree ID="Patrol"><ReactiveFallback>
    <Sequence name="battery low"><P name="IsBatteryLow" does="FFS"/><A name="GoToDock" does="R"/></Sequence>
    <Timeout msec="5 min"><SubTree ID="Round" goal="{goal}" speed="0.3 m/s"/></Timeout>
    <RetryUntilSuccessful num_attempts="3"><B name="CallForHelp &lt;loudly&gt; &amp; wait until somebody comes" does="R" ends="2"/></RetryUntilSuccessful>
  </ReactiveFallback></BehaviorTree>
  <BehaviorTree ID="Round"><Parallel success_count="2"><Sequence><C name="WalkTo" does="{goal}"/><D name="LookAround" does="RS"/></Sequence>
    <KeepRunningUntilFailure><R name="IsUpright" does="S"/></KeepRunningUntilFailure><E does="{speed}"/></Parallel></BehaviorTree></root>)";

TEST(Drawing, TextIsEscapedAndShortened) {
  Script script;
  std::string file = kPatrol;
  file.replace(file.find("5 min"), 5, "300 s");
  Tree tree(parse_tree(file, "t.xml", script.registry()), script.registry());
  ASSERT_TRUE(tree.set_value(*tree.entry("goal"), Text("RRRS")));
  const std::string plain = draw(tree.description());
  EXPECT_THAT(plain, testing::HasSubstr("&lt;loudly&gt; &amp;"));
  EXPECT_THAT(plain, testing::HasSubstr("\u2026"));
  keep("plain", plain);
  (void)tree.tick(0);
  (void)tree.tick(kTick_ns);
  const std::string running = draw(tree.description(), tree.statuses());
  EXPECT_NE(plain, running);
  keep("running", running);
  (void)tree.tick(2 * kTick_ns);
  keep("halted", draw(tree.description(), tree.statuses()));
}

TEST(Drawing, OfTheLargestTreesIsStillDone) {
  Script script;
  std::string wide = "<Sequence>";
  for (std::size_t i = 1; i < kMostNodes; ++i) wide += "<A/>";
  EXPECT_EQ(boxes(draw(described("<Sequence>" + wide.substr(10) + "</Sequence>", script))).size(),
            kMostNodes);
  const Description deep = parse_tree(deep_file(kMostDepth, "<A/>"), "t.xml", script.registry());
  EXPECT_EQ(boxes(draw(deep)).size(), kMostDepth);
}

TEST(Drawing, StatusesMustBeThoseOfTheTree) {
  Script script;
  const Description tree = described("<A/>", script);
  const std::vector<NodeStatus> two(2, NodeStatus::idle);
  EXPECT_THROW((void)draw(tree, two), std::invalid_argument);
  EXPECT_THROW((void)draw(Description{}), std::invalid_argument);
}

}  // namespace
}  // namespace gaitway::behaviour::test
