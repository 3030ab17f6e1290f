#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "base/files.h"
#include "scene_xml/test/scene_text.h"

namespace smile::scene_xml {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExpectedPlace = "the folder of the scene, in a --path folder or below these";

/// A folder of files of its own, gone afterwards.
class Include : public testing::Test {
 protected:
  Include() {
    std::string name = (fs::temp_directory_path() / "smile_include_XXXXXX").string();
    folder_ = mkdtemp(name.data());
  }
  ~Include() override { fs::remove_all(folder_); }

  fs::path File(const std::string& name, const std::string& content,
                const std::string& root_attributes = "") {
    MakeDirectories((folder_ / name).parent_path());
    WriteFile(folder_ / name, SceneText(content, root_attributes));
    return folder_ / name;
  }

  /// The ids of the scene's objects, or its faults without the folder's own name.
  std::vector<std::string> Read(const fs::path& path, std::vector<fs::path> roots = {}) {
    SceneReaderOptions options{.search_roots = std::move(roots)};
    options.limits.max_files = 20;
    options.limits.max_file_bytes = 100'000;
    const SceneReading reading = ReadScene(path, options);
    std::vector<std::string> lines;
    for (const Diagnostic& diagnostic : reading.diagnostics) {
      std::string line = ToString(diagnostic);
      if (const auto at = line.find(folder_.string()); at != std::string::npos) {
        line.erase(at, folder_.string().size() + 1);
      }
      lines.push_back(line);
    }
    if (reading.scene) {
      for (const scene::ObjectSpec& object : reading.scene->objects) lines.push_back(object.id());
    }
    return lines;
  }

  static std::string Block(const std::string& id) {
    return "<block id='" + id + "' location='(0,0,0)'/>\n";
  }
  static std::string IncludeOf(const std::string& file) {
    return "<include file='" + file + "'/>\n";
  }

