// What is unloaded is really gone.
#include <fstream>

#include "plugin_fixture.hpp"

namespace gaitway::core {
namespace {

class PluginUnloading : public PluginFixture {
 protected:
  static bool is_mapped(const std::string& library) {
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
      if (line.find("/memfd:" + library) != std::string::npos) {
        return true;
      }
    }
    return false;
  }
};

TEST_F(PluginUnloading, HundredTimesLeavesNoMapping) {
  for (int i = 0; i < 100; ++i) {
    {
      const auto manager =
          load(relay("a", "to: a") + relay("b", "from: a, to: b") + "  - {name: c, library: plain_c.so}\n");
      manager->step(tick(6));
      ASSERT_TRUE(is_mapped("relay.so"));
      ASSERT_TRUE(is_mapped("plain_c.so"));
    }
    ASSERT_FALSE(is_mapped("relay.so")) << "after " << i + 1 << " times";
    ASSERT_FALSE(is_mapped("plain_c.so")) << "after " << i + 1 << " times";
  }
}

TEST_F(PluginUnloading, FaultsLeaveNoMapping) {
  {
    const auto manager = load("  - {name: thrower, library: throws_in_step.so}\n");
    EXPECT_EQ(manager->step(tick(3)), 1);
  }
  EXPECT_FALSE(is_mapped("throws_in_step.so"));
}

TEST_F(PluginUnloading, RefusedPluginsLeaveNoMapping) {
  for (const char* const library :
       {"throws_in_constructor.so", "throws_in_activate.so", "other_abi.so", "missing_symbol.so"}) {
    EXPECT_NE(refusal(relay("a", "to: a") + "  - {name: b, library: " + library + "}\n"), "");
    EXPECT_FALSE(is_mapped(library)) << library;
    EXPECT_FALSE(is_mapped("relay.so")) << library;
  }
}

}  // namespace
}  // namespace gaitway::core
