#include "robot/robot_appearance.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <stdexcept>

#include "robot/test/baxter.h"

namespace smile::robot {
namespace {

using Surface = scene::SurfaceMesh;

const Surface& SurfaceOf(const LinkVisual& visual) {
  return std::get<scene::DrawnMesh>(visual.shape).mesh->surface;
}

/// Expects a triangle on both sides of each edge, facing outwards.
bool IsClosedAndOutwards(const Surface& surface) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  double volume = 0;
  for (const auto& [a, b, c] : surface.triangles) {
    for (const auto& edge : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) ++uses[edge];
    volume += static_cast<double>(
        surface.vertices[a].cross(surface.vertices[b]).dot(surface.vertices[c]));
  }
  for (const auto& [edge, count] : uses) {
    if (count != 1 || !uses.contains({edge.second, edge.first})) return false;
  }
  return volume > 0;
}

TEST(RobotAppearance, IsMadeOfClosedShells) {
  for (const LinkVisual& visual : Baxter().visuals) {
    if (visual.face_expression) continue;  // the display is flat
    EXPECT_TRUE(IsClosedAndOutwards(SurfaceOf(visual))) << "link " << visual.link;
  }
}

TEST(RobotAppearance, IsRichAndYetDrawnQuickly) {
  std::size_t triangles = 0;
  std::set<const scene::CustomMesh*> meshes;
  for (const LinkVisual& visual : Baxter().visuals) {
    if (visual.face_expression && visual.face_expression != FaceExpression::kIdle) continue;
    triangles += SurfaceOf(visual).triangles.size();
    meshes.insert(std::get<scene::DrawnMesh>(visual.shape).mesh.get());
  }
  EXPECT_GT(triangles, 15'000u);
  EXPECT_LT(triangles, 40'000u);
  EXPECT_LT(meshes.size(), 45u) << "both arms share theirs";
}

TEST(RobotAppearance, IsAsLargeAsTheRealRobot) {
  constexpr double kHeight = 1.80, kTolerance = 0.01;  // on its pedestal [m]
  Eigen::Vector3d low = Vector3::Zero(), high = Vector3::Zero();
  for (const LinkVisual& visual : Baxter().visuals) {
    if (visual.link >= 0) continue;
    for (const Eigen::Vector3f& p : SurfaceOf(visual).vertices) {
      const Vector3 p_Base = visual.X_LV * p.cast<double>().eval();
      low = low.cwiseMin(p_Base);
      high = high.cwiseMax(p_Base);
    }
  }
  EXPECT_NEAR(high.z() - low.z(), kHeight, kTolerance);
  EXPECT_NEAR(high.x() - low.x(), 0.91, kTolerance) << "from foot to foot";
  EXPECT_NEAR(high.y() - low.y(), 0.81, kTolerance);
}

TEST(RobotAppearance, FingersLieWithinTheBoxesThatCollide) {
  constexpr double kRound = 1e-6;  // single precision
  for (const Arm& arm : Baxter().arms) {
    for (const int finger : {arm.gripper->left_finger, arm.gripper->right_finger}) {
      const scene::Solid& box = Baxter().links[finger].solids[0];
      const Vector3 half = std::get<scene::Block>(box.shape).size / 2;
      for (const LinkVisual& visual : Baxter().visuals) {
        if (visual.link != finger) continue;
        for (const Eigen::Vector3f& p : SurfaceOf(visual).vertices) {
          const Vector3 from_middle = p.cast<double>() - box.X_BS.translation();
          EXPECT_LE((from_middle.cwiseAbs() - half).maxCoeff(), kRound);
        }
      }
    }
  }
}

TEST(RobotAppearance, HasAFaceForEveryExpression) {
  std::map<FaceExpression, std::set<const scene::CustomMesh*>> faces;
  for (const LinkVisual& visual : Baxter().visuals) {
    if (!visual.face_expression) continue;
    EXPECT_EQ(visual.link, Baxter().head->joints.front());
    faces[*visual.face_expression].insert(std::get<scene::DrawnMesh>(visual.shape).mesh.get());
    // Towards who stands in front, and down.
    for (const auto& [a, b, c] : SurfaceOf(visual).triangles) {
      const auto& v = SurfaceOf(visual).vertices;
      const Eigen::Vector3f normal = (v[b] - v[a]).cross(v[c] - v[a]);
      EXPECT_GE(normal.x(), 0);
      EXPECT_LE(normal.z(), 0);
    }
  }
  EXPECT_EQ(faces.size(), kFaceExpressions.size());
}

TEST(RobotAppearance, IsRefusedToARobotWithoutItsArms) {
  RobotModel model = Baxter();
  std::erase_if(model.frames, [](const Frame& frame) { return frame.name == "right_wrist"; });
  EXPECT_THROW(AddAppearance("baxter", "", &model), std::invalid_argument);
}

TEST(RobotAppearance, OfAGripperIsThatOfItsOwnDescription) {
  const auto shows = [](const RobotModel& model, bool as_mesh) {
    return std::ranges::any_of(model.visuals, [&](const LinkVisual& visual) {
      return visual.link == model.arms[1].gripper->left_finger &&
             std::holds_alternative<scene::DrawnMesh>(visual.shape) == as_mesh;
    });
  };
  const RobotModel electric = ReadRobot(DataFile("robots/baxter.urdf"), {.gripper = "electric"});
  EXPECT_TRUE(shows(Baxter(), true) && !shows(Baxter(), false));
  EXPECT_TRUE(shows(electric, false) && !shows(electric, true));
}

TEST(FaceExpression, NamesReadBack) {
  for (const FaceExpression face_expression : kFaceExpressions)
    EXPECT_EQ(ParseFaceExpression(ToString(face_expression)), face_expression);
  EXPECT_EQ(ParseFaceExpression("Idle"), std::nullopt);
}

}  // namespace
}  // namespace smile::robot