  fs::path folder_;
};

using Lines = std::vector<std::string>;

TEST_F(Include, PutsTheContentOfAFileInItsPlace) {
  File("parts/b.xml", Block("b") + IncludeOf("c.xml"), " xspan='3'");
  File("parts/c.xml", Block("c"));
  const fs::path main = File("main.xml", Block("a") + IncludeOf("parts/b.xml") + Block("d"));
  EXPECT_EQ(Read(main), (Lines{"a", "b", "c", "d"}));
  EXPECT_EQ(LoadScene(main).table.x_span, 2) << "the table is that of the scene";
}

TEST_F(Include, FindsADefInAnyPlace) {
  File("def.xml", "<def name='one'><block id='$id$' location='(0,0,0)'/></def>");
  EXPECT_EQ(Read(File("main.xml", "<instance def='one'><var name='id' value='x'/></instance>" +
                                      IncludeOf("def.xml"))),
            Lines{"x"});
}

TEST_F(Include, ReadsEachFileOnceUnderAnyName) {
  File("a.xml", Block("a"));
  fs::create_symlink("a.xml", folder_ / "link.xml");
  MakeDirectories(folder_ / "sub");
  EXPECT_EQ(
      Read(File("main.xml", IncludeOf("a.xml") + IncludeOf("./a.xml") + IncludeOf("sub/../a.xml") +
                                IncludeOf("link.xml") + IncludeOf((folder_ / "a.xml").string()))),
      Lines{"a"});
}

TEST_F(Include, StopsAtACycle) {
  File("b.xml", IncludeOf("main.xml") + Block("b") + IncludeOf("b.xml"));
  EXPECT_EQ(Read(File("main.xml", IncludeOf("b.xml") + Block("a"))), (Lines{"b", "a"}));
}

TEST_F(Include, SearchesTheRootsAfterTheFolderOfTheFile) {
  File("root/tablesetup/x.xml", Block("root") + IncludeOf("tablesetup/y.xml"));
  File("root/tablesetup/y.xml", Block("also_root"));
  const fs::path main = File("scenes/main.xml", IncludeOf("tablesetup/x.xml"));
  EXPECT_EQ(Read(main, {folder_ / "nothing", folder_ / "root"}), (Lines{"root", "also_root"}));
  File("scenes/tablesetup/x.xml", Block("near"));
  EXPECT_EQ(Read(main, {folder_ / "root"}), Lines{"near"});
}

TEST_F(Include, SearchesFilesOfATextOnlyInTheRoots) {
  File("x.xml", Block("x"));
  const std::string text = SceneText(IncludeOf("x.xml"));
  const SceneReaderOptions options{.search_roots = {folder_}};
  EXPECT_EQ(ReadSceneText(text, "text.xml", options).scene->objects.size(), 1u);
  EXPECT_EQ(FaultOf(text),
            "test.xml:3: <include>: found file=\"x.xml\", expected a file in a --path folder or "
            "below it");
}

TEST_F(Include, NamesTheFileAndLineOfEveryFault) {
  File("bad.xml", "\n<blok/>" + IncludeOf("worse.xml"));
  WriteFile(folder_ / "worse.xml", "<tabletop>\n");
  const Lines faults = Read(File("main.xml", "<sphere location='(0,0,0)' radius='0'/>\n" +
                                                 IncludeOf("bad.xml") + IncludeOf("none.xml") +
                                                 "<include/>\n<instance def='perhaps_in_none'/>"));
  ASSERT_EQ(faults.size(), 5u) << testing::PrintToString(faults);
  EXPECT_TRUE(faults[0].starts_with("main.xml:3: <sphere>: found radius=\"0\""));
  EXPECT_EQ(faults[1], std::string("main.xml:5: <include>: found file=\"none.xml\", expected a "
                                   "file in ") +
                           kExpectedPlace);
  EXPECT_EQ(faults[2], "main.xml:6: <include>: found no file, expected file=\"…\"");
  EXPECT_TRUE(faults[3].starts_with("bad.xml:4: <blok>: found an unknown element"));
  EXPECT_TRUE(faults[4].starts_with("worse.xml:2: found an error in the XML"));
}

TEST_F(Include, NamesTheInstanceInTheOtherFile) {
  File("def.xml", "<def name='t'>\n<block/></def>");
  EXPECT_EQ(Read(File("main.xml", IncludeOf("def.xml") + "<instance def='t'/>")),
            Lines{"def.xml:4: <block>: found no location, expected location=\"(x,y,z)\" (in the "
                  "instance at " +
                  (folder_ / "main.xml").string() + ":4)"});
}

TEST_F(Include, RefusesAnotherUnit) {
  File("same.xml", Block("a"), " metersPerUnit='0.10'");
  File("other.xml", Block("b"), " metersPerUnit='1'");
  EXPECT_EQ(Read(File("main.xml", IncludeOf("same.xml") + IncludeOf("other.xml"))),
            Lines{"other.xml:2: <tabletop>: found metersPerUnit=\"1\", expected the unit of the "
                  "scene that includes this file, 0.1"});
  EXPECT_EQ(Read(File("main.xml", IncludeOf("other.xml"), " metersPerUnit='1'")), Lines{"b"});
}

TEST_F(Include, StaysInsideTheFoldersItWasGiven) {
  File("outside.xml", Block("outside"));
  fs::create_directories(folder_ / "inside");
  fs::create_symlink(folder_ / "outside.xml", folder_ / "inside/link.xml");
  fs::create_symlink(folder_, folder_ / "inside/way_out");
  for (const std::string& file :
       {std::string("../outside.xml"), std::string("link.xml"), std::string("way_out/outside.xml"),
        (folder_ / "outside.xml").string(), std::string("../../../../../../../../etc/passwd"),
        std::string("/etc/passwd")}) {
    const Lines faults = Read(File("inside/main.xml", IncludeOf(file)));
    ASSERT_EQ(faults.size(), 1u);
    EXPECT_NE(faults[0].find(std::string(" elsewhere, expected it in ") + kExpectedPlace),
              std::string::npos)
        << faults[0];
  }
  EXPECT_EQ(Read(folder_ / "inside/main.xml", {"/no/such/folder"}).size(), 1u);
}

TEST_F(Include, ReadsNeitherFoldersNorDevicesNorEndlessNames) {
  fs::create_directories(folder_ / "sub");
  EXPECT_NE(Read(File("main.xml", IncludeOf("sub")))[0].find("which is not a regular file"),
            std::string::npos);
  EXPECT_EQ(Read(File("main.xml", IncludeOf("/dev/zero"))).size(), 1u);
  EXPECT_EQ(Read(File("main.xml", IncludeOf(""))).size(), 1u);
  EXPECT_EQ(Read(File("main.xml", IncludeOf(std::string(50'000, '/')))).size(), 1u);
  EXPECT_EQ(Read(File("main.xml", IncludeOf("http://example.org/x.xml"))).size(), 1u);
}

TEST_F(Include, BoundsFilesAndBytesAndElementsOfAllTogether) {
  std::string many;
  for (int i = 0; i < 30; ++i) {
    File("f" + std::to_string(i) + ".xml", "");
    many += IncludeOf("f" + std::to_string(i) + ".xml");
  }
  EXPECT_EQ(Read(File("main.xml", many))[0],
            "main.xml:22: <include>: found more than 20 files, expected fewer");

  File("big1.xml", std::string(60'000, ' '));
  File("big2.xml", std::string(60'000, ' '));
  const Lines faults = Read(File("main.xml", IncludeOf("big1.xml") + IncludeOf("big2.xml")));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_TRUE(faults[0].ends_with(
      "expected a scene file that fits the limit of 100000 bytes for all files"))
      << faults[0];

  File("more.xml", Block("a") + Block("b") + Block("c"));
  const SceneReaderOptions options{.limits = {.max_elements = 4}};
  const SceneReading reading =
      ReadScene(File("main.xml", Block("a") + IncludeOf("more.xml")), options);
  ASSERT_EQ(reading.diagnostics.size(), 1u);
  EXPECT_EQ(reading.diagnostics[0].message, "found more than 4 elements, expected fewer");
}

}  // namespace
}  // namespace smile::scene_xml
