#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "base/files.h"
#include "base/json.h"

namespace smile {

/// What a program answered.
struct Answer {
  int exit_code = -1;  ///< 128 + signal when it was killed
  std::string out, err;

  Json json() const { return Json::parse(out); }
};

/// Runs the built program the way a user does, in a directory of the test's own.
class ProgramTest : public ::testing::Test {
 protected:
  ProgramTest() {
    std::string test = ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::ranges::replace(test, '/', '_');  // of a test with parameters
    directory_ =
        std::filesystem::temp_directory_path() / ("smile_" + std::to_string(getpid()) + "_" + test);
    std::filesystem::create_directories(directory_);
    // The robots that a user added are of no matter here.
    setenv("XDG_DATA_HOME", (directory_ / "data").c_str(), 1);
  }
  ~ProgramTest() override {
    if (HasFailure()) std::cerr << complaints_;
    std::filesystem::remove_all(directory_);
  }

  /// Runs a line of shell in which `smile` is the program.
  Answer Shell(const std::string& line) const {
    const std::string script = "smile() { \"" SMILE_PROGRAM "\" \"$@\"; }; cd '" +
                               directory_.string() + "'; { " + line + "\n} >out.txt 2>err.txt";
    Write("script.sh", script);
    const int status = std::system(("bash '" + (directory_ / "script.sh").string() + "'").c_str());
    Answer answer{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), Read("out.txt"),
                  Read("err.txt")};
    if (answer.exit_code != 0) {
      complaints_ +=
          "[ exit " + std::to_string(answer.exit_code) + " ] " + line + "\n" + answer.err;
    }
    return answer;
  }
  Answer Smile(const std::string& arguments) const { return Shell("smile " + arguments); }

  void Write(const std::string& name, const std::string& text) const {
    const auto path = directory_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path) << text;
  }
  std::string Read(const std::string& name) const { return ReadFile(directory_ / name, 1 << 26); }
  bool Exists(const std::string& name) const { return std::filesystem::exists(directory_ / name); }

  /// A file that ships with the project.
  static std::string Shipped(const std::string& name) {
    return std::string(SMILE_SOURCE_DIR) + "/" + name;
  }

  std::filesystem::path directory_;

 private:
  /// What the program said whenever it did not exit with 0: shown when the test fails.
  mutable std::string complaints_;
};

/// `root.xml` with this inside.
inline std::string SceneOf(const std::string& elements) {
  return "<tabletop xmlns=\"http://synapse.cs.umd.edu/tabletop-xml\">\n" + elements +
         "\n</tabletop>\n";
}

/// Two blocks, `a` and `b`.
inline std::string PairOfBlocks() {
  return SceneOf(
      "<block id=\"a\" color=\"red\" location=\"(0, -3, 0.5)\"/>\n"
      "<block id=\"b\" color=\"blue\" location=\"(2, -3, 0.5)\"/>");
}

/// Returns the scene of PairOfBlocks(), but `a` begins above its place and falls there: a task of
/// its place is done by doing nothing.
inline std::string PairThatFallsIntoPlace() {
  return SceneOf(
      "<block id=\"a\" color=\"red\" location=\"(0, -3, 1.5)\"/>\n"
      "<block id=\"b\" color=\"blue\" location=\"(2, -3, 0.5)\"/>");
}

/// Returns commands that grasp `a` and release it where it is.
inline std::string LiftAndPutBack() {
  return "{\"hand\":\"right\",\"do\":\"grasp\",\"object\":\"a\"}\n"
         "{\"do\":\"wait\",\"seconds\":0.2}\n"
         "{\"hand\":\"right\",\"do\":\"release\"}\n"
         "{\"do\":\"wait\",\"until\":\"still\"}\n";
}

/// Puts `a` on `b`.
inline std::string StackPair() {
  return "{\"hand\":\"right\",\"do\":\"grasp\",\"object\":\"a\"}\n"
         "{\"hand\":\"right\",\"do\":\"move_to\",\"position\":[0,-3,2.5]}\n"
         "{\"do\":\"wait\",\"until\":\"arrived\"}\n"
         "{\"hand\":\"right\",\"do\":\"move_to\",\"position\":[2,-3,2.5]}\n"
         "{\"do\":\"wait\",\"until\":\"arrived\"}\n"
         "{\"hand\":\"right\",\"do\":\"move_to\",\"position\":[2,-3,1.51]}\n"
         "{\"do\":\"wait\",\"until\":\"arrived\"}\n"
         "{\"hand\":\"right\",\"do\":\"release\"}\n"
         "{\"do\":\"wait\",\"until\":\"still\"}\n";
}

}  // namespace smile
