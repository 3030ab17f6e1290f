#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <filesystem>
#include <random>

#include "base/files.h"
#include "math/angles.h"
#include "scene_xml/scene_writer.h"
#include "scene_xml/test/scene_text.h"

namespace smile::scene_xml {
namespace {

/// Written without its meshes, which are looked for where they were.
scene::SceneSpec WrittenAndRead(const scene::SceneSpec& scene) {
  SceneReading reading = ReadSceneText(WriteScene(scene, {}, MeshNames::kWhereTheyAre),
                                       scene.name + ".xml", {.search_roots = {DataFile("scenes")}});
  for (const Diagnostic& diagnostic : reading.diagnostics) ADD_FAILURE() << ToString(diagnostic);
  return reading.scene.value_or(scene::SceneSpec{});
}

/// Makes scenes of everything the language has, with numbers no file would hold.
class SceneMaker {
 public:
  explicit SceneMaker(unsigned seed) : random_(seed) {}

  scene::SceneSpec Scene() {
    // Made from a text first, so that ids and limits are those of the language.
    constexpr double kUnits[] = {0.1, 1, 0.0254, 1e-9, 3.7};
    scene::SceneSpec scene{.name = "random", .meters_per_unit = kUnits[random_() % 5]};
    unit_ = scene.meters_per_unit;
    scene.table = {Length(), Length(), 4 * unit_};
    for (int i = 0; i < 8; ++i) {
      scene::ObjectSpec object{.whole = Part(3), .mass = Uniform(0, 100)};
      if (random_() % 2) object.center_of_mass = {Length(), -Length(), Length()};
      object.whole.id = "object#" + std::to_string(i);
      if (scene::IsControl(object.whole.shape)) controls_.back() = object.whole.id;
      object.descriptions = {{"shape", "thing & <\"part\">\n"}, {"size", "ü 3\t"}};
      scene.objects.push_back(object);
      switch (random_() % 4) {
        case 0:
          AddChain(i, &scene);
          break;
        case 1:
          AddSlider(i, &scene);
          break;
        default:
          break;
      }
    }
    ConnectMechanisms(&scene);
    AddCameras(&scene);
    AddLooks(&scene);
    return scene;
  }

  double Uniform(double least, double most) {
    return std::uniform_real_distribution<>(least, most)(random_);
  }

  Matrix3 Rotation() {
    switch (random_() % 4) {
      case 0:
        return Matrix3::Identity();
      case 1:
        return FromFile({Uniform(-180, 180), Uniform(-90, 90), Uniform(-180, 180)});
      case 2:
        return FromFile({Uniform(-400, 400), random_() % 2 ? 90.0 : -89.95, 30});
      default:
        return Quaternion(Uniform(-1, 1), Uniform(-1, 1), Uniform(-1, 1), Uniform(-1, 1))
            .normalized()
            .toRotationMatrix();
    }
  }

 private:
  static Matrix3 FromFile(const Vector3& angles_deg) {
    return RotationFromFixedAxes(angles_deg).array() + 0.0;
  }

  /// Over all scales, since it is the spacing of doubles that makes this hard.
  double Length() { return unit_ * std::exp2(Uniform(-7, 9)); }
  Vector3 Size() { return {Length(), Length(), Length()}; }

  int Below(int limit) { return static_cast<int>(random_() % limit); }
  RigidTransform Pose() { return {Rotation(), Vector3(Length(), -Length(), 0)}; }
  Color AnyColor() { return *ParseColor(random_() % 2 ? "pink" : "#12ab9f"); }
  std::string NewId(const std::string& kind) { return kind + "#" + std::to_string(num_ids_++); }

  scene::Part Part(int depth) {
    scene::Part part;
    part.X_PE = Pose();
    part.shape = depth > 0 && Below(4) == 0 ? Control() : Shape(depth);
    if (scene::IsControl(part.shape)) part.id = controls_.emplace_back(NewId("control"));
    const bool has_color = !std::holds_alternative<scene::Composite>(part.shape) &&
                           !std::holds_alternative<scene::IndicatorLights>(part.shape) &&
                           !std::holds_alternative<scene::CustomControl>(part.shape);
    if (has_color) part.color = AnyColor();
    return part;
  }

