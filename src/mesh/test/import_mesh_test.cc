#include "mesh/import_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "base/diagnostic.h"
#include "mesh/test/mesh_files.h"

namespace smile::mesh {
namespace {

namespace fs = std::filesystem;

const std::string kTetrahedronText =
    "solid test thing\n"
    "facet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 0\nendloop\nendfacet\n"
    "facet normal nan x 0\nOUTER LOOP\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 "
    "1\nendloop\nendfacet\n"
    "facet normal 0 0 0 outer loop vertex 0 0 0 vertex 0 0 +1 vertex 0 1 0 endloop endfacet\n"
    "facet normal 0 0 0 outer loop vertex 1 0 0 vertex 0 1 0 vertex 0 0 1e0 endloop endfacet\n"
    "facet normal 0 0 0 outer loop vertex 1 0 0 vertex 1 0 0 vertex 0 0 1e0 endloop endfacet\n"
    "endsolid test thing\nsolid second\nanything\n";
constexpr const char* kTetrahedronObj =
    "# four\nv 0 0 0\nv 0 1 0\nv 1 0 0\nvn 1 0 0\nv 0 0 1\n"
    "f 1 2 3\nf 1/1 3/2/1 4\nf -4 -1 -3\ng part\nf 3//1 2//1 4//1\n";

std::string FaultOf(std::string_view bytes, std::string_view extension,
                    const MeshLimits& limits = {}) {
  try {
    ParseMesh(bytes, extension, limits, "m");
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().size(), 1u);
    EXPECT_EQ(error.diagnostics()[0].file, "m");
    return error.diagnostics()[0].message;
  }
  return "";
}

std::string ImportFaultOf(const fs::path& path, const MeshLimits& limits = {}) {
  try {
    ImportMesh(path, limits);
  } catch (const InputError& error) {
    EXPECT_EQ(error.diagnostics().at(0).file, path.string());
    return error.diagnostics()[0].message;
  }
  return "";
}

double VolumeOf(const scene::SurfaceMesh& mesh) {
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    volume += mesh.vertices[a].cross(mesh.vertices[b]).dot(mesh.vertices[c]) / 6.0;
  }
  return volume;
}

TEST(ImportMesh, TurnsTheAxesOfTheFileAndNamesVerticesOnceInTheirOrder) {
  const scene::SurfaceMesh mesh = ParseMesh(kTetrahedronText, "STL");
  // The file's (X, Y, Z) is (X, -Z, Y).
  const std::vector<Eigen::Vector3f> expected{{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, -1, 0}};
  EXPECT_EQ(mesh.vertices, expected);
  EXPECT_EQ(mesh.triangles.size(), 4u) << "one has no area, and the second solid is not read";
  EXPECT_EQ(mesh.triangles[1], (scene::SurfaceMesh::Triangle{0, 2, 3}));
  EXPECT_NEAR(VolumeOf(mesh), 1.0 / 6, 1e-7) << "what is outside stays outside";
}

TEST(ImportMesh, ReadsTheSameFromObj) {
  EXPECT_EQ(ParseMesh(kTetrahedronObj, "obj"), ParseMesh(kTetrahedronText, "stl"));
}

TEST(ImportMesh, ReadsEveryShippedFormat) {
  const auto shipped = [](const char* name) {
    return ImportMesh(DataFile("scenes/meshes") / name);
  };
  EXPECT_NEAR(VolumeOf(shipped("bracket.obj")), 0.264, 1e-6);
  EXPECT_NEAR(VolumeOf(shipped("wedge.dae")), 0.36, 1e-6);
  EXPECT_NEAR(VolumeOf(shipped("gem.glb")), 0.8 / 3 * 6 * std::sqrt(3.0) / 4 * 0.16, 1e-6);
  const scene::SurfaceMesh cup = shipped("cup.stl");
  EXPECT_EQ(cup.triangles.size(), 192u);
  for (const Eigen::Vector3f& vertex : cup.vertices) EXPECT_LE(std::abs(vertex.z()), 0.6f);
}

