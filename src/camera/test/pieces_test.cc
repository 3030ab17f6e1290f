#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "camera/internal_pieces.h"

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
