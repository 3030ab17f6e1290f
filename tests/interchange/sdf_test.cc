// What libsdformat, the reader of Gazebo, finds in scenes exported as SDFormat.

#include "interchange/sdf.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <sdf/sdf.hh>

#include "base/files.h"
#include "robot/urdf_reader.h"
#include "scene_xml/scene_reader.h"

namespace smile::interchange {
namespace {

constexpr double kTolerance = 1e-12;  // [m and kg m2]

/// A world, what was written, and what libsdformat reads.
struct Exchange {
  ExportedWorld world;
  ExportedText exported;
  sdf::Root root;

  const sdf::World& sdf_world() const { return *root.WorldByIndex(0); }
  /// Returns all links by their names.
  std::map<std::string, const sdf::Link*> links() const {
    std::map<std::string, const sdf::Link*> links;
    for (std::uint64_t m = 0; m < sdf_world().ModelCount(); ++m) {
      const sdf::Model& model = *sdf_world().ModelByIndex(m);
      for (std::uint64_t l = 0; l < model.LinkCount(); ++l) {
        const sdf::Link& link = *model.LinkByIndex(l);
        links[link.Name()] = &link;
      }
    }
    return links;
  }
};

Exchange ExchangeOf(scene::SceneSpec scene, bool has_robot, int num_ticks = 0) {
  std::optional<model::RobotPlacement> robot;
  if (has_robot) {
    robot = model::RobotPlacement{.model = robot::LoadRobot(DataFile("robots/baxter.urdf")).model};
  }
  sim::RunningModel running(
      std::make_shared<const model::Model>(std::move(scene), std::move(robot)));
  for (int tick = 0; tick < num_ticks; ++tick) running.Tick();
  Exchange exchange{.world = WorldOf(running)};
  exchange.exported = ToSdf(exchange.world, "meshes");
  for (const sdf::Error& error : exchange.root.LoadSdfString(exchange.exported.text)) {
    ADD_FAILURE() << error;
  }
  EXPECT_EQ(exchange.root.WorldCount(), 1u);
  return exchange;
}

Exchange ExchangeOfText(const std::string& objects) {
  const std::string text =
      R"(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">)" + objects + "</tabletop>";
  const scene_xml::SceneReading reading = scene_xml::ReadSceneText(text, "scene.xml");
  for (const Diagnostic& diagnostic : reading.diagnostics) ADD_FAILURE() << ToString(diagnostic);
  return ExchangeOf(*reading.scene, /*has_robot=*/false);
}

void ExpectPose(const ignition::math::Pose3d& found, const RigidTransform& expected,
                const std::string& name) {
  const Vector3 p(found.Pos().X(), found.Pos().Y(), found.Pos().Z());
  EXPECT_LT((p - expected.translation()).norm(), kTolerance) << name;
  const Quaternion q(found.Rot().W(), found.Rot().X(), found.Rot().Y(), found.Rot().Z());
  EXPECT_LT((q.toRotationMatrix() - expected.rotation()).norm(), kTolerance) << name;
}

void ExpectInertia(const sdf::Link& link, const scene::MassProperties& mass) {
  const ignition::math::Inertiald& found = link.Inertial();
  EXPECT_DOUBLE_EQ(found.MassMatrix().Mass(), mass.mass) << link.Name();
  ExpectPose(found.Pose(), RigidTransform(mass.center), link.Name());
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      EXPECT_NEAR(found.Moi()(static_cast<std::size_t>(row), static_cast<std::size_t>(column)),
                  mass.inertia(row, column), kTolerance)
          << link.Name();
    }
  }
}

TEST(Sdf, LibsdformatFindsTheBodiesOfAllShippedScenes) {
  int num_scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(SMILE_SOURCE_DIR "/scenes")) {
    if (entry.path().extension() != ".xml") continue;
    SCOPED_TRACE(entry.path());
    ++num_scenes;
    const Exchange exchange =
        ExchangeOf(scene_xml::LoadScene(entry.path()), /*has_robot=*/false, /*num_ticks=*/30);
    const auto links = exchange.links();
    for (const ExportedBody& body : exchange.world.bodies) {
      ASSERT_TRUE(links.contains(body.name)) << body.name;
      const sdf::Link& link = *links.at(body.name);
      ExpectPose(link.RawPose(), body.spec.X_WB, body.name);
      if (!body.is_static()) ExpectInertia(link, body.spec.mass);
      EXPECT_EQ(link.CollisionCount(), body.spec.solids.size()) << body.name;
      EXPECT_EQ(link.VisualCount(), body.visuals.size()) << body.name;
    }
    EXPECT_EQ(links.size(), exchange.world.bodies.size() + 1) << "and that of the cameras";
    EXPECT_EQ(exchange.sdf_world().Gravity().Z(), -exchange.world.gravity);
  }
  EXPECT_GT(num_scenes, 30);
}