  /// Its downstreams are chosen when all controls are there.
  scene::Shape Control() {
    const int num_states = 1 + Below(3);
    switch (random_() % 3) {
      case 0:
        return scene::ToggleSwitch{.size = Size(),
                                   .angle = DegreesToRadians(Uniform(0, 90)),
                                   .is_left_pressed = Below(2) == 0,
                                   .num_states = num_states,
                                   .initial_state = Below(num_states)};
      case 1: {
        scene::IndicatorLights lights{.light_radius = Length(),
                                      .light_height = Length(),
                                      .num_lights = 2,
                                      .x_span = Length()};
        for (int i = 0; i < num_states; ++i) lights.states.push_back({"", {{1, AnyColor()}}});
        lights.initial_state = Below(num_states);
        return lights;
      }
      default: {
        scene::CustomControl control{.name = "dial", .initial_state = Below(num_states)};
        for (int i = 0; i < num_states; ++i) {
          scene::Part part = Part(0), group{.X_PE = Pose(), .shape = scene::Composite{{Part(0)}}};
          part.next_state = Below(num_states + 1) - 1;
          control.states.push_back({i == 0 ? "on" : "", {part, group}});
        }
        return control;
      }
    }
  }

  scene::Composite Composite(int depth) {
    scene::Composite composite{{Part(depth - 1), Part(depth - 1)}};
    if (Below(2) == 0) composite.guests.push_back({NewId("guest"), "M-3.a:b", Pose()});
    if (Below(2) == 0) {
      scene::HostPoint host{NewId("host"), "M-3.a:b", Pose()};
      for (int i = 0; i <= Below(3); ++i) host.stages.push_back({Pose(), {}, Below(2) == 0});
      composite.hosts.push_back(host);
      hosts_.push_back(host.id);
    }
    return composite;
  }

  void AddSlider(int number, scene::SceneSpec* scene) {
    scene::SliderSpec slider{.id = Below(2) ? "rail" : "",
                             .X_WJ = Pose(),
                             .X_JA = Pose(),
                             .X_JB = Pose(),
                             .first_object = scene->objects.size()};
    slider.min_offset = -Length();
    slider.max_offset = Length();
    slider.initial_offset = slider.max_offset * Uniform(0, 1);
    slider.do_members_collide = Below(2) == 0;
    slider.damping = Uniform(0, 1);
    slider.restitution = Uniform(0, 1);
    slider.softness = Uniform(0, 1);
    for (const char* member : {"a", "b"}) {
      scene::ObjectSpec object{.whole = Part(2), .mass = Uniform(0.1, 100)};
      object.whole.id = member + std::to_string(number);
      if (scene::IsControl(object.whole.shape)) controls_.back() = object.whole.id;
      object.whole.X_PE = *member == 'a' ? slider.pose_of_first() : slider.pose_of_second();
      object.descriptions = {{"shape", "member"}};
      scene->objects.push_back(object);
    }
    scene->sliders.push_back(slider);
  }

  void AddChain(int number, scene::SceneSpec* scene) {
    scene::ChainSpec chain{.id = "chain#" + std::to_string(number),
                           .color = AnyColor(),
                           .p_WStart = {Length(), -Length(), Length()},
                           .p_WEnd = {-Length(), Length(), 0},
                           .link_padding = Length(),
                           .link_mass = Uniform(0.001, 2),
                           .first_object = scene->objects.size()};
    chain.start_id = chain.id + "-start";
    chain.end_id = chain.id + "-end";
    const int num_links = 1 + Below(30);
    const double length = (chain.p_WEnd - chain.p_WStart).norm() / num_links;
    chain.link_size = {Length(), length * Uniform(1, 1.2), Length()};
    for (int i = 0; i < num_links; ++i) {
      chain.link_ids.push_back(chain.id + "-link" + std::to_string(i));
    }
    for (const scene::ObjectSpec& piece : PiecesOf(chain, unit_)) scene->objects.push_back(piece);
    scene->chains.push_back(chain);
  }

  void AddCameras(scene::SceneSpec* scene) {
    for (int i = 0; i < Below(3); ++i) {
      scene::CameraSpec camera{.id = "camera" + std::to_string(i),
                               .p_WC = {Length(), -Length(), Length()},
                               .p_WQ = {-Length(), Length(), 0},
                               .vertical_field_of_view = DegreesToRadians(Uniform(1, 170))};
      if (Below(2) == 0) camera.up_in_world = {Uniform(-1, 1), Uniform(-1, 1), Uniform(1, 1e5)};
      scene->cameras.push_back(camera);
    }
  }

