#include <gtest/gtest.h>

#include "math/angles.h"
#include "scene/scene_spec.h"

namespace smile::scene {
namespace {

ChainSpec ChainOf(int num_links, const Vector3& p_WStart, const Vector3& p_WEnd) {
  ChainSpec chain{.id = "c", .start_id = "c-start", .end_id = "c-end"};
  for (int i = 0; i < num_links; ++i) chain.link_ids.push_back("c-link" + std::to_string(i));
  chain.color = {1, 0, 0};
  chain.p_WStart = p_WStart;
  chain.p_WEnd = p_WEnd;
  return chain;
}

TEST(ChainPieces, StandWhereTheOriginalHasThem) {
  const std::vector<ObjectSpec> pieces = PiecesOf(ChainOf(20, {1, 0, 0.5}, {-1, -0.1, 0.4}), 0.1);
  ASSERT_EQ(pieces.size(), 22u);
  const ObjectSpec& link = pieces[2];
  EXPECT_EQ(link.id(), "c-link0");
  // Measured: (9.5, -0.025, 4.975) units, turned by (-2.859, 0, 92.862) degrees.
  EXPECT_LT((link.pose_in_world().translation() - Vector3(0.95, -0.0025, 0.4975)).norm(), 1e-12);
  const Vector3 angles_deg = FixedAxesAngles(link.pose_in_world().rotation());
  EXPECT_LT((angles_deg - Vector3(-2.859, 0, 92.862)).norm(), 1e-3);
}

TEST(ChainPieces, AreTwoFixedCubesAndThenTheLinks) {
  const std::vector<ObjectSpec> pieces = PiecesOf(ChainOf(2, {0, 0, 1}, {0, 0.2, 1}), 0.1);
  ASSERT_EQ(pieces.size(), 4u);
  for (int i : {0, 1}) {
    EXPECT_TRUE(pieces[i].is_static());
    EXPECT_EQ(std::get<Block>(pieces[i].whole.shape), (Block{{0.01, 0.01, 0.01}}));
    EXPECT_EQ(pieces[i].whole.color, (Color{1, 1, 1}));
    EXPECT_EQ(
        pieces[i].descriptions,
        (std::vector<Description>{
            {"shape", "chain-endpoint"}, {"xspan", "0.1"}, {"yspan", "0.1"}, {"zspan", "0.1"}}));
  }
  EXPECT_EQ(pieces[1].pose_in_world().translation(), Vector3(0, 0.2, 1));
  EXPECT_EQ(pieces[3].pose_in_world(), RigidTransform(Vector3(0, 0.15000000000000002, 1)));
  EXPECT_EQ(pieces[3].mass, 1);
  EXPECT_EQ(pieces[3].descriptions, (std::vector<Description>{{"shape", "chain-link"},
                                                              {"xspan", "0.1"},
                                                              {"yspan", "1"},
                                                              {"zspan", "0.1"},
                                                              {"color", "red"}}));
}

TEST(ChainPieces, HaveARotationInAnyDirectionOfTheChain) {
  for (const Vector3& direction : {Vector3(0, 0, 1), Vector3(0, 0, -1), Vector3(1, 0, 0),
                                   Vector3(1e-12, 0, 1), Vector3(-0.3, 0.2, -2)}) {
    const Matrix3 R = PiecesOf(ChainOf(1, {0, 0, 0}, direction), 0.1)[2].pose_in_world().rotation();
    EXPECT_LT((R * R.transpose() - Matrix3::Identity()).norm(), 1e-12);
    EXPECT_GT(R.determinant(), 0.999);
    EXPECT_LT((R.col(1) - direction.normalized()).norm(), 1e-12);
    EXPECT_LT(std::abs(R(2, 0)), 2e-12) << "x is level";
    EXPECT_GE(R(2, 2), -1e-12) << "z is not turned down";
  }
}

}  // namespace
}  // namespace smile::scene
