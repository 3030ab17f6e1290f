#pragma once

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "base/files.h"
#include "brain/brain_process.h"
#include "classic_arms.h"

namespace smile::brain {

namespace fs = std::filesystem;

inline double SecondsOf(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

inline std::size_t CountIn(const fs::path& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// A place of its own for each test; everything a brain may leave behind lies in it and is counted.
class BrainProcessTest : public testing::Test {
 protected:
  void SetUp() override {
    std::string name = (fs::temp_directory_path() / "brain-test-XXXXXX").string();
    ASSERT_NE(::mkdtemp(name.data()), nullptr);
    root_ = name;
    fs::create_directory(root_ / "tmp");
    ::setenv("TMPDIR", (root_ / "tmp").c_str(), 1);
    fds_before_ = CountIn("/proc/self/fd");
    threads_before_ = CountIn("/proc/self/task");
  }

  void TearDown() override {
    EXPECT_EQ(CountIn(root_ / "tmp"), 0u) << "a temporary folder was left behind";
    EXPECT_EQ(CountIn("/proc/self/fd"), fds_before_) << "a file descriptor was left open";
    EXPECT_EQ(CountIn("/proc/self/task"), threads_before_) << "a thread was left running";
    ::unsetenv("TMPDIR");
    fs::remove_all(root_);
  }

  /// A brain of two scripts in the folder `agent`.
  fs::path Brain(const std::string& init, const std::string& callback) {
    const fs::path folder = root_ / "brain";
    MakeDirectories(folder);
    WriteFile(folder / "agentBehavior.m",
              "function [a, b] = agentBehavior()\na = @begin;\nb = @act;\nend\n");
    WriteFile(folder / "begin.m", init);
    WriteFile(folder / "act.m", callback);
    return folder;
  }

  /// A file with this in it, executable when it begins with `#!`.
  fs::path Program(const std::string& name, const std::string& text) {
    const fs::path file = root_ / "brain" / name;
    MakeDirectories(file.parent_path());
    WriteFile(file, text);
    if (text.starts_with("#!")) fs::permissions(file, fs::perms::owner_all);
    return file;
  }

  /// A shell script that speaks over pipes: what it sends lies in the file `frames`.
  fs::path Talker(const std::string& script, std::span<const std::byte> frames) {
    const fs::path file = root_ / "talker";
    WriteFile(root_ / "frames", {reinterpret_cast<const char*>(frames.data()), frames.size()});
    WriteFile(file,
              "#!/bin/sh\nexec 3<\"$SMILE_BRAIN_ADDRESS/to_brain\" "
              "4>\"$SMILE_BRAIN_ADDRESS/from_brain\"\n" +
                  script + "\n");
    fs::permissions(file, fs::perms::owner_all);
    return file;
  }

  fs::path root_;

 private:
  std::size_t fds_before_ = 0;
  std::size_t threads_before_ = 0;
};

template <class Reply>
inline std::string ErrorIn(const OrError<Reply>& reply) {
  const auto* error = std::get_if<BrainError>(&reply);
  return error ? ToString(*error) : "no error";
}

inline InitReply Started(BrainProcess& brain, const Aux& aux = {}) {
  auto reply = brain.Init(Classic(aux));
  EXPECT_EQ(ErrorIn(reply), "no error");
  return testing::Test::HasFailure() ? InitReply{} : std::get<InitReply>(reply);
}

inline StepReply Stepped(BrainProcess& brain, const Sensor& sensor = {}) {
  if (!brain.is_running()) return {};
  auto reply = brain.Step(Classic(sensor));
  EXPECT_EQ(ErrorIn(reply), "no error");
  return testing::Test::HasFailure() ? StepReply{} : std::get<StepReply>(reply);
}

inline std::string ErrorOfStep(const fs::path& folder, const BrainOptions& options = {}) {
  BrainProcess brain(folder, options);
  Started(brain);
  if (testing::Test::HasFailure()) return "did not start";
  const std::string error = ErrorIn(brain.Step(Classic(Sensor())));
  EXPECT_FALSE(brain.is_running());
  return error;
}

inline std::string ErrorOfInit(const fs::path& folder, const BrainOptions& options = {}) {
  BrainProcess brain(folder, options);
  const std::string error = ErrorIn(brain.Init(Classic(Aux())));
  EXPECT_FALSE(brain.is_running());
  return error;
}

inline Image Gradient(int width_px, int height_px) {
  Image image{.width_px = width_px, .height_px = height_px, .color = {}, .depth = {}, .ids = {}};
  for (int k = 0; k < width_px * height_px * 3; ++k) {
    image.color.push_back(static_cast<std::uint8_t>(k * 7 % 256));
  }
  return image;
}

}  // namespace smile::brain
