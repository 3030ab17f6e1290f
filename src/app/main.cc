// The `smile` program: `smile --help`.

#include <fcntl.h>
#include <malloc.h>
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <stdexcept>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/interrupt.h"
#include "base/diagnostic.h"
#include "base/version.h"

namespace {

/// Opens missing standard streams as /dev/null. Otherwise a program started without them would open
/// its files in their place, and write messages into a recording.
void FillStandardStreams() {
  int fd = 0;
  while (fd >= 0 && fd <= STDERR_FILENO) fd = open("/dev/null", O_RDWR);
  if (fd > STDERR_FILENO) close(fd);
}

/// Makes the allocator take memory from the system, and return it, in large portions. For this the
/// system locks the memory of the whole process: with small ones, two threads that make, save and
/// restore simulations lose a tenth of their time.
void TakeMemoryInLargePortions() {
  mallopt(M_TOP_PAD, 16 << 20);
  // Both are fixed together: without this, blocks from 128 kB would be portions of their own.
  mallopt(M_MMAP_THRESHOLD, 32 << 20);
}

}  // namespace

int main(int argc, char** argv) {
  using namespace smile;
  CLI::App program("SMILE: show a robot a tabletop task with invisible hands.", "smile");
  program.set_version_flag("--version", ProgramName());
  program.require_subcommand(1);
  program.set_help_all_flag("--help-all", "Show the help of every command");
  int answer = app::kDone;
  app::AddCheck(&program, &answer);
  app::AddRun(&program, &answer);
  app::AddStudio(&program, &answer);
  app::AddStudy(&program, &answer);
  app::AddReplay(&program, &answer);
  app::AddHistory(&program, &answer);
  app::AddDescribe(&program, &answer);
  app::AddAnalyze(&program, &answer);
  app::AddCheckout(&program, &answer);
  app::AddCorrect(&program, &answer);
  app::AddEdit(&program, &answer);
  app::AddImport(&program, &answer);
  app::AddExport(&program, &answer);
  app::AddDoctor(&program, &answer);
  app::AddRos(&program, &answer);
  app::AddRender(&program, &answer);
  app::AddLayout(&program, &answer);
  app::AddRerender(&program, &answer);
  app::AddRobots(&program, &answer);
  app::AddImitate(&program, &answer);
  app::AddEvaluate(&program, &answer);
  app::AddGenerate(&program, &answer);
  app::AddMerge(&program, &answer);
  app::AddTabulate(&program, &answer);
  app::AddExperiment(&program, &answer);
  app::AddCommands(&program, &answer);
  app::AddProtocol(&program, &answer);
  app::AddBench(&program, &answer);

  FillStandardStreams();
  TakeMemoryInLargePortions();
  // A file size limit is reported as an error, like a full disk, and does not kill the program.
  signal(SIGXFSZ, SIG_IGN);
  app::CatchInterrupts();
  try {
    program.parse(argc, argv);
    if (app::IsInterrupted()) std::fprintf(stderr, "smile: interrupted\n");
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
      throw std::runtime_error("stdout cannot be written");
    }
    return answer;
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? app::kDone : app::kUsedWrongly;
  } catch (const InputError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return app::kInputWrong;
  } catch (const std::invalid_argument& error) {
    std::fprintf(stderr, "smile: %s\n", error.what());
    return app::kUsedWrongly;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "smile: %s\n", error.what());
    return app::kMachineNo;
  }
}
