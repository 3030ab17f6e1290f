#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "camera/internal_pieces.h"
#include "math/angles.h"

namespace smile::camera::internal {
namespace {

scene::VisualModel ModelOf(const scene::VisualShape& shape) {
  return {.visuals = {{.shape = shape, .frame = 1, .object_id = 1}},
          .object_names = {"", "thing"},
          .num_frames = 2};
}

/// At the origin, looking along +y.
const CameraView kView{CameraIntrinsics::FromVerticalFieldOfView(640, 480, std::numbers::pi / 3),
                       LookAt({0, 0, 0}, {0, 1, 0})};

std::size_t NumVisible(const scene::VisualShape& shape, const Vector3& p_WF) {
  const auto pieces = PlacePieces(ModelOf(shape), {.poses = {{}, RigidTransform(p_WF)}}, {});
  return VisiblePieces(pieces, kView).size();
}

int FacetsOfSphereAt(double distance) {
  const auto pieces = PlacePieces(ModelOf(scene::Sphere{0.05}),
                                  {.poses = {{}, RigidTransform(Vector3(0, distance, 0))}}, {});
  return VisiblePieces(pieces, kView).at(0).unit_mesh.facets;
}

TEST(VisiblePieces, LeaveOutWhatIsBesideBehindOrTooFar) {
  const scene::Block block{{0.1, 0.1, 0.1}};
  EXPECT_EQ(NumVisible(block, {0, 1, 0}), 1u);
  EXPECT_EQ(NumVisible(block, {0, -1, 0}), 0u);
  EXPECT_EQ(NumVisible(block, {0, 11, 0}), 0u);
  EXPECT_EQ(NumVisible(block, {1, 1, 0}), 0u);
  EXPECT_EQ(NumVisible(block, {-1, 1, 0}), 0u);
  EXPECT_EQ(NumVisible(block, {0, 1, 0.75}), 0u);
  EXPECT_EQ(NumVisible(block, {0, 1, -0.75}), 0u);
}

TEST(VisiblePieces, KeepWhatReachesIntoThePicture) {
  EXPECT_EQ(NumVisible(scene::Block{{2, 0.1, 0.1}}, {1, 1, 0}), 1u);
  EXPECT_EQ(NumVisible(scene::Block{{0.1, 4, 0.1}}, {0, -1, 0}), 1u);
}

TEST(VisiblePieces, GiveNearSpheresMoreFacets) {
  EXPECT_EQ(FacetsOfSphereAt(9), 16);
  EXPECT_LT(FacetsOfSphereAt(2), FacetsOfSphereAt(0.2));
}

TEST(VisiblePieces, SurviveNumbersThatAreNone) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_LE(NumVisible(scene::Sphere{0.1}, {nan, nan, nan}), 1u);
}

/// True if a block may show in the picture of kView.
bool MayShowBlock(const Vector3& size, const RigidTransform& X_WF) {
  const auto pieces = PlacePieces(ModelOf(scene::Block{size}), {.poses = {{}, X_WF}}, {});
  const Eigen::AlignedBox3f unit_box(Eigen::Vector3f::Constant(-0.5f),
                                     Eigen::Vector3f::Constant(0.5f));
  return MayShow(unit_box, pieces.at(0).instance, ClipFromWorld(kView));
}

TEST(MayShow, LeavesOutALongBlockBesideThePicture) {
  const Vector3 size(0.1, 4, 0.1);
  const double edge = std::tan(std::numbers::pi / 6) * 640 / 480;  // of the picture, 1 m away
  // Along the line of sight, so that a sphere around it contains all that is near.
  EXPECT_TRUE(MayShowBlock(size, RigidTransform(Vector3(3 * edge, 1, 0))));
  EXPECT_FALSE(MayShowBlock(size, RigidTransform(Vector3(3.1 * edge, 1, 0))));
  EXPECT_FALSE(MayShowBlock(size, RigidTransform(Vector3(-3.1 * edge, 1, 0))));
  EXPECT_FALSE(MayShowBlock(size, RigidTransform(Vector3(0, 1, 2))));
  EXPECT_FALSE(MayShowBlock(size, RigidTransform(Vector3(0, 1, -2))));
  EXPECT_FALSE(MayShowBlock(size, RigidTransform(Vector3(0, -3, 0))));
}

TEST(MayShow, FollowsTheTurnOfABlock) {
  const Vector3 size(4, 0.1, 0.1), p_WF(2, 1, 0);
  EXPECT_TRUE(MayShowBlock(size, RigidTransform(p_WF)));
  EXPECT_FALSE(MayShowBlock(size, RigidTransform(RotationFromFixedAxes({0, 90, 0}), p_WF)));
}

TEST(MayShow, KeepsWhatSurroundsTheCamera) {
  EXPECT_TRUE(MayShowBlock({20, 20, 20}, RigidTransform()));
}

TEST(ClipFromWorld, PutsThePictureCornersIntoTheCornersOfClipSpace) {
  CameraView view = kView;
  view.intrinsics.cx = 100;
  const auto& c = view.intrinsics;
  const auto clip_of = [&](double u, double v, double z) {
    const Vector3 p_CQ((u - c.cx) / c.fx * z, (v - c.cy) / c.fy * z, z);
    const Eigen::Vector4f clip =
        ClipFromWorld(view) * (view.X_WC * p_CQ).cast<float>().homogeneous();
    return Eigen::Vector3f(clip.hnormalized());
  };
  EXPECT_TRUE(clip_of(0, 0, c.far).isApprox(Eigen::Vector3f(-1, -1, 1), 1e-5f));
  EXPECT_TRUE(clip_of(640, 480, c.far).isApprox(Eigen::Vector3f(1, 1, 1), 1e-5f));
  EXPECT_TRUE(clip_of(640, 0, c.near).isApprox(Eigen::Vector3f(1, -1, -1), 1e-4f));
}

}  // namespace
}  // namespace smile::camera::internal
