// Meshes of robots: search paths, axes, and collision pieces.

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <map>

#include "robot/test/robot_files.h"

namespace smile::robot {
namespace {

namespace fs = std::filesystem;

/// A tetrahedron from 0 to 1 along x, 2 along y, 3 along z.
std::string TetrahedronStl() {
  const std::array<const char*, 4> corners{"0 0 0", "0 2 0", "1 0 0", "0 0 3"};
  const std::array<std::array<std::size_t, 3>, 4> triangles{
      {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
  std::string text = "solid tetrahedron\n";
  for (const auto& triangle : triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (std::size_t corner : triangle) text += std::string("vertex ") + corners[corner] + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid tetrahedron\n";
}

/// The same as a DAE file that specifies its up axis and unit.
std::string TetrahedronDae(const std::string& up_axis, const std::string& unit = "1") {
  return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="u" meter=")" +
         unit + R"("/><up_axis>)" + up_axis + R"(</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="12">0 0 0 0 2 0 1 0 0 0 0 3</float_array>
<technique_common><accessor source="#pa" count="4" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/>
<p>0 1 2 0 2 3 0 3 1 1 3 2</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="n"><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

class RobotMeshes : public RobotFiles {
 protected:
  void Write(const std::string& name, const std::string& bytes) {
    fs::create_directories((folder_ / name).parent_path());
    WriteFile(folder_ / name, bytes);
  }
  /// Returns a robot whose arm is a mesh, for drawing and collision.
  static std::string UrdfWith(const std::string& reference, const std::string& scale = "") {
    const std::string shape =
        "<geometry><mesh filename=\"" + reference + "\"" + scale + "/></geometry>";
    return SmallRobot{.shape = shape + "</collision><visual>" + shape +
                               "</visual><collision><geometry><sphere radius=\"1\"/></geometry>"}
        .Text();
  }
  RobotReading Load(const std::string& urdf, const std::vector<fs::path>& roots = {}) {
    Write("robot/r.urdf", urdf);
    return LoadRobot(folder_ / "robot/r.urdf", {.package_roots = roots});
  }
  std::string LoadComplaint(const std::string& urdf, const std::vector<fs::path>& roots = {}) {
    try {
      Load(urdf, roots);
    } catch (const InputError& error) {
      return std::string(error.what()).substr((folder_ / "robot/").string().size());
    }
    return "";
  }
  /// Returns the bounds of the drawn arm.
  static Eigen::AlignedBox3f BoxOf(const RobotModel& model) {
    Eigen::AlignedBox3f box;
    const auto& drawn = std::get<scene::DrawnMesh>(model.visuals.at(0).shape);
    for (const Eigen::Vector3f& vertex : drawn.mesh->surface.vertices) box.extend(vertex);
    return box;
  }
  static std::vector<std::string> NamesOf(const RobotReading& reading) {
    std::vector<std::string> names;
    for (const RobotFile& file : reading.files) names.push_back(file.name);
    return names;
  }
  /// Reads the robot again from its kept files only.
  RobotReading LoadAgain(const RobotReading& reading) {
    return LoadKeptRobot("kept/" + reading.files.at(0).name, reading.gripper,
                         [&](const std::string& name, std::size_t) -> std::optional<std::string> {
                           for (const RobotFile& file : reading.files) {
                             if (file.name == name) return *file.bytes;
                           }
                           return std::nullopt;
                         });
  }
};

TEST_F(RobotMeshes, AreDrawnWholeAndCollideAsPieces) {
  Write("robot/a.stl", TetrahedronStl());
  const RobotModel model = Load(UrdfWith("a.stl")).model;
  ASSERT_EQ(model.visuals.size(), 1u);
  EXPECT_TRUE(BoxOf(model).isApprox(
      Eigen::AlignedBox3f(Eigen::Vector3f(0, 0, 0), Eigen::Vector3f(1, 2, 3))));
  ASSERT_EQ(model.links[0].solids.size(), 2u) << "the mesh, then the sphere";
  const auto& hull = std::get<scene::Hull>(model.links[0].solids[0].shape);
  EXPECT_EQ(hull.polyhedron().corners.size(), 4u);
  EXPECT_NEAR(scene::MomentsOf(hull).volume, 1, 1e-6);
}

TEST_F(RobotMeshes, LieAsInTheirFileWithAnyUpAxis) {
  for (const char* up : {"X_UP", "Y_UP", "Z_UP"}) {
    Write("robot/a.dae", TetrahedronDae(up));
    const Eigen::AlignedBox3f box = BoxOf(Load(UrdfWith("a.dae")).model);
    EXPECT_LT((box.max() - Eigen::Vector3f(1, 2, 3)).norm(), 1e-5) << up;
    EXPECT_LT(box.min().norm(), 1e-5) << up;
  }
  Write("robot/a.dae", TetrahedronDae("Z_UP", "0.01"));
  const Eigen::AlignedBox3f box = BoxOf(Load(UrdfWith("a.dae")).model);
  EXPECT_LT((box.max() - Eigen::Vector3f(0.01f, 0.02f, 0.03f)).norm(), 1e-6) << "centimetres";
}

TEST_F(RobotMeshes, AreScaledAndMirrored) {
  Write("robot/a.stl", TetrahedronStl());
  const RobotModel model = Load(UrdfWith("a.stl", R"( scale="-2 1 0.5")")).model;
  EXPECT_TRUE(BoxOf(model).isApprox(
      Eigen::AlignedBox3f(Eigen::Vector3f(-2, 0, 0), Eigen::Vector3f(0, 2, 1.5))));
  const auto& surface = std::get<scene::DrawnMesh>(model.visuals[0].shape).mesh->surface;
  double volume = 0;  // negative if the outside were inside
  for (const auto& t : surface.triangles) {
    volume += surface.vertices[t[0]].cross(surface.vertices[t[1]]).dot(surface.vertices[t[2]]) / 6;
  }
  EXPECT_NEAR(volume, 1, 1e-6);
}

TEST_F(RobotMeshes, AreFoundInPackagesBesideAndByTheirFullNames) {
  Write("ws/arm_description/meshes/a.stl", TetrahedronStl());
  Write("robot/meshes/a.stl", TetrahedronStl());
  const std::string package = "package://arm_description/meshes/a.stl";
  const std::map<std::string, std::string> kept{
      {package, "packages/arm_description/meshes/a.stl"},
      {"meshes/../meshes/a.stl", "meshes/a.stl"},
      {"../ws/arm_description/meshes/a.stl", "elsewhere/up/ws/arm_description/meshes/a.stl"},
      {"file://" + (folder_ / "robot/meshes/a.stl").string(),
       "elsewhere" + (folder_ / "robot/meshes/a.stl").string()}};
  for (const auto& [reference, name] : kept) {
    const RobotReading reading = Load(UrdfWith(reference), {folder_ / "ws"});
    EXPECT_EQ(NamesOf(reading), (std::vector<std::string>{"r.urdf", name}));
  }
  // A root may be the package itself.
  Load(UrdfWith(package), {folder_ / "robot", folder_ / "ws/arm_description"});
}

TEST_F(RobotMeshes, AreKeptSoThatTheRobotIsTheSameWithoutTheOriginals) {
  Write("ws/p/a.stl", TetrahedronStl());
  Write("ws/b.gltf", R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": "b.bin"}]})");
  const std::array<float, 9> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
  Write("ws/b.bin", {reinterpret_cast<const char*>(corners.data()), sizeof corners});
  std::string urdf = UrdfWith("package://p/a.stl", R"( scale="1 1 2")");
  urdf.insert(urdf.find("<visual>"),
              R"(<visual><geometry><mesh filename="../ws/b.gltf"/></geometry></visual>)");
  const RobotReading reading = Load(urdf, {folder_ / "ws"});
  EXPECT_EQ(reading.files.size(), 4u) << "the URDF, two meshes, and what one of them names";
  fs::remove_all(folder_ / "ws");
  fs::remove_all(folder_ / "robot");

  const RobotReading again = LoadAgain(reading);
  EXPECT_EQ(NamesOf(again), NamesOf(reading));
  EXPECT_EQ(again.model.links, reading.model.links);
  EXPECT_EQ(BoxOf(again.model).max(), BoxOf(reading.model).max());
}

TEST_F(RobotMeshes, AreFoundWhereTheyAreKept) {
  Write("ws/p/a.stl", TetrahedronStl());
  for (const std::string& reference :
       {std::string("package://p/a.stl"), std::string("../ws/p/a.stl"),
        "file://" + (folder_ / "ws/p/a.stl").string()}) {
    const RobotReading reading = Load(UrdfWith(reference), {folder_ / "ws"});
    for (const RobotFile& file : reading.files) Write("kept/here/" + file.name, *file.bytes);
    const RobotReading again = LoadRobot(folder_ / "kept/here/r.urdf");
    EXPECT_EQ(NamesOf(again), NamesOf(reading));
    fs::remove_all(folder_ / "kept");
  }
}

TEST_F(RobotMeshes, AreReadOnceIfNamedRepeatedly) {
  std::string urdf = UrdfWith("a.stl");
  for (const std::string reference : {"b/../a.stl", "./a.stl"}) {
    urdf.insert(urdf.find("<visual>"),
                "<visual><geometry><mesh filename=\"" + reference + "\"/></geometry></visual>");
  }
  int num_read = 0;
  const auto open = [&](const std::string& name, std::size_t) -> std::optional<std::string> {
    if (name == "r.urdf") return urdf;
    if (name != "a.stl") return std::nullopt;
    ++num_read;
    return TetrahedronStl();
  };
  EXPECT_EQ(LoadKeptRobot("r.urdf", "", open).model.visuals.size(), 3u);
  EXPECT_EQ(num_read, 1);
}

TEST_F(RobotMeshes, OfARobotWhoseNameIsNoTextAreKeptWithoutIt) {
  Write("robot/\xff.urdf", UrdfWith("a.stl"));
  Write("robot/\xff.robot.json", R"({"format": 1})");
  Write("robot/a.stl", TetrahedronStl());
  const RobotReading reading = LoadRobot(folder_ / "robot/\xff.urdf");
  EXPECT_EQ(NamesOf(reading),
            (std::vector<std::string>{"robot.urdf", "robot.robot.json", "a.stl"}));
  EXPECT_TRUE(LoadAgain(reading).has_side_file);
}

TEST_F(RobotMeshes, OutsideTheFoldersAreRefused) {
  Write("secret/a.stl", TetrahedronStl());
  fs::create_directories(folder_ / "robot");
  fs::create_directories(folder_ / "ws/p");
  fs::create_symlink(folder_ / "secret/a.stl", folder_ / "robot/link.stl");
  fs::create_symlink(folder_ / "secret", folder_ / "ws/p/meshes");
  const std::string elsewhere =
      " is outside, expected inside the folder of the robot, in a --path folder or below these";
  const auto complaint = [&](const std::string& reference) {
    return LoadComplaint(UrdfWith(reference), {folder_ / "ws"});
  };
  const auto expected = [](const std::string& reference, const std::string& message) {
    return "r.urdf:4: <link name=\"arm\">: the mesh \"" + reference + "\"" + message;
  };
  for (const std::string reference : {"../secret/a.stl", "link.stl"}) {
    EXPECT_EQ(complaint(reference), expected(reference, elsewhere));
  }
  const std::string full = "file://" + (folder_ / "secret/a.stl").string();
  EXPECT_NE(complaint(full).find(elsewhere), std::string::npos) << complaint(full);
  EXPECT_EQ(
      complaint("package://p/meshes/a.stl"),
      expected("package://p/meshes/a.stl",
               " is outside, expected inside a --path folder that contains the folder \"p\""));
  EXPECT_EQ(complaint("package://q/a.stl"),
            expected("package://q/a.stl",
                     ": expected a file in a --path folder that contains the folder \"q\""));
  EXPECT_EQ(
      complaint("package://p/../../secret/a.stl"),
      expected("package://p/../../secret/a.stl", ": expected package://PACKAGE/PATH without .."));
  EXPECT_EQ(complaint("https://example.org/a.stl"),
            expected("https://example.org/a.stl", ": expected package://, file:// or a path"));
}

TEST_F(RobotMeshes, TheUsualSideFileMayBeALinkThatStaysInside) {
  Write("secret/s.json", R"({"format": 1})");
  Write("robot/s.json", R"({"format": 1})");
  fs::create_symlink("s.json", folder_ / "robot/r.robot.json");
  EXPECT_TRUE(Load(SmallRobot().Text()).has_side_file);
  fs::remove(folder_ / "robot/r.robot.json");
  fs::create_symlink("../secret/s.json", folder_ / "robot/r.robot.json");
  EXPECT_EQ(LoadComplaint(SmallRobot().Text()),
            "r.robot.json: is outside, expected inside the folder of the robot, in a --path folder "
            "or named by --side-file");
  EXPECT_TRUE(LoadRobot(folder_ / "robot/r.urdf", {.side_file = folder_ / "robot/r.robot.json"})
                  .has_side_file);
}

TEST_F(RobotMeshes, ComplaintsNameTheLinkAndTheFile) {
  Write("robot/a.stl", "solid nothing\nendsolid\n");
  Write("robot/a.txt", "");
  EXPECT_EQ(LoadComplaint(UrdfWith("a.stl")),
            "r.urdf:4: <link name=\"arm\">: the mesh \"a.stl\" (" +
                (folder_ / "robot/a.stl").string() +
                "): found no triangles, expected at least one");
  EXPECT_NE(LoadComplaint(UrdfWith("a.txt")).find("found the extension \"txt\""),
            std::string::npos);
  Write("robot/a.stl", TetrahedronStl());
  EXPECT_EQ(LoadComplaint(UrdfWith("a.stl", R"( scale="1 0 1")")),
            "r.urdf:4: <link name=\"arm\">: mesh scale is 0, expected another number");
  EXPECT_EQ(LoadComplaint(UrdfWith("a.stl", R"( scale="100 1 1")")),
            "r.urdf:4: <link name=\"arm\">: the mesh \"a.stl\" reaches 100 m from the origin, "
            "expected less than 100");
}

}  // namespace
}  // namespace smile::robot