TEST(ImportMesh, ReadsBackWhatItWroteToTheLastBit) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(-3, 3);
  std::string obj;
  for (int i = 0; i < 60; ++i) {
    obj += "v " + std::to_string(place(random)) + " 0 " + std::to_string(place(random)) + "\n";
  }
  for (int i = 0; i < 100; ++i) {
    obj += "f " + std::to_string(1 + random() % 60) + " " + std::to_string(1 + random() % 60) +
           " " + std::to_string(1 + random() % 60) + "\n";
  }
  const scene::SurfaceMesh mesh = ParseMesh(obj, "obj");
  const MeshFolder folder;
  WriteStl(mesh, folder.path() / "a.stl");
  const scene::SurfaceMesh again = ImportMesh(folder.path() / "a.stl");
  EXPECT_TRUE(again == mesh);
  EXPECT_EQ(StlOf(again), StlOf(mesh));
}

TEST(ImportMesh, ReportsErrorsOfAnStl) {
  const std::string good = StlOf(ParseMesh(kTetrahedronText, "stl"));
  EXPECT_EQ(good.size(), 284u);
  EXPECT_EQ(FaultOf(good.substr(0, 283), "stl"),
            "found 283 bytes, expected 284 for the 4 triangles given in its header: it is "
            "truncated or not an STL file");
  EXPECT_EQ(FaultOf(good + "x", "stl"),
            "found 285 bytes, expected 284 for the 4 triangles given in its header");
  EXPECT_EQ(FaultOf("", "stl"),
            "found 0 bytes, expected an STL file: it is truncated or has another format");
  EXPECT_EQ(FaultOf(kTetrahedronText.substr(0, 192), "stl"),
            "line 16: found the end, expected facet or endsolid: it is truncated");
  EXPECT_EQ(FaultOf("solid\nfacet normal 0 0 0 outer loop vertex 1 1 1_", "stl"),
            "line 2: found \"1_\", expected a number");
  EXPECT_EQ(FaultOf("solid a\nendsolid a", "stl"), "found no triangles, expected at least one");
  EXPECT_EQ(FaultOf("solid a\nfacet normal 0 0 0", "stl"), "line 2: found the end, expected outer");
}

TEST(ImportMesh, RefusesNumbersThatAreNoPlaces) {
  const auto obj = [](const std::string& number) {
    return "v 0 0 0\nv 1 0 0\nv 0 1 " + number + "\nf 1 2 3\n";
  };
  EXPECT_EQ(FaultOf(obj("nan"), "obj"), "found the coordinate NaN, expected -1e9 to 1e9");
  EXPECT_EQ(FaultOf(obj("1e30"), "obj"),
            "found the coordinate 1.0000000150474662e+30, expected -1e9 to 1e9");
  EXPECT_EQ(FaultOf(obj("1e300"), "obj"), "found the coordinate Inf, expected -1e9 to 1e9");
  EXPECT_EQ(FaultOf(obj(""), "obj"), "line 3: found the end, expected a number");
  EXPECT_EQ(FaultOf("v 0 0 0\nv 1 1 1\nv 2 1 1\nf 1 2 4\n", "obj"),
            "line 4: found corner \"4\", expected the number of a vertex, 1 to 3");
  EXPECT_EQ(FaultOf("v 0 0 0\nf 1 1 1\n", "obj"),
            "found only triangles without area, expected a surface");
}

TEST(ImportMesh, HasLimits) {
  EXPECT_EQ(FaultOf(kTetrahedronText, "stl", {.max_triangles = 3}),
            "found more than 3 triangles, expected fewer");
  EXPECT_EQ(FaultOf(kTetrahedronText, "stl", {.max_vertices = 3}),
            "found more than 3 vertices, expected fewer");
  EXPECT_EQ(FaultOf(kTetrahedronText, "stl", {.max_file_bytes = 100}), "is larger than 100 bytes");
  const MeshFolder folder;
  const fs::path file = folder.Write("a.stl", kTetrahedronText);
  EXPECT_EQ(ImportFaultOf(file, {.max_file_bytes = 100}), "is larger than 100 bytes");
  EXPECT_EQ(ImportFaultOf(folder.path() / "b.stl"), "no such file");
  EXPECT_EQ(ImportFaultOf(folder.Write("a.exe", "")),
            "found the extension \"exe\", expected stl, obj, dae, gltf or glb");
}

