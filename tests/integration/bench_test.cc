// The comparison of two builds by `smile bench --baseline`. The times themselves are not tested.

#include "program.h"

namespace smile {
namespace {

class Bench : public ProgramTest {
 protected:
  /// Writes a program that lists two benchmarks and reports a fixed time for each.
  void WriteBuild(const std::string& name, const std::string& cpu_time) const {
    Write(name,
          "#!/bin/sh\n"
          "if [ \"$BENCHMARK_LIST_TESTS\" ]; then\n"
          "  echo 'forward kinematics, one arm'; echo 'removed (C++)'\n"
          "else\n"
          "  echo '{\"benchmarks\": [{\"real_time\": 1, \"cpu_time\": " +
              cpu_time +
              ", \"time_unit\": \"ms\"}]}'\n"
              "fi\n");
    std::filesystem::permissions(directory_ / name, std::filesystem::perms::owner_all);
  }

  Answer CompareWith(const std::string& baseline) const {
    return Smile("bench --filter 'forward|removed' --min-time 0.001 --rounds 7 --json --baseline " +
                 baseline);
  }
};

TEST_F(Bench, TheProgramIsComparedWithItself) {
  const Answer answer = CompareWith(SMILE_PROGRAM);
  const Json row = answer.json()["benchmarks"].at(0);
  EXPECT_EQ(row["name"], "forward kinematics, one arm");
  EXPECT_NEAR(row["ratio"].get<double>(), 1, 0.9);
  EXPECT_LE(row["interval"][0], row["ratio"]);
  EXPECT_GE(row["interval"][1], row["ratio"]);
  EXPECT_EQ(answer.json()["only_in_the_baseline"], Json::array());
}

// Forward kinematics takes microseconds: far less than 900 ms, and far more than a femtosecond.
TEST_F(Bench, TheExitCodeReportsWhatIsSlower) {
  WriteBuild("slow", "900");
  const Answer faster = CompareWith("slow");
  EXPECT_EQ(faster.exit_code, 0) << faster.err;
  EXPECT_EQ(faster.json()["benchmarks"][0]["verdict"], "faster beyond noise");
  EXPECT_EQ(faster.json()["benchmarks"][0]["rounds"], 14);
  EXPECT_EQ(faster.json()["only_in_the_baseline"], Json::array({"removed (C++)"}));
  WriteBuild("fast", "1e-12");
  const Answer slower = CompareWith("fast");
  EXPECT_EQ(slower.exit_code, 1);
  EXPECT_EQ(slower.json()["benchmarks"][0]["verdict"], "slower beyond noise");
}

TEST_F(Bench, ABaselineThatCannotBeMeasuredIsAnError) {
  EXPECT_EQ(CompareWith("nowhere").err,
            "smile: nowhere: no such program, expected the program `smile` of a build\n");
  EXPECT_EQ(CompareWith("/bin/true").err,
            "smile: /bin/true: `bench` lists no benchmarks (it ended with exit code 0), expected "
            "the program `smile` of a build\n");
  WriteBuild("strange", "none");
  const Answer answer = CompareWith("strange");
  EXPECT_EQ(answer.exit_code, 3);
  EXPECT_NE(answer.err.find("benchmark 'forward kinematics, one arm': its result cannot be read"),
            std::string::npos)
      << answer.err;
  EXPECT_EQ(Smile("bench --rounds 8").exit_code, 2);
}

}  // namespace
}  // namespace smile