TEST(Sdf, ADrawerHasItsRailAndLimits) {
  const Exchange exchange = ExchangeOfText(R"xml(
      <sliderJoint location="(0,0,1.1)" rotation="(0,0,90)" min="0.5" max="3" init="1">
        <block id="Chest" location="(0,0,0)" mass="0" xspan="2" yspan="2" zspan="2"/>
        <block id="Drawer" location="(0,0,1.5)" mass="0.5" restitution="0.25" friction="0.5"/>
      </sliderJoint>)xml");
  const sdf::Model* model = exchange.sdf_world().ModelByName("Chest");
  ASSERT_NE(model, nullptr);
  EXPECT_FALSE(model->Static());
  ASSERT_EQ(model->JointCount(), 2u);
  const sdf::Joint* fixed = model->JointByName("Chest_on_world");
  ASSERT_NE(fixed, nullptr);
  EXPECT_EQ(fixed->Type(), sdf::JointType::FIXED);
  EXPECT_EQ(fixed->ParentLinkName(), "world");
  const sdf::Joint* rail = model->JointByName("Chest_Drawer");
  ASSERT_NE(rail, nullptr);
  EXPECT_EQ(rail->Type(), sdf::JointType::PRISMATIC);
  EXPECT_EQ(rail->ParentLinkName(), "Chest");
  ignition::math::Vector3d axis;
  EXPECT_TRUE(rail->Axis()->ResolveXyz(axis, "__model__").empty());
  EXPECT_LT(std::abs(axis.X()) + std::abs(axis.Z()) + std::abs(std::abs(axis.Y()) - 1), 1e-12);
  // It is at y = -10 cm, and moves between -30 and -5 cm.
  const double one_end = -0.1 + rail->Axis()->Lower() * axis.Y();
  const double other_end = -0.1 + rail->Axis()->Upper() * axis.Y();
  EXPECT_NEAR(std::min(one_end, other_end), -0.3, kTolerance);
  EXPECT_NEAR(std::max(one_end, other_end), -0.05, kTolerance);
  const sdf::ElementPtr surface =
      model->LinkByName("Drawer")->CollisionByIndex(0)->Element()->GetElement("surface");
  const sdf::ElementPtr friction = surface->GetElement("friction")->GetElement("ode");
  EXPECT_DOUBLE_EQ(friction->Get<double>("mu"), 0.25) << "the square";
  EXPECT_DOUBLE_EQ(friction->Get<double>("mu2"), 0.25);
  EXPECT_DOUBLE_EQ(surface->GetElement("bounce")->Get<double>("restitution_coefficient"), 0.25);
}

TEST(Sdf, AStringHangsByBallJointsFromBothEnds) {
  const Exchange exchange =
      ExchangeOf(scene_xml::LoadScene(DataFile("scenes/scissors.xml")), false, 240);
  std::uint64_t num_balls = 0;
  for (std::uint64_t m = 0; m < exchange.sdf_world().ModelCount(); ++m) {
    const sdf::Model& model = *exchange.sdf_world().ModelByIndex(m);
    for (std::uint64_t j = 0; j < model.JointCount(); ++j) {
      const sdf::Joint& joint = *model.JointByIndex(j);
      if (joint.Type() == sdf::JointType::BALL) ++num_balls;
      if (joint.Type() != sdf::JointType::BALL) continue;
      EXPECT_NE(model.LinkByName(joint.ParentLinkName()), nullptr) << joint.Name();
    }
  }
  EXPECT_EQ(num_balls, 12u);
}

TEST(Sdf, TheRobotStandsAsItDoes) {
  const Exchange exchange = ExchangeOf(scene_xml::LoadScene(DataFile("scenes/tower.xml")), true);
  const ExportedRobot& robot = *exchange.world.robot;
  const sdf::Model* model = exchange.sdf_world().ModelByName("robot");
  ASSERT_NE(model, nullptr);
  const std::vector<RigidTransform> X_WL =
      scene::LinkPoses(robot.spec->links, robot.spec->X_WBase, robot.q);
  ASSERT_EQ(model->LinkCount(), X_WL.size() + 1);
  ASSERT_EQ(model->JointCount(), X_WL.size() + 1);
  for (std::size_t i = 0; i < X_WL.size(); ++i) {
    const scene::LinkSpec& link = robot.spec->links[i];
    ExpectPose(model->LinkByName(robot.links[i].name)->RawPose(), X_WL[i], link.name);
    ExpectInertia(*model->LinkByName(robot.links[i].name),
                  {.mass = link.mass, .center = link.p_LLcm, .inertia = link.inertia});
    const sdf::Joint& joint = *model->JointByIndex(i + 1);
    EXPECT_EQ(joint.ChildLinkName(), robot.links[i].name);
    EXPECT_NEAR(joint.Axis()->Lower(), link.lower - robot.q[i], kTolerance);
    EXPECT_NEAR(joint.Axis()->Upper(), link.upper - robot.q[i], kTolerance);
    EXPECT_DOUBLE_EQ(joint.Axis()->Effort(), link.max_effort);
    EXPECT_DOUBLE_EQ(joint.Axis()->MaxVelocity(), link.max_velocity);
  }
}