  void AddLooks(scene::SceneSpec* scene) {
    if (Below(2) == 0) {
      scene->table.pattern = static_cast<scene::TablePattern>(1 + Below(2));
      scene->table.pattern_color = AnyColor();
      scene->table.pattern_span = Length();
    }
    if (Below(2) == 0) scene->table.color = AnyColor();
    if (Below(2) == 0) scene->camera_offsets = {{"eye", Pose(), Uniform(0.5, 2)}, {"b", Pose()}};
    if (Below(2) == 0) scene->lighting = {.brightness = Uniform(0, 4), .color = AnyColor()};
    if (Below(2) == 0) scene->lighting.background = AnyColor();
    if (Below(2) == 0) scene->lighting.turn = DegreesToRadians(37.5);
  }

  /// References to anything there is, before and behind.
  void ConnectMechanisms(scene::SceneSpec* scene) {
    for (scene::ObjectSpec& object : scene->objects) Connect(&object.whole);
  }
  void Connect(scene::Part* part) {
    std::visit(
        [this](auto& shape) {
          if constexpr (requires { shape.downstream; }) {
            for (int i = 0; i < Below(3); ++i) shape.downstream.push_back(AnyOf(controls_));
          }
        },
        part->shape);
    auto* composite = std::get_if<scene::Composite>(&part->shape);
    if (!composite) return;
    for (scene::Part& child : composite->parts) Connect(&child);
    for (scene::HostPoint& host : composite->hosts) {
      host.downstream_lock = AnyOf(hosts_);
      if (!controls_.empty()) host.downstream = host.downstream_override = AnyOf(controls_);
      host.stages[0].downstream_state = 0;
    }
  }
  const std::string& AnyOf(const std::vector<std::string>& ids) {
    return ids[random_() % ids.size()];
  }

  scene::Shape Shape(int depth) {
    switch (random_() % (depth > 0 ? 5 : 4)) {
      case 0:
        return scene::Block{.size = Size()};
      case 1:
        return scene::Cylinder{Length(), Length(), 3 + static_cast<int>(random_() % 60)};
      case 2:
        return scene::Sphere{Length()};
      case 3: {
        const Vector3 size = Size();
        return scene::Box{size, size.minCoeff() * 0.3};
      }
      default:
        return Composite(depth);
    }
  }

  std::mt19937 random_;
  double unit_ = 0.1;
  int num_ids_ = 0;
  std::vector<std::string> controls_, hosts_;
};

TEST(SceneRoundTrip, GivesBackEveryShippedSceneAndItsText) {
  int num_scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(DataFile("scenes"))) {
    if (entry.path().extension() != ".xml") continue;
    ++num_scenes;
    const scene::SceneSpec scene = LoadScene(entry.path());
    const scene::SceneSpec again = WrittenAndRead(scene);
    EXPECT_TRUE(again == scene) << entry.path();
    EXPECT_EQ(WriteScene(again), WriteScene(scene)) << entry.path();
    EXPECT_EQ(WriteScene(scene).find("rotationMatrix"), std::string::npos)
        << entry.path() << ": angles of a file are written as angles";
  }
  EXPECT_GE(num_scenes, 4);
}

TEST(SceneRoundTrip, GivesBackOneOfEverything) {
  scene::SceneSpec scene = MustRead(SceneOfEverything());
  EXPECT_EQ(scene.objects.size(), 2u + 5 + 2 + 2);
  EXPECT_TRUE(WrittenAndRead(scene) == scene);
}

TEST(SceneRoundTrip, GivesBackRandomScenesToTheLastBit) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    const scene::SceneSpec scene = SceneMaker(seed).Scene();
    const scene::SceneSpec again = WrittenAndRead(scene);
    ASSERT_TRUE(again.objects == scene.objects) << "seed " << seed << ", written\n"
                                                << WriteScene(scene) << "and again\n"
                                                << WriteScene(again);
    EXPECT_EQ(again.meters_per_unit, scene.meters_per_unit);
    EXPECT_EQ(again.table.x_span, scene.table.x_span);
    EXPECT_EQ(again.table.y_span, scene.table.y_span);
    EXPECT_TRUE(again.table.color == scene.table.color);
    EXPECT_TRUE(again.table.pattern == scene.table.pattern);
    EXPECT_TRUE(again.table.pattern_color == scene.table.pattern_color);
    EXPECT_EQ(again.table.pattern_span, scene.table.pattern_span);
    EXPECT_TRUE(again.camera_offsets == scene.camera_offsets);
    EXPECT_TRUE(again.lighting == scene.lighting);
    EXPECT_TRUE(again.sliders == scene.sliders);
    EXPECT_TRUE(again.chains == scene.chains);
    EXPECT_TRUE(WrittenAndRead(again) == again);
  }
}

