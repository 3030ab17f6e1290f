#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "base/files.h"
#include "scene_xml/scene_writer.h"
#include "scene_xml/test/scene_text.h"

namespace smile::scene_xml {
namespace {

constexpr const char* kRoot = "<tabletop xmlns='http://synapse.cs.umd.edu/tabletop-xml'>";

std::string Repeated(std::string_view text, int count) {
  std::string repeated;
  for (int i = 0; i < count; ++i) repeated += text;
  return repeated;
}

bool Contains(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

TEST(HostileInput, RefusesWhatIsNotXml) {
  EXPECT_EQ(FaultOf(""), "test.xml:1: found an empty file, expected a <tabletop> element");
  EXPECT_EQ(FaultOf(" \n\n"), "test.xml:1: found an empty file, expected a <tabletop> element");
  EXPECT_EQ(FaultOf("\nhello"),
            "test.xml:2: found something that is not XML, expected a <tabletop> element");
  EXPECT_EQ(FaultOf(std::string_view("<tabletop>\n\0</tabletop>", 23)),
            "test.xml:2: found a NUL byte, expected XML text in UTF-8");
  EXPECT_EQ(FaultOf(std::string_view("\xFF\xFE<\0a\0", 6)),
            "test.xml:1: found a NUL byte, expected XML text in UTF-8");
}

TEST(HostileInput, RefusesBrokenXmlWithTheLineAndTheParsersReason) {
  const std::string fault = FaultOf(std::string(kRoot) + "\n<block>\n</blok></tabletop>");
  EXPECT_TRUE(fault.starts_with("test.xml:3: found an error in the XML (Opening and ending tag"))
      << fault;
  EXPECT_TRUE(fault.ends_with("), expected well-formed XML")) << fault;
  for (const char* broken :
       {"<", "<a", "<a b", "<a b='", "<a/><a/>", "<a>", "<a>&lt", "<a>&no;</a>", "<a b='1' b='2'/>",
        "<x:a/>", "<!--", "<![CDATA[", "<a>\xFF\xFE</a>", "<a>&#0;</a>", "<?xml version='9'?>",
        "</a>", "<?xml?><a/>"}) {
    EXPECT_TRUE(Contains(FaultOf(broken), "expected well-formed XML")) << broken;
  }
}

TEST(HostileInput, RefusesADoctypeAndWithItEveryEntity) {
  EXPECT_EQ(FaultOf("<?xml version='1.0'?>\n<!DOCTYPE tabletop [<!ENTITY a 'aaaa'>"
                    "<!ENTITY b SYSTEM 'file:///etc/passwd'>]><tabletop>&a;&b;</tabletop>"),
            "test.xml:2: found a DOCTYPE, expected none: files must be self-contained");
}

TEST(HostileInput, RefusesOtherEncodings) {
  EXPECT_EQ(FaultOf("<?xml version='1.0' encoding='UTF-7'?><tabletop/>"),
            "test.xml:1: found encoding=\"UTF-7\", expected UTF-8");
}

TEST(HostileInput, BoundsTheDepth) {
  const std::string fault = FaultOf(kRoot + Repeated("<composite location='(0,0,0)'>", 100'000));
  EXPECT_EQ(fault,
            "test.xml:1: <composite>: found more than 256 elements inside one another, expected "
            "fewer");
  const std::string deepest = Repeated("<composite location='(0,0,0)'>", 255);
  MustRead(kRoot + deepest + Repeated("</composite>", 255) + "</tabletop>");
}

TEST(HostileInput, BoundsTheNumberOfElements) {
  EXPECT_EQ(FaultOf(kRoot + Repeated("<a/>", 200'000)),
            "test.xml:1: <a>: found more than 100000 elements, expected fewer");
}

TEST(HostileInput, BoundsTheNumberOfAttributes) {
  std::string tag = "<block";
  for (int i = 0; i < 1'000'000; ++i) tag += " a" + std::to_string(i) + "=''";
  EXPECT_EQ(FaultOf(kRoot + std::string("\n") + tag + "/></tabletop>"),
            "test.xml:2: found a tag with 1000000 attributes, expected at most 256");
}

TEST(HostileInput, BoundsTheNumberOfNamespaces) {
  std::string tag = "<block";
  for (int i = 0; i < 20; ++i) tag += " xmlns:n" + std::to_string(i) + "='urn:x'";
  EXPECT_EQ(FaultOf(kRoot + tag + "/></tabletop>"),
            "test.xml:1: <block>: found 20 xmlns attributes, expected at most 8");
}

TEST(HostileInput, BoundsTheSizeOfAFile) {
  const SceneReaderOptions options{.limits = {.max_file_bytes = 100}};
  EXPECT_EQ(FaultOf(SceneText(std::string(100, ' ')), options).substr(0, 16), "test.xml:1: foun");
}

TEST(HostileInput, DoesNotRefuseAGoodFileForItsSize) {
  const std::string note = "<description name='note' value='" + std::string(1'000, 'x') + "'/>";
  const scene::SceneSpec scene = MustRead(
      SceneText(Repeated("<block location='(1.5,2.25,3)'>" + note + "</block>\n", 20'000)));
  EXPECT_EQ(scene.objects.size(), 20'000u);
}

TEST(HostileInput, BoundsTheNumberOfDiagnostics) {
  const std::vector<std::string> faults = FaultsOf(kRoot + Repeated("<a/>", 5'000) + "</tabletop>");
  EXPECT_EQ(faults.size(), 1'001u);
  EXPECT_EQ(faults.back(), "test.xml:1: found more errors than the 1000 listed, expected none");
}

TEST(HostileInput, ShortensWhatItQuotes) {
  const std::string huge(9'000'000, 'x');
  EXPECT_EQ(FaultOf(kRoot + ("<block location='" + huge) + "'/></tabletop>"),
            "test.xml:1: <block>: found location=\"" + std::string(60, 'x') +
                "…\", expected (x,y,z), three numbers from -1000000 to 1000000");
  EXPECT_LT(FaultOf(kRoot + ("<block id='" + huge) + "' location='(0,0,0)'/></tabletop>").size(),
            300u);
  EXPECT_LT(FaultOf(kRoot + huge + "</tabletop>").size(), 200u);
  EXPECT_LT(FaultOf("<" + huge + "/>").size(), 500u);
  EXPECT_LT(FaultOf("<tabletop xmlns='" + huge + "'/>").size(), 300u);
  EXPECT_LT(
      FaultOf(kRoot + ("<block location='(0,0," + std::string(1'000'000, '1')) + ")'/></tabletop>")
          .size(),
      200u);
}

TEST(HostileInput, RefusesFoldersAndMissingFiles) {
  const auto message = [](const std::filesystem::path& path) {
    return ToString(ReadScene(path).diagnostics.at(0));
  };
  EXPECT_EQ(message("/"), "/:1: is not a regular file");
  EXPECT_EQ(message("no-such.xml"), "no-such.xml:1: no such file");
}

/// Random bytes, cut, doubled and overwritten in a good file: any answer is right but a crash.
void SurviveDamagesOf(const std::string& good) {
  std::mt19937 random(7);
  const auto pick = [&random](std::size_t count) { return random() % count; };
  for (int round = 0; round < 3'000; ++round) {
    std::string text = good;
    for (std::size_t faults = 1 + pick(8); faults > 0; --faults) {
      const std::size_t at = pick(text.size()), size = std::min(1 + pick(40), text.size() - at);
      switch (pick(4)) {
        case 0:
          text[at] = static_cast<char>(random());
          break;
        case 1:
          text.erase(at, size);
          break;
        case 2:
          text.insert(pick(text.size()), text.substr(at, size));
          break;
        case 3:
          text[at] = "<>\"'&=/#(),.-0$ "[pick(16)];
          break;
      }
      if (text.empty()) text = "<";
    }
    const SceneReading reading = ReadSceneText(text, "damaged.xml");
    EXPECT_EQ(reading.scene.has_value(), reading.diagnostics.empty());
    for (const Diagnostic& diagnostic : reading.diagnostics) EXPECT_GE(diagnostic.line, 1);
    if (reading.scene) {
      EXPECT_TRUE(ReadSceneText(WriteScene(*reading.scene), "damaged.xml").scene == reading.scene)
          << "what it still means comes back:\n"
          << text;
    }
  }
}

TEST(HostileInput, SurvivesDamagedFiles) {
  SurviveDamagesOf(ReadFile(DataFile("scenes/shapes.xml"), 1 << 20));
}

TEST(HostileInput, SurvivesDamagedMechanisms) { SurviveDamagesOf(SceneOfEverything()); }

TEST(HostileInput, SurvivesDamagedTemplates) {
  const std::string templates = ReadFile(DataFile("scenes/parts/letters.xml"), 1 << 20);
  const std::string instances = ReadFile(DataFile("scenes/letters.xml"), 1 << 20);
  SurviveDamagesOf(templates.substr(0, templates.find("</tabletop>")) +
                   instances.substr(instances.find("<instance")));
}

}  // namespace
}  // namespace smile::scene_xml
