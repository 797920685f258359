// URIs of what can be spawned: what they mean, and what is refused by part, value and rule.
#include "userinterface/sessions/spawnables.hpp"

#include <gmock/gmock.h>

#include <string>

namespace gaitway::api {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;

std::string refusal_of(const std::string& uri) {
  try {
    static_cast<void>(spawnable_of(uri));
  } catch (const SpawnableError& error) {
    return error.what();
  }
  ADD_FAILURE() << uri << " is none";
  return {};
}

TEST(Spawnables, AUriSaysShapeSizeMassAndColour) {
  const SpawnableBody body = spawnable_of("gaitway:box?size=0.1,0.2,0.3&mass=0.5&colour=1,0.5,0");
  EXPECT_EQ(body.shape, "box");
  EXPECT_EQ(body.size_m, (std::array{0.1, 0.2, 0.3}));
  EXPECT_EQ(body.mass_kg, 0.5);
  EXPECT_EQ(body.colour_rgb, (std::array{1.0, 0.5, 0.0}));
  const SpawnableBody plain = spawnable_of("gaitway:sphere");
  EXPECT_EQ(plain.size_m, (std::array{0.1, 0.1, 0.1}));
  EXPECT_FALSE(plain.mass_kg) << "it stands fast";
  EXPECT_EQ(spawnable_of("gaitway:cylinder?mass=2&size=0.2,0.2,1").size_m[2], 1.0);
}

TEST(Spawnables, WhatIsNoneIsRefusedByPartValueAndRule) {
  EXPECT_THAT(refusal_of("gaitway:cone"),
              AllOf(HasSubstr("shape is \"cone\""), HasSubstr("box, cylinder or sphere")));
  EXPECT_THAT(refusal_of("gaitway:"), HasSubstr("shape is \"\""));
  EXPECT_THAT(refusal_of("gaitway:box?size=0.1"), HasSubstr("size is \"0.1\", but must be three numbers"));
  EXPECT_THAT(refusal_of("gaitway:box?size=0.1,0.1,"), HasSubstr("size is \"\""));
  EXPECT_THAT(refusal_of("gaitway:box?size=0.1,0.1,1e9"), HasSubstr("size is \"1e9\""));
  EXPECT_THAT(refusal_of("gaitway:box?size=nan,1,1"), HasSubstr("size is \"nan\""));
  EXPECT_THAT(refusal_of("gaitway:box?mass=0"), HasSubstr("mass is \"0\", but must be a number from 0.001"));
  EXPECT_THAT(refusal_of("gaitway:box?mass=1kg"), HasSubstr("mass is \"1kg\""));
  EXPECT_THAT(refusal_of("gaitway:box?colour=2,0,0"), HasSubstr("colour is \"2\""));
  EXPECT_THAT(refusal_of("gaitway:box?weight=2"), HasSubstr("a part of the URI is \"weight\""));
  EXPECT_THAT(refusal_of("gaitway:sphere?size=0.1,0.1,0.2"), HasSubstr("one diameter three times"));
  EXPECT_THAT(refusal_of("gaitway:cylinder?size=0.1,0.2,0.2"), HasSubstr("two equal diameters and a height"));
}

TEST(Spawnables, EveryOneThatIsListedCanBeSpawned) {
  const auto all = spawnables();
  EXPECT_THAT(all, SizeIs(3));
  for (const auto& one : all) {
    EXPECT_TRUE(is_spawnable_uri(one.entity_resource.uri));
    const SpawnableBody body = spawnable_of(one.entity_resource.uri);
    ASSERT_THAT(one.spawn_bounds.points, SizeIs(2));
    EXPECT_EQ(one.spawn_bounds.type, 1);
    EXPECT_EQ(one.spawn_bounds.points[0].x, body.size_m[0] / 2.0);
    EXPECT_EQ(one.spawn_bounds.points[1].z, -body.size_m[2] / 2.0);
    EXPECT_THAT(one.description, HasSubstr("without it, it stands fast"));
  }
  EXPECT_FALSE(is_spawnable_uri("file:///box.sdf"));
}

}  // namespace
}  // namespace gaitway::api