TEST(Sdf, CamerasLookAlongTheirXAxes) {
  const Exchange exchange = ExchangeOf(scene_xml::LoadScene(DataFile("scenes/tower.xml")), false);
  const ExportedCamera& eye = exchange.world.cameras.front();
  ASSERT_EQ(eye.name, "eye");
  const sdf::Link* link = exchange.sdf_world().ModelByName("cameras")->LinkByIndex(0);
  const sdf::Sensor* sensor = link->SensorByName("eye");
  ASSERT_NE(sensor, nullptr);
  const auto forward = sensor->RawPose().Rot().RotateVector(ignition::math::Vector3d::UnitX);
  const auto up = sensor->RawPose().Rot().RotateVector(ignition::math::Vector3d::UnitZ);
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(forward[static_cast<std::size_t>(i)], eye.X_FC.rotation()(i, 2), kTolerance);
    EXPECT_NEAR(up[static_cast<std::size_t>(i)], -eye.X_FC.rotation()(i, 1), kTolerance);
  }
  const double angle = sensor->CameraSensor()->HorizontalFov().Radian();
  EXPECT_NEAR(std::tan(angle / 2), std::tan(M_PI / 6) * 4 / 3, kTolerance);
}

TEST(Sdf, NamesThatTheFormatDoesNotAllowAreReported) {
  Exchange exchange = ExchangeOfText(
      R"xml(<block id="world" location="(0,0,0.5)"/> <block id="__m__" location="(2,0,0.5)"/>)xml");
  // Scene files do not allow these, but descriptions of robots do.
  exchange.world.bodies[0].name = "a::b";
  exchange.world.bodies[1].name = "</link>\"-->";
  exchange.exported = ToSdf(exchange.world, "</uri>");
  exchange.root = sdf::Root();
  for (const sdf::Error& error : exchange.root.LoadSdfString(exchange.exported.text)) {
    ADD_FAILURE() << error;
  }
  const auto links = exchange.links();
  for (const char* name : {"a__b", "world_2", "a__m__", "</link>\"-->"}) {
    EXPECT_TRUE(links.contains(name)) << name;
  }
  const std::vector<std::string>& list = exchange.exported.left_out;
  EXPECT_EQ(std::ranges::count(list, "\"a::b\": is called \"a__b\""), 1);
  EXPECT_EQ(std::ranges::count(list, "\"world\": is called \"world_2\""), 1);
}

TEST(Sdf, MeshesAreFilesThatItRefersTo) {
  const Exchange exchange =
      ExchangeOfText(R"xml(<frustum id="Cone" location="(0,0,0.5)" sides="3" radiusTop="0"/>)xml");
  const sdf::Link& link = *exchange.links().at("Cone");
  const sdf::Mesh* mesh = link.CollisionByIndex(0)->Geom()->MeshShape();
  ASSERT_NE(mesh, nullptr);
  ASSERT_EQ(exchange.exported.files.size(), 1u);
  EXPECT_EQ(mesh->Uri(), exchange.exported.files[0].first);
  // A tetrahedron: 4 triangles of 50 bytes, whose first corner is one of its hull.
  const std::string& stl = exchange.exported.files[0].second;
  ASSERT_EQ(stl.size(), 84u + 4 * 50);
  std::array<float, 6> first{};
  std::memcpy(first.data(), stl.data() + 84, sizeof first);
  EXPECT_NEAR(std::hypot(first[0], first[1], first[2]), 1, 1e-6) << "the normal";
  const auto& solid = exchange.world.bodies.back().spec.solids.front();
  const auto& corners = std::get<scene::Hull>(solid.shape).polyhedron().corners;
  EXPECT_TRUE(std::ranges::any_of(corners, [&](const Vector3& corner) {
    return (corner - Vector3(first[3], first[4], first[5])).norm() < 1e-7;
  }));
}

TEST(Sdf, IsWrittenToTheSameBytes) {
  const scene::SceneSpec scene = scene_xml::LoadScene(DataFile("scenes/tower.xml"));
  const Exchange first = ExchangeOf(scene, true), second = ExchangeOf(scene, true);
  EXPECT_EQ(first.exported.text, second.exported.text);
  EXPECT_EQ(first.exported.files, second.exported.files);
}

}  // namespace
}  // namespace smile::interchange
