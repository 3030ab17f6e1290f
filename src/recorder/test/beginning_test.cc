// Recordings whose program is killed before they can be opened.

#include <sys/wait.h>

#include "base/diagnostic.h"
#include "painted_eye.h"
#include "recording/beginning.h"
#include "recording/recording_names.h"
#include "recording_fixture.h"

namespace smile::recorder {
namespace {

/// Ends its process while the first picture is taken.
class DeadlyEye : public PaintedEye {
 public:
  const Image& Draw(const scene::VisualModel&, const sim::ViewSample&) override {
    kill(getpid(), SIGKILL);
    std::abort();
  }
};

class BeginningTest : public RecordingFixture {
 protected:
  /// Leaves in `demo` what a program had written that was killed.
  void Abandon() const {
    const auto simulation = MakeSimulation(true);
    const pid_t child = fork();
    if (child == 0) {
      DeadlyEye eye;
      const Recorder recorder(demo_, {}, &eye, *simulation);
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    ASSERT_FALSE(std::filesystem::is_empty(demo_));
  }

  std::filesystem::path demo_ = root_ / "demo";
};

TEST_F(BeginningTest, AnAbandonedOneIsNamedAndMayBeBegunAgain) {
  Abandon();
  EXPECT_FALSE(recording::IsRecording(demo_));
  try {
    recording::OpenRecording(demo_);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              demo_.string() +
                  ": contains no recording: the program was killed before the recording began; a "
                  "new recording can replace it");
  }
  EXPECT_EQ(recording::NewDirectory(root_, "demo"), demo_);
  EXPECT_EQ(Record(), demo_);
  EXPECT_EQ(recording::OpenRecording(demo_).commands.size(), 5u);
  EXPECT_FALSE(std::filesystem::exists(demo_ / recording::kRobotFolder)) << "left by the first";
  EXPECT_EQ(recording::NewDirectory(root_, "demo"), root_ / "demo-2");
  for (const auto& entry : std::filesystem::directory_iterator(demo_)) {
    EXPECT_NE(entry.path().filename().string().front(), '.') << entry.path();
  }
}

TEST_F(BeginningTest, ARecordingInProgressIsNotReplaced) {
  const recording::BeginningMark mark(demo_);
  EXPECT_FALSE(recording::IsAbandoned(demo_));
  EXPECT_THROW(Record(), InputError);
  EXPECT_EQ(recording::NewDirectory(root_, "demo"), root_ / "demo-2");
}

TEST_F(BeginningTest, OtherFilesAreNeverReplaced) {
  std::filesystem::create_directories(demo_);
  WriteFile(demo_ / "notes.txt", "mine");
  EXPECT_THROW(Record(), InputError);
  EXPECT_EQ(ReadFile(demo_ / "notes.txt", 100), "mine");
}

}  // namespace
}  // namespace smile::recorder
