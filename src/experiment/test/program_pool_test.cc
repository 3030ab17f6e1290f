#include "experiment/program_pool.h"

#include "experiment/bounded_log.h"
#include "experiment_fixture.h"

namespace smile::experiment {
namespace {

class ProgramPool : public ExperimentTest {
 protected:
  PoolJob Job(const std::string& script) {
    const std::string name = "job" + std::to_string(num_jobs_++);
    return {.command = {.arguments = {Write(name, "#!/bin/sh\n" + script + "\n").string()},
                        .environment = {},
                        .working_directory = root_},
            .log = root_ / (name + ".log")};
  }
  /// The order of starts (s) and ends (e), with the numbers of the jobs.
  PoolCalls Noting(std::string* order) {
    return {.on_start = [order](std::size_t job) { *order += "s" + std::to_string(job) + " "; },
            .on_end = [order](std::size_t job,
                              const PoolEnd&) { *order += "e" + std::to_string(job) + " "; },
            .on_wait = [] {},
            .is_cancelled = [] { return false; }};
  }

  int num_jobs_ = 0;
};

TEST_F(ProgramPool, RunsInOrderNoMoreAtATimeThanAllowed) {
  std::string order;
  EXPECT_TRUE(RunAll({Job(""), Job(""), Job("")}, 1, Noting(&order)));
  EXPECT_EQ(order, "s0 e0 s1 e1 s2 e2 ");
  order.clear();
  // The first ends only after the second, so both must run at once.
  EXPECT_TRUE(RunAll({Job("while [ ! -e second ]; do sleep 0.01; done"), Job("touch second")}, 2,
                     Noting(&order)));
  EXPECT_EQ(order.substr(0, 6), "s0 s1 ");
}

TEST_F(ProgramPool, OutputGoesToTheLog) {
  PoolEnd last;
  std::string order;
  PoolCalls calls = Noting(&order);
  calls.on_end = [&](std::size_t, const PoolEnd& end) { last = end; };
  EXPECT_TRUE(RunAll({Job("echo first; echo second >&2; exit 4")}, 1, calls));
  EXPECT_EQ(last.exit_code, 4);
  EXPECT_EQ(last.last_line, "second");
  EXPECT_EQ(Read("job0.log"), "first\nsecond\n");
}

TEST_F(ProgramPool, ACancelledOneLeavesNoProcessAndNoFurtherStart) {
  bool is_running = false;
  std::string order;
  PoolCalls calls = Noting(&order);
  calls.on_wait = [&] { is_running = Exists("pid"); };
  calls.is_cancelled = [&] { return is_running; };
  EXPECT_FALSE(RunAll({Job("echo $$ >pid.part; mv pid.part pid; sleep 60"), Job("")}, 1, calls));
  EXPECT_EQ(order, "s0 ");
  EXPECT_NE(::kill(std::stoi(Read("pid")), 0), 0);
}

TEST(BoundedLog, KeepsTheBeginningAndTheEnd) {
  const fs::path path = fs::temp_directory_path() / ("log_" + std::to_string(getpid()));
  BoundedLog log(path);
  log.Add("begin\n");
  for (int i = 0; i < 1000; ++i) log.Add(std::string(999, 'x') + "\n");
  log.Add("end\n\n");
  log.Finish();
  EXPECT_EQ(log.last_line(), "end");
  const std::string text = ReadFile(path, 1 << 20);
  fs::remove(path);
  EXPECT_LT(text.size(), BoundedLog::kBeginBytes + BoundedLog::kEndBytes + 100);
  EXPECT_TRUE(text.starts_with("begin\n") && text.ends_with("end\n\n"));
  EXPECT_NE(text.find(" bytes are omitted "), std::string::npos);
}

}  // namespace
}  // namespace smile::experiment
