#include "process/child_process.h"

#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <string>

namespace smile::process {
namespace {

/// Runs a line of shell with limits and returns what it prints.
std::string Shell(const std::string& line, const ResourceLimits& limits, std::string* end) {
  ChildProcess child(
      {.arguments = {"/bin/bash", "-c", line}, .working_directory = "/", .limits = limits});
  const UniqueFd output = child.TakeOutput();
  std::string printed;
  char buffer[4096];
  for (pollfd watched{output.get(), POLLIN, 0}; poll(&watched, 1, 20'000) > 0;) {
    const ssize_t count = read(output.get(), buffer, sizeof buffer);
    if (count <= 0) break;
    printed.append(buffer, static_cast<std::size_t>(count));
  }
  child.WaitForEnd(WaitLimit(20));
  *end = child.End();
  return printed;
}

TEST(ChildLimits, ArriveAtTheProgram) {
  std::string end;
  const ResourceLimits limits{.cpu_seconds = 7, .memory_bytes = 256 << 20, .file_bytes = 1 << 20};
  EXPECT_EQ(Shell("ulimit -t; ulimit -d; ulimit -f", limits, &end), "7\n262144\n1024\n");
  EXPECT_EQ(end, "it ended with exit code 0");
}

TEST(ChildLimits, EndAProgramThatComputesWithoutEnd) {
  std::string end;
  Shell("while :; do :; done", {.cpu_seconds = 1}, &end);
  EXPECT_TRUE(end.starts_with("it was ended by signal")) << end;
}

}  // namespace
}  // namespace smile::process
