#include "mesh/import_pieces.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "base/diagnostic.h"

namespace smile::mesh {
namespace {

/// A triangle of one color on two nodes; `more` is put into the second one.
std::string TwoNodes(const std::string& more) {
  return R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0,1]}],
"nodes":[{"name":"left","mesh":0},{"name":"right","mesh":0)" +
         more + R"(}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1,"material":0}]}],
"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,0.21404114,0,1]}}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
{"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],
"bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],
"buffers":[{"byteLength":42,"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAAABAAIA"}]})";
}

class ImportPiecesTest : public ::testing::Test {
 protected:
  ImportPiecesTest()
      : path_(std::filesystem::temp_directory_path() /
              ("pieces_" + std::to_string(getpid()) + ".gltf")) {}
  ~ImportPiecesTest() override { std::filesystem::remove(path_); }

  std::vector<MeshPiece> Import(const std::string& text) const {
    std::ofstream(path_) << text;
    return ImportPieces(path_);
  }
  std::string ErrorOf(const std::string& text) const {
    try {
      Import(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

  std::filesystem::path path_;
};

TEST_F(ImportPiecesTest, KeepsNamesColorsAndExtrasAndSharesMeshes) {
  const auto pieces = Import(TwoNodes(R"(,"extras":{"mood":"done"})"));
  ASSERT_EQ(pieces.size(), 2u);
  EXPECT_EQ(pieces[0].node, "left");
  EXPECT_EQ(pieces[1].node, "right");
  EXPECT_EQ(pieces[1].extras.at("mood"), "done");
  EXPECT_TRUE(pieces[0].extras.empty());
  EXPECT_EQ(pieces[0].mesh, pieces[1].mesh);
  EXPECT_NEAR(pieces[0].color.red, 1, 1e-6);
  EXPECT_NEAR(pieces[0].color.green, 0.5, 1e-6) << "as on a screen";
  EXPECT_EQ(pieces[0].mesh->surface.vertices.size(), 3u);
  EXPECT_EQ(pieces[0].mesh->surface.triangles.size(), 1u);
}

TEST_F(ImportPiecesTest, RefusesUnsupportedFiles) {
  EXPECT_NE(ErrorOf(TwoNodes(R"(,"translation":[0,0,1])")).find("\"translation\""),
            std::string::npos);
  std::string text = TwoNodes("");
  text.replace(text.find("\"count\":3"), 9, "\"count\":9");
  EXPECT_NE(ErrorOf(text).find("truncated"), std::string::npos);
  EXPECT_NE(ErrorOf("{}").find("no scene"), std::string::npos);
}

}  // namespace
}  // namespace smile::mesh