std::string Gltf(const std::string& buffer_uri, const std::string& nodes = R"([{"mesh": 0}])") {
  return R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}], "nodes": )" + nodes + R"(,
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}],
    "buffers": [{"byteLength": 36, "uri": ")" +
         buffer_uri + "\"}]}";
}

std::string ThreePlaces() {
  const float numbers[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  return {reinterpret_cast<const char*>(numbers), sizeof numbers};
}

TEST(ImportMesh, ReadsTheBuffersOfAGltfFromItsOwnFolderOnly) {
  const MeshFolder folder;
  folder.Write("in/places.bin", ThreePlaces());
  folder.Write("secret.bin", ThreePlaces());
  const auto import = [&](const std::string& uri) {
    return ImportFaultOf(folder.Write("in/a.gltf", Gltf(uri)));
  };
  EXPECT_EQ(import("places.bin"), "");
  const std::string expected = ", expected the name of a file beside the mesh";
  EXPECT_EQ(import("../secret.bin"), "found the uri \"../secret.bin\"" + expected);
  EXPECT_EQ(import("/etc/passwd"), "found the uri \"/etc/passwd\"" + expected);
  EXPECT_EQ(import("http://example.org/a"), "found the uri \"http://example.org/a\"" + expected);
  EXPECT_EQ(import("none.bin"), "found the uri \"none.bin\"" + expected);
  fs::create_symlink("../secret.bin", folder.path() / "in/link.bin");
  EXPECT_EQ(import("link.bin"), "found the uri \"link.bin\"" + expected);
  EXPECT_EQ(FaultOf(Gltf("places.bin"), "gltf"),
            "found the uri \"places.bin\", expected all in one file");
  folder.Write("in/places.bin", ThreePlaces().substr(1));
  EXPECT_EQ(import("places.bin"),
            "found accessor 0 that extends beyond its buffer, expected it inside: it is truncated");
}

TEST(ImportMesh, PutsThePartsOfAGltfInTheirPlaces) {
  const std::string data =
      "data:application/octet-stream;base64,"
      "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";
  const scene::SurfaceMesh mesh = ParseMesh(
      Gltf(data,
           R"([{"children": [1], "translation": [0, 2, 0]}, {"mesh": 0, "scale": [3, 1, 1]}])"),
      "gltf");
  EXPECT_EQ(mesh.vertices, (std::vector<Eigen::Vector3f>{{0, 0, 2}, {3, 0, 2}, {0, 0, 3}}));
  EXPECT_EQ(FaultOf(Gltf(data, R"([{"children": [1, 1]}, {"mesh": 0}])"), "gltf"),
            "found node 1 in two places, expected one");
  EXPECT_EQ(FaultOf(Gltf(data, R"([{"children": [0]}])"), "gltf"),
            "found node 0 in two places, expected one");
}

TEST(ImportMesh, BoundsWhatADaeMayCost) {
  EXPECT_EQ(FaultOf("<!DOCTYPE a [<!ENTITY b \"c\">]><a/>", "dae"),
            "line 1: found a DOCTYPE, expected none: files must be self-contained");
  EXPECT_EQ(FaultOf("<a>\n<instance_node url='#a'/></a>", "dae"),
            "line 2: found <instance_node>, expected each node in its place");
  std::string deep;
  for (int i = 0; i < 101; ++i) deep += "<node><!--</node></node>--><b c='/>'/>";
  EXPECT_EQ(FaultOf(deep, "dae"),
            "line 1: <b>: found more than 100 elements inside one another, expected fewer");
  std::string many = "<a>";
  for (int i = 0; i < 200'000; ++i) many += "<b/>";
  EXPECT_EQ(FaultOf(many, "dae"), "line 1: <b>: found more than 200000 elements, expected fewer");
  const std::string cut = FaultOf("<a>\n<b", "dae");
  EXPECT_TRUE(cut.starts_with("line 2: found an error in the XML (")) << cut;
  EXPECT_EQ(FaultOf("<a/>", "dae").substr(0, 21), "is not a readable DAE");
}

TEST(ImportMesh, SurvivesDamage) {
  for (const char* name : {"cup.stl", "bracket.obj", "wedge.dae", "gem.glb"}) {
    const fs::path path = DataFile("scenes/meshes") / name;
    const std::string good = ReadFile(path, 1 << 20);
    std::mt19937 random(3);
    for (int round = 0; round < 150; ++round) {
      std::string bytes = good;
      for (unsigned k = 0; k < 1 + random() % 4; ++k) {
        bytes[random() % bytes.size()] =
            static_cast<char>(random() % 3 ? '0' + random() % 10 : random() % 256);
      }
      if (random() % 4 == 0) bytes.resize(random() % bytes.size());
      try {
        ParseMesh(bytes, path.extension().string().substr(1));
      } catch (const InputError& error) {
        EXPECT_FALSE(error.diagnostics().at(0).message.empty());
      }
    }
  }
}

}  // namespace
}  // namespace smile::mesh
