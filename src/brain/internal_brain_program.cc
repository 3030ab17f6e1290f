#include "brain/internal_brain_program.h"

#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "base/diagnostic.h"
#include "base/files.h"

namespace smile::brain {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMainScript = "agentBehavior.m";

/// The client needs no quoting this way: every path travels in the environment.
constexpr const char* kStartClient =
    "addpath(getenv('SMILE_BRAIN_MEX')); addpath(getenv('SMILE_BRAIN_MOTION')); "
    "addpath(getenv('SMILE_BRAIN_CLIENT')); smile_brain";

[[noreturn]] void Reject(const fs::path& brain, const std::string& message) {
  throw InputError(
      Diagnostic{.file = brain.string(), .line = 0, .element = {}, .message = message});
}

bool IsExecutable(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0;
}

/// `SMILE_OCTAVE` where it is set, else octave-cli on the PATH.
fs::path FindOctave() {
  if (const char* named = std::getenv("SMILE_OCTAVE")) {
    if (IsExecutable(named)) return fs::absolute(named);
    throw std::runtime_error(std::string("SMILE_OCTAVE: ") + named + " is not a program");
  }
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/usr/local/bin:/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path candidate = fs::path(folder) / "octave-cli";
    if (!folder.empty() && IsExecutable(candidate)) return fs::absolute(candidate);
  }
  throw std::runtime_error(
      "octave-cli: not found on the PATH; install GNU Octave, or name it in SMILE_OCTAVE");
}

/// Where smilelink.mex lies when it was built; SMILE_BRAIN_MEX_DIR overrides.
fs::path MexFolder() {
  const char* named = std::getenv("SMILE_BRAIN_MEX_DIR");
  return named ? fs::absolute(named) : fs::path(SMILE_MEX_DIR);
}

void UseOctave(BrainTransport transport, BrainProgram* program) {
  const fs::path mex_folder = MexFolder();
  const bool has_mex = fs::exists(mex_folder / "smilelink.mex");
  if (transport == BrainTransport::kMex && !has_mex) {
    throw std::runtime_error((mex_folder / "smilelink.mex").string() + ": not found");
  }
  const bool uses_mex = has_mex && transport != BrainTransport::kPlain;
  program->rendezvous = uses_mex ? Rendezvous::Kind::kSocket : Rendezvous::Kind::kPipes;

  const fs::path client = DataFile("matlab/client");
  program->command.arguments = {FindOctave().string(), "-q",     "--norc",
                                "--no-history",        "--eval", kStartClient};
  // The guard that ends endless loops serves both ways to talk, so its folder is always given.
  program->command.environment = {{"SMILE_BRAIN_CLIENT", client.string()},
                                  {"SMILE_BRAIN_MOTION", DataFile("matlab/motion").string()},
                                  {"SMILE_BRAIN_MEX", (has_mex ? mex_folder : client).string()}};
}

void UseExecutable(const fs::path& file, BrainTransport transport, BrainProgram* program) {
  program->rendezvous =
      transport == BrainTransport::kPlain ? Rendezvous::Kind::kPipes : Rendezvous::Kind::kSocket;
  program->command.arguments = {file.string()};
}

/// Absolute, without `.`, `..` or a trailing slash.
fs::path Tidy(const fs::path& path) {
  const fs::path tidy = fs::absolute(path).lexically_normal();
  return tidy.has_filename() ? tidy : tidy.parent_path();
}

}  // namespace

BrainProgram FindBrainProgram(const fs::path& brain, BrainTransport transport) {
  std::error_code error;
  const fs::path path = Tidy(brain);
  if (brain.empty() || !fs::exists(path, error)) {
    Reject(brain, "no such brain, expected a folder with agentBehavior.m or a program");
  }
  const bool is_folder = fs::is_directory(path, error);
  BrainProgram program;
  program.folder = is_folder ? path : path.parent_path();
  program.working_directory = program.folder.parent_path();
  program.folder_name = program.folder.filename().string() + "/";
  program.main_file = is_folder ? path / kMainScript : path;

  if (is_folder) {
    if (!fs::is_regular_file(program.main_file, error)) {
      Reject(brain, "the folder has no agentBehavior.m");
    }
    UseOctave(transport, &program);
  } else if (path.extension() == ".py") {
    Reject(brain, "Python brains cannot be run yet, expected a folder with agentBehavior.m");
  } else if (IsExecutable(path)) {
    UseExecutable(path, transport, &program);
  } else {
    Reject(brain, "not a program, expected a folder with agentBehavior.m or an executable file");
  }
  program.command.working_directory = program.working_directory;
  return program;
}

}  // namespace smile::brain