TEST(SceneRoundTrip, KeepsTheBitsOfPosesOutOfASimulation) {
  SceneMaker maker(1);
  scene::SceneSpec scene{.name = "poses"};
  for (int i = 0; i < 2'000; ++i) {
    scene::ObjectSpec object;
    object.whole.id = "b" + std::to_string(i);
    object.whole.X_PE = {maker.Rotation(),
                         Vector3(maker.Uniform(-1, 1), maker.Uniform(0.1, 0.125), i * 1e-17)};
    object.descriptions = {{"shape", "block"}};
    scene.objects.push_back(object);
  }
  const scene::SceneSpec again = WrittenAndRead(scene);
  ASSERT_EQ(again.objects.size(), scene.objects.size());
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const RigidTransform& before = scene.objects[i].pose_in_world();
    const RigidTransform& after = again.objects[i].pose_in_world();
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(std::bit_cast<std::uint64_t>(after.translation()[k]),
                std::bit_cast<std::uint64_t>(before.translation()[k]));
    }
    EXPECT_EQ(after.rotation(), before.rotation());
  }
}

TEST(SceneRoundTrip, LeavesNoNegativeZeros) {
  const scene::SceneSpec scene = MustRead(SceneText(
      "<block location='(-0,0,-0.0)' rotation='(0,180,-0)'/><block location='(0,0,0)'/>"));
  for (const scene::ObjectSpec& object : scene.objects) {
    for (int i = 0; i < 9; ++i) {
      const double number = object.pose_in_world().rotation().data()[i];
      EXPECT_FALSE(number == 0 && std::signbit(number));
    }
    for (double number : object.pose_in_world().translation()) EXPECT_FALSE(std::signbit(number));
  }
}

TEST(SceneRoundTrip, KeepsRenamedIds) {
  const std::string at = " location='(0,0,0)'/>";
  const scene::SceneSpec scene = MustRead(
      SceneText("<block" + at + "<block" + at + "<composite id='a' location='(0,0,0)'>" +
                "<block id='a' pointable='true'" + at + "<block id='a'" + at + "</composite>"));
  EXPECT_EQ(scene.objects[1].id(), "obj#0");
  const scene::SceneSpec again = WrittenAndRead(scene);
  EXPECT_TRUE(again.objects == scene.objects);
}

TEST(SceneWriter, WritesAFileAPersonCanRead) {
  const scene::SceneSpec scene =
      MustRead(SceneText("<composite id='tool' location='(1.9994404,-3,0.50036395)' "
                         "rotation='(-0.04983028,-0.06965088,-15.614626)' mass='2'>"
                         "<description name='category' value='a &amp; b'/>"
                         "<sphere location='(0,0,0.3)' color='brown'/></composite>"
                         "<cylinder location='(0,0,0)' rotation='(90,0,0)'/>"));
  EXPECT_EQ(
      WriteScene(scene),
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<tabletop xmlns=\"http://synapse.cs.umd.edu/tabletop-xml\" xspan=\"20\" yspan=\"12\">\n"
      "  <composite id=\"tool\" location=\"(1.9994404,-3,0.50036395)\" "
      "rotation=\"(-0.04983028,-0.06965088,-15.614626)\" mass=\"2\">\n"
      "    <description name=\"category\" value=\"a &amp; b\"/>\n"
      "    <sphere location=\"(0,0,0.3)\" rotation=\"(0,0,0)\" radius=\"0.5\" "
      "color=\"brown\"/>\n"
      "  </composite>\n"
      "  <cylinder id=\"obj\" location=\"(0,0,0)\" rotation=\"(90,0,0)\" radius=\"0.5\" "
      "yspan=\"1\" sides=\"32\" color=\"gray\" mass=\"1\"/>\n"
      "</tabletop>\n");
}

}  // namespace
}  // namespace smile::scene_xml
