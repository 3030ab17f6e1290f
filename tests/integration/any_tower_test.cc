// python/examples/stack builds a tower with robots of every kind, which `smile robots add` makes
// ready from a URDF alone. docs/robots.md has the figures of 20 layouts each.

#include <array>
#include <vector>

#include "program.h"

namespace smile {
namespace {

struct Builder {
  std::string name, scene;
  bool is_shipped = false;
};

void PrintTo(const Builder& builder, std::ostream* out) { *out << builder.name; }

class AnyRobotBuildsATower : public ProgramTest, public ::testing::WithParamInterface<Builder> {
 protected:
  using Vector = std::array<double, 3>;

  void SetUp() override {
    if (GetParam().is_shipped) return;
    const std::string name = GetParam().name;
    ASSERT_EQ(Smile("robots add " + name + " '" + Shipped("tests/robots/" + name + ".urdf") + "'")
                  .exit_code,
              0);
  }
  static Vector PositionOf(const Json& end, const std::string& object) {
    return end.at("objects").at(object).at("position").get<Vector>();
  }
  /// The blocks stand on one another: each center is well above the block below.
  static void ExpectTower(const Json& end) {
    const Vector bottom = PositionOf(end, "RedBlock");
    const double size = 2 * bottom[2];
    double level = 0;
    for (const std::string block : {"GreenBlock", "BlueBlock"}) {
      const Vector place = PositionOf(end, block);
      level += size;
      EXPECT_NEAR(place[0], bottom[0], size / 4) << block;
      EXPECT_NEAR(place[1], bottom[1], size / 4) << block;
      EXPECT_NEAR(place[2], bottom[2] + level, size / 20) << block;
    }
  }
};

TEST_P(AnyRobotBuildsATower, FromSeededLayouts) {
  const Builder& builder = GetParam();
  for (const std::string seed : {"2", "3"}) {
    ASSERT_EQ(Smile("layout '" + Shipped("scenes/" + builder.scene + ".xml") + "' --robot " +
                    builder.name + " --seed " + seed + " --out " + seed + ".xml")
                  .exit_code,
              0);
    const Answer run = Smile("run " + seed + ".xml --robot " + builder.name + " --brain '" +
                             Shipped("python/examples/stack/stack.py") + "' --record tower" + seed +
                             " --no-pictures --json --timeout 60");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.json()["brain"]["status"], "exited");
    ExpectTower(run.json());
  }
  EXPECT_EQ(Smile("replay tower3 --verify").exit_code, 0);
}

INSTANTIATE_TEST_SUITE_P(Each, AnyRobotBuildsATower,
                         testing::Values(Builder{"tern", "tower_robot", /*is_shipped=*/true},
                                         Builder{"seven", "small_tower"},
                                         Builder{"six", "tower_robot"},
                                         Builder{"five", "small_tower"}),
                         [](const auto& builder) { return builder.param.name; });

}  // namespace
}  // namespace smile
