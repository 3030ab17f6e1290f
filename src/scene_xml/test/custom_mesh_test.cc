#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "base/files.h"
#include "mesh/import_mesh.h"
#include "scene_xml/mesh_files.h"
#include "scene_xml/scene_writer.h"
#include "scene_xml/test/scene_text.h"

namespace smile::scene_xml {
namespace {

namespace fs = std::filesystem;

/// A folder with the shipped meshes in `in/meshes`, gone afterwards.
class CustomMesh : public testing::Test {
 protected:
  CustomMesh() {
    std::string name = (fs::temp_directory_path() / "smile_custom_XXXXXX").string();
    folder_ = mkdtemp(name.data());
    MakeDirectories(folder_ / "in");
    fs::copy(DataFile("scenes/meshes"), folder_ / "in/meshes");
  }
  ~CustomMesh() override { fs::remove_all(folder_); }

  fs::path Scene(const std::string& content, const std::string& name = "in/scene.xml") const {
    MakeDirectories((folder_ / name).parent_path());
    WriteFile(folder_ / name, SceneText(content));
    return folder_ / name;
  }
  static std::string Custom(const std::string& file, const std::string& more = "") {
    return "<custom location='(0,0,1)' file='" + file + "' " + more + "/>\n";
  }
  std::string MeshFaultOf(const std::string& content,
                          const SceneReaderOptions& options = {}) const {
    const SceneReading reading = ReadScene(Scene(content), options);
    EXPECT_EQ(reading.diagnostics.size(), 1u);
    if (reading.diagnostics.empty()) return "";
    EXPECT_EQ(reading.diagnostics[0].line, 3);
    std::string message = reading.diagnostics[0].message;
    if (const auto at = message.find(folder_.string()); at != std::string::npos) {
      message.erase(at, folder_.string().size() + 1);
    }
    return message;
  }

  fs::path folder_;
};

TEST_F(CustomMesh, ReadsAFileOnceAndReportsItsName) {
  const scene::SceneSpec scene = LoadScene(Scene(
      Custom("meshes/gem.glb", "scale='2.5' color='red'") + Custom("./meshes/../meshes/gem.glb")));
  const auto& first = std::get<scene::Custom>(scene.objects[0].whole.shape);
  const auto& second = std::get<scene::Custom>(scene.objects[1].whole.shape);
  EXPECT_EQ(first.mesh, second.mesh);
  EXPECT_EQ(first.scale, 0.25);
  EXPECT_EQ(second.scale, 0.1);
  EXPECT_EQ(second.file, "meshes/gem.glb");
  EXPECT_EQ(first.mesh->pieces.size(), 1u);
  EXPECT_EQ(scene.objects[0].descriptions, (std::vector<scene::Description>{{"shape", "gem"}}));
}

TEST_F(CustomMesh, IsSearchedBesideTheFileThatNamesItAndInTheRoots) {
  Scene(Custom("gem.glb"), "in/meshes/part.xml");
  fs::copy(folder_ / "in/meshes/cup.stl", folder_ / "in/cup.stl");
  const fs::path main =
      Scene("<include file='in/meshes/part.xml'/>" + Custom("cup.stl"), "main.xml");
  const SceneReading reading = ReadScene(main, {.search_roots = {folder_ / "in/meshes"}});
  ASSERT_TRUE(reading.scene);
  EXPECT_EQ(std::get<scene::Custom>(reading.scene->objects[0].whole.shape).file,
            "in/meshes/gem.glb");
  // From a root, the scene would find it there again.
  EXPECT_EQ(std::get<scene::Custom>(reading.scene->objects[1].whole.shape).file,
            "in/meshes/cup.stl");
}

TEST_F(CustomMesh, IsNotReadFromElsewhere) {
  fs::copy(folder_ / "in/meshes/cup.stl", folder_ / "cup.stl");
  const std::string elsewhere =
      " elsewhere, expected it in the folder of the scene, in a --path folder or below these";
  EXPECT_EQ(MeshFaultOf(Custom("../cup.stl")), "found file=\"../cup.stl\"" + elsewhere);
  fs::create_symlink("../cup.stl", folder_ / "in/link.stl");
  EXPECT_EQ(MeshFaultOf(Custom("link.stl")), "found file=\"link.stl\"" + elsewhere);
  EXPECT_EQ(MeshFaultOf(Custom("none.stl")),
            "found file=\"none.stl\", expected a file in the folder of the scene, in a --path "
            "folder or below these");
}

TEST_F(CustomMesh, ReportsErrors) {
  WriteFile(folder_ / "in/bad.stl", "solid\nfacet");
  EXPECT_EQ(MeshFaultOf(Custom("bad.stl")),
            "found file=\"bad.stl\" (in/bad.stl): line 2: found the end, expected normal");
  WriteFile(folder_ / "in/flat.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3");
  EXPECT_EQ(MeshFaultOf(Custom("flat.obj")),
            "found file=\"flat.obj\" (in/flat.obj): found all triangles in a plane, expected a "
            "body with a volume");
  SceneReaderOptions few;
  few.limits.max_mesh_triangles = 100;
  EXPECT_EQ(MeshFaultOf(Custom("meshes/cup.stl"), few),
            "found file=\"meshes/cup.stl\" (in/meshes/cup.stl): found more than 100 triangles in "
            "the scene's mesh files, expected fewer");
  SceneReaderOptions small;
  small.limits.max_mesh_bytes = 100;
  EXPECT_EQ(MeshFaultOf(Custom("meshes/cup.stl"), small),
            "found file=\"meshes/cup.stl\" (in/meshes/cup.stl): found more than 100 bytes in the "
            "scene's mesh files, expected fewer");
  EXPECT_EQ(MeshFaultOf("<custom location='(0,0,0)'/>"), "found no file, expected file=\"…\"");
}

TEST_F(CustomMesh, RoundTripsToAnotherFolder) {
  fs::copy(folder_ / "in/meshes/cup.stl", folder_ / "in/cup.v2 (old).stl");
  const scene::SceneSpec scene =
      LoadScene(Scene("<composite location='(0,0,1)'>" + Custom("meshes/cup.stl", "scale='0.3'") +
                      Custom("cup.v2 (old).stl") + "</composite>" + Custom("meshes/cup.stl") +
                      Custom("meshes/wedge.dae") + Custom("meshes/bracket.obj")));
  std::vector<std::string> names;
  for (const MeshFile& file : MeshFilesOf(scene)) {
    names.push_back(file.name);
    MakeDirectories(folder_ / "out/meshes");
    mesh::WriteStl(file.mesh->surface, folder_ / "out/meshes" / file.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"cup.stl", "cup_2.stl", "wedge.stl", "bracket.stl"}));
  WriteFile(folder_ / "out/scene.xml", WriteScene(scene));
  const scene::SceneSpec again = LoadScene(folder_ / "out/scene.xml");
  EXPECT_TRUE(again == scene);
  EXPECT_EQ(WriteScene(again), WriteScene(scene));
  // Kept in its place, the text names the meshes where they are.
  WriteFile(folder_ / "in/expanded.xml", WriteScene(scene, {}, MeshNames::kWhereTheyAre));
  scene::SceneSpec expanded = LoadScene(folder_ / "in/expanded.xml");
  expanded.name = scene.name;
  EXPECT_TRUE(expanded == scene);
}

}  // namespace
}  // namespace smile::scene_xml
