// The shipped missions: they are read without a complaint, and editors find the leaves that they use.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gaitway/behaviour_leaves/leaves.hpp"
#include "gaitway/behaviour_leaves/mission.hpp"
#include "gaitway/behaviour_leaves/node_model.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/input/text.hpp"
#include "leaf_table.hpp"

namespace gaitway::behaviour_leaves {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

behaviour::Registry leaves() {
  behaviour::Registry registry;
  register_leaves(registry);
  return registry;
}

TEST(Missions, Shipped) {
  EXPECT_THAT(shipped_missions(),
              ElementsAre("find_and_walk_to_tag", "follow_tag", "patrol", "stand_up_after_falls"));
}

TEST(Leaves, AreInTheManualAsTheyAre) {
  const std::string manual =
      input::read_text_file(std::filesystem::path(GAITWAY_SOURCE_DIR) / "docs" / "behaviour.md", "");
  EXPECT_THAT(manual, HasSubstr(leaf_table(leaves(), true)));
  EXPECT_THAT(manual, HasSubstr(leaf_table(leaves(), false)));
}

class ShippedMission : public testing::TestWithParam<std::string> {};

TEST_P(ShippedMission, IsReadAndCanGetUp) {
  const Mission mission = read_mission(GetParam(), leaves());
  EXPECT_FALSE(mission.tree.nodes.empty());
  ASSERT_TRUE(mission.stand_up.has_value());
  EXPECT_EQ(mission.stand_up->main_tree, kStandUpTree);
}

TEST_P(ShippedMission, HasAnEndOrGoesOnForEver) {
  const Mission mission = read_mission(GetParam(), leaves());
  EXPECT_EQ(mission.tree.may_succeed, GetParam() == "find_and_walk_to_tag");
}

TEST_P(ShippedMission, TellsEditorsItsLeaves) {
  const behaviour::Registry registry = leaves();
  const Mission mission = read_mission(GetParam(), registry);
  EXPECT_THAT(input::read_text_file(mission.file, ""), HasSubstr(tree_nodes_model(registry, mission.tree)));
}

INSTANTIATE_TEST_SUITE_P(All, ShippedMission,
                         testing::Values("find_and_walk_to_tag", "follow_tag", "patrol",
                                         "stand_up_after_falls"),
                         [](const auto& mission) { return mission.param; });

TEST(Missions, AnUnknownNameIsRefusedWithTheNearest) {
  try {
    static_cast<void>(find_mission("patrole"));
    FAIL();
  } catch (const input::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("patrole"));
    EXPECT_THAT(error.what(), HasSubstr("patrol"));
  }
}

TEST(Missions, AFolderIsCalledOne) {
  try {
    static_cast<void>(find_mission(testing::TempDir()));
    FAIL();
  } catch (const input::InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("it is a folder"));
  }
}

}  // namespace
}  // namespace gaitway::behaviour_leaves
