// Every reader of untrusted input, with the inputs kept for it.

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <iterator>
#include <vector>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/json.h"
#include "brain_input.h"
#include "classic_input.h"
#include "json_input.h"
#include "kept_inputs.h"
#include "mesh_input.h"
#include "model_input.h"
#include "page_input.h"
#include "robot_input.h"
#include "scene_input.h"
#include "trajectory_input.h"
#include "xml_input.h"

namespace smile::fuzz {
namespace {

namespace fs = std::filesystem;

const fs::path kProject = SMILE_SOURCE_DIR;

/// Why a reader refuses an input by throwing `Refusal`; "" when it accepts it.
template <class Refusal, auto read>
std::string ReasonThrownBy(std::string_view input) {
  try {
    (void)read(input);
  } catch (const Refusal& refusal) {
    return refusal.what();
  }
  return "";
}

std::string ReasonAgainstScene(std::string_view input) {
  std::string reason;
  for (const Diagnostic& finding : ReadHostileScene(input).diagnostics) {
    reason += ToString(finding) + "\n";
  }
  return reason;
}

std::string ReasonAgainstXml(std::string_view input) {
  std::string reason;
  for (const Diagnostic& finding : ParseHostileXml(input, xml::Strictness::kTolerant).diagnostics) {
    reason += ToString(finding) + "\n";
  }
  return reason;
}

constexpr auto kReadJson = [](std::string_view text) { return ParseJson(text); };

const HostileReader kReaders[] = {
    {"brain", FaultWithBrainMessage, ReasonAgainstBrainMessage, 12, 14},
    {"classic", FaultWithClassic, ReasonThrownBy<InputError, ReadSegments>, 7, 10},
    {"json", FaultWithJson, ReasonThrownBy<std::invalid_argument, kReadJson>, 5, 14},
    {"mesh", FaultWithMesh, ReasonThrownBy<InputError, ImportHostileMesh>, 16, 27},
    {"model", FaultWithModel, ReasonThrownBy<InputError, ImportHostileModel>, 6, 10},
    {"page", FaultWithPageInput, ReasonAgainstPageInput, 5, 6},
    {"robot", FaultWithRobot, ReasonThrownBy<InputError, ReadHostileRobot>, 7, 18, "robots"},
    {"scene", FaultWithScene, ReasonAgainstScene, 24, 25, "scenes", ".xml"},
    {"trajectory", FaultWithTrajectory, ReasonThrownBy<InputError, ReadTrajectoryText>, 5, 15},
    {"xml", FaultWithXml, ReasonAgainstXml, 4, 12, "scenes", ".xml"},
};

class HostileInput : public ::testing::TestWithParam<HostileReader> {
 protected:
  static void SetUpTestSuite() {
    // An input that asks for all memory fails here, not on the whole machine. Under the address
    // sanitizer, whose shadow is larger than any limit, CMakeLists.txt sets one.
#ifndef SMILE_ADDRESS_SANITIZED
    constexpr rlimit kLimit{2'000'000'000, 2'000'000'000};
    ASSERT_EQ(setrlimit(RLIMIT_AS, &kLimit), 0);
#endif
  }

  static std::string InputIn(const fs::path& file) { return ReadFile(file, 1 << 24); }
  static void ExpectHandledWell(const fs::path& file) {
    EXPECT_EQ(GetParam().fault(InputIn(file)), "") << file;
  }
  fs::path Corpus() const { return kProject / "tests/fuzz/corpus" / GetParam().name; }
};

TEST_P(HostileInput, KeptFilesAreReadOrRefused) {
  for (const fs::path& file : FilesBelow(Corpus())) ExpectHandledWell(file);
  // Inputs that once failed, if there were any.
  const fs::path found = kProject / "tests/fuzz/found" / GetParam().name;
  if (!fs::exists(found) || fs::is_empty(found)) return;
  for (const fs::path& file : FilesBelow(found)) ExpectHandledWell(file);
}

class ShippedInput : public HostileInput {};

TEST_P(ShippedInput, IsReadOrRefused) {
  int num_files = 0;
  for (const fs::path& file : FilesBelow(kProject / GetParam().shipped_folder)) {
    const std::string extension = GetParam().shipped_extension;
    if (!extension.empty() && file.extension() != extension) continue;
    ExpectHandledWell(file);
    ++num_files;
  }
  EXPECT_GT(num_files, 10);
}

TEST_P(HostileInput, GoodFilesAreAccepted) {
  for (const fs::path& file : FilesBelow(Corpus() / "good", GetParam().num_good)) {
    EXPECT_EQ(GetParam().refusal(InputIn(file)), "") << file;
  }
}

TEST_P(HostileInput, BadFilesAreRefused) {
  for (const fs::path& file : FilesBelow(Corpus() / "bad", GetParam().num_bad)) {
    EXPECT_NE(GetParam().refusal(InputIn(file)), "") << file;
  }
}

std::string NameOf(const ::testing::TestParamInfo<HostileReader>& reader) {
  return reader.param.name;
}

std::vector<HostileReader> ReadersOfShippedFiles() {
  std::vector<HostileReader> readers;
  std::ranges::copy_if(kReaders, std::back_inserter(readers), [](const HostileReader& reader) {
    return reader.shipped_folder != nullptr;
  });
  return readers;
}

INSTANTIATE_TEST_SUITE_P(Readers, HostileInput, ::testing::ValuesIn(kReaders), NameOf);
INSTANTIATE_TEST_SUITE_P(Readers, ShippedInput, ::testing::ValuesIn(ReadersOfShippedFiles()),
                         NameOf);

}  // namespace
}  // namespace smile::fuzz
