// Finds out what a path is (a folder of scripts, a Python file, an executable), which interpreter
// runs it, and with which command and environment. Reads the environment of this process
// (SMILE_OCTAVE, SMILE_MATLAB, SMILE_PYTHON, SMILE_BRAIN_MEX_DIR, VIRTUAL_ENV, PYTHONPATH, PATH),
// but starts nothing.

#include "brain/internal_brain_program.h"

#include <unistd.h>

#include <cstdlib>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <system_error>

#include "base/diagnostic.h"
#include "base/files.h"
#include "brain/python_command.h"

namespace smile::brain {
namespace {

namespace fs = std::filesystem;

constexpr const char* kMainScript = "agentBehavior.m";

/// Start commands for Octave and Matlab. Paths are passed in environment variables, so nothing
/// needs quoting.
constexpr const char* kStartClient =
    "addpath(getenv('SMILE_BRAIN_MEX')); addpath(getenv('SMILE_BRAIN_CLIENT')); smile_brain";
// For a debugger: the same paths and the brain's own folder, so that breakpoints can be set in its
// scripts before it runs.
constexpr const char* kPrepareClient =
    "addpath(getenv('SMILE_BRAIN_MEX')); addpath(getenv('SMILE_BRAIN_CLIENT')); "
    "addpath(getenv('SMILE_BRAIN_FOLDER'));";
constexpr const char* kOctaveHint =
    "at its prompt, for example:  dbstop in myCallback at 1  and then  smile_brain";
constexpr const char* kPythonHint = "at its prompt, for example:  b ";
constexpr const char* kProgramHint = "at its prompt, for example:  break FILE:LINE  and then  run";

[[noreturn]] void Reject(const fs::path& brain, const std::string& message) {
  throw InputError(
      Diagnostic{.file = brain.string(), .line = 0, .element = {}, .message = message});
}

bool IsExecutable(const fs::path& file) {
  std::error_code error;
  return fs::is_regular_file(file, error) && ::access(file.c_str(), X_OK) == 0;
}

/// Returns the program that an environment variable names; nullopt if the variable is not set. A
/// variable that names no program is an error, not ignored: a typing mistake would otherwise
/// silently run another interpreter.
std::optional<fs::path> NamedProgram(const char* variable) {
  const char* named = std::getenv(variable);
  if (named == nullptr || *named == '\0') return std::nullopt;
  if (IsExecutable(named)) return fs::absolute(named);
  throw std::runtime_error(std::string(variable) + ": " + named + " is not a program");
}

std::optional<fs::path> ProgramOnPath(const std::string& name) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/usr/local/bin:/usr/bin:/bin");
  // An empty entry of PATH means the current directory to a shell; it is skipped here, as it would
  // run whatever lies there.
  for (std::string folder; std::getline(folders, folder, ':');) {
    const fs::path candidate = fs::path(folder) / name;
    if (!folder.empty() && IsExecutable(candidate)) return fs::absolute(candidate);
  }
  return std::nullopt;
}

/// Returns `SMILE_OCTAVE` if it is set, otherwise octave-cli on the PATH.
fs::path FindOctave() {
  if (const auto named = NamedProgram("SMILE_OCTAVE")) return *named;
  if (const auto found = ProgramOnPath("octave-cli")) return *found;
  throw std::runtime_error(
      "octave-cli: not found on the PATH; install GNU Octave, or name it in SMILE_OCTAVE");
}

/// Returns `SMILE_PYTHON`, or the interpreter of the active virtual environment, or the system's,
/// for which the system's numpy and the compiled modules are built, or else the one on the PATH.
fs::path FindPython() {
  if (const auto named = NamedProgram("SMILE_PYTHON")) return *named;
  const char* environment = std::getenv("VIRTUAL_ENV");
  if (environment != nullptr && *environment != '\0') {
    const fs::path python = fs::path(environment) / "bin/python3";
    if (IsExecutable(python)) return fs::absolute(python);
  }
  if (IsExecutable("/usr/bin/python3")) return "/usr/bin/python3";
  if (const auto found = ProgramOnPath("python3")) return *found;
  throw std::runtime_error(
      "python3: not found on the PATH; install Python and numpy, or name it in SMILE_PYTHON");
}

/// Returns the folder of the compiled client: of the build, or beside the plain one if installed.
/// SMILE_BRAIN_MEX_DIR overrides both.
fs::path MexFolder() {
  if (const char* named = std::getenv("SMILE_BRAIN_MEX_DIR")) return fs::absolute(named);
  std::error_code error;
  return fs::exists(SMILE_MEX_DIR, error) ? fs::path(SMILE_MEX_DIR) : DataFile("matlab/client");
}

/// Sets up scripts, run by Octave, or by the Matlab that `SMILE_MATLAB` names.
void UseScripts(BrainTransport transport, BrainProgram* program) {
  const auto matlab = NamedProgram("SMILE_MATLAB");
  const fs::path mex_folder = MexFolder();
  const char* mex = matlab ? "smilelink.mexa64" : "smilelink.mex";
  const bool has_mex = fs::exists(mex_folder / mex);
  if (transport == BrainTransport::kMex && !has_mex) {
    // Only an explicit request fails; kAutomatic uses pipes without the compiled client.
    throw std::runtime_error((mex_folder / mex).string() + ": not found");
  }
  const bool uses_mex = has_mex && transport != BrainTransport::kPlain;
  program->rendezvous = uses_mex ? Rendezvous::Kind::kSocket : Rendezvous::Kind::kPipes;

  // Octave's options keep startup files, history and the banner out: a brain runs the same for each
  // user. A debugger session keeps its history and prompt.
  const fs::path client = DataFile("matlab/client");
  if (matlab) {
    program->command.arguments = {matlab->string(), "-batch", kStartClient};
    program->debug_arguments = {matlab->string(), "-nodesktop", "-nosplash", "-r", kPrepareClient};
  } else {
    const std::string octave = FindOctave().string();
    program->command.arguments = {octave, "-q", "--norc", "--no-history", "--eval", kStartClient};
    program->debug_arguments = {octave, "-q", "--norc", "--eval", kPrepareClient, "--persist"};
  }
  program->debug_hint = kOctaveHint;
  // The guard against endless loops is used with both transports, so its folder is always passed.
  program->command.environment = {{"SMILE_BRAIN_CLIENT", client.string()},
                                  {"SMILE_BRAIN_MEX", (has_mex ? mex_folder : client).string()}};
}

/// Returns PYTHONPATH with the shipped modules before those of the user.
std::string PythonPath() {
  std::string path = DataFile("python").string();
  // An empty entry would be the working directory. What pip installed is found without one.
  constexpr std::string_view kCompiled = SMILE_PYTHON_BUILD_DIR;
  if (!kCompiled.empty()) path += ":" + std::string(kCompiled);
  const char* before = std::getenv("PYTHONPATH");
  return before != nullptr && *before != '\0' ? path + ":" + before : path;
}

void UsePython(const fs::path& file, BrainProgram* program) {
  program->command = PythonCommand();
  const std::string python = program->command.arguments.front();
  // Unbuffered (-u), since a pipe would otherwise hold back the output until the end.
  program->command.arguments.insert(program->command.arguments.end(), {"-u", "-m", "smile.brain"});
  program->debug_arguments = {python, "-m", "pdb", "-m", "smile.brain"};
  program->debug_hint = kPythonHint + file.string() + ":1  and then  c";
  program->command.environment.emplace(program->command.environment.begin(), "SMILE_BRAIN_PROGRAM",
                                       file.string());
}

void UseExecutable(const fs::path& file, BrainTransport transport, BrainProgram* program) {
  // A compiled program has no plain client to prefer, so the socket is the default.
  program->rendezvous =
      transport == BrainTransport::kPlain ? Rendezvous::Kind::kPipes : Rendezvous::Kind::kSocket;
  program->command.arguments = {file.string()};
  program->debug_arguments = {"gdb", "--args", file.string()};
  program->debug_hint = kProgramHint;
}

/// Returns a text as one word for a shell.
std::string ShellQuoted(const std::string& text) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=./:,@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string quoted = "'";
  // Within single quotes a shell interprets nothing; a single quote itself must leave and reenter
  // them.
  for (const char letter : text) quoted += letter == '\'' ? "'\\''" : std::string(1, letter);
  return quoted + "'";
}

/// Returns an absolute path without `.`, `..` or a trailing slash.
fs::path Tidy(const fs::path& path) {
  const fs::path tidy = fs::absolute(path).lexically_normal();
  return tidy.has_filename() ? tidy : tidy.parent_path();
}

}  // namespace

process::ChildCommand PythonCommand() {
  // PYTHONSAFEPATH keeps the working directory off the module path: a file there named like a
  // standard module would replace it.
  return {.arguments = {FindPython().string()},
          .environment = {{"PYTHONPATH", PythonPath()}, {"PYTHONSAFEPATH", "1"}},
          .working_directory = {}};
}

BrainProgram FindBrainProgram(const fs::path& brain, BrainTransport transport) {
  std::error_code error;
  if (auto server = ParseServerAddress(brain.string())) {
    return {.folder = {},
            .working_directory = {},
            .folder_name = {},
            .main_file = brain,
            .rendezvous = Rendezvous::Kind::kNone,
            .server = std::move(server),
            .command = {},
            .debug_arguments = {},
            .debug_hint = {}};
  }
  const fs::path path = Tidy(brain);
  if (brain.empty() || !fs::exists(path, error)) {
    Reject(brain,
           "no such brain, expected a folder with agentBehavior.m, a Python file, a program, or an "
           "address, tcp://HOST:PORT or unix:PATH");
  }
  // For a file, the brain's folder is the one that contains it. In both cases the program starts in
  // the parent of that folder, so `wave/waveInit.m` is how it and its messages name a script.
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
    UseScripts(transport, &program);
  } else if (path.extension() == ".py") {
    UsePython(path, &program);
  } else if (IsExecutable(path)) {
    UseExecutable(path, transport, &program);
  } else {
    Reject(brain,
           "not a program, expected a folder with agentBehavior.m, a Python file or an "
           "executable file (chmod +x makes it one)");
  }
  program.command.working_directory = program.working_directory;
  return program;
}

std::string HowToAttach(const BrainProgram& program, const process::ChildCommand& command) {
  std::string line = "cd " + ShellQuoted(program.working_directory.string()) + " && env";
  for (const auto& [name, value] : command.environment) {
    line += " " + ShellQuoted(name + "=" + value);
  }
  for (const std::string& argument : program.debug_arguments) line += " " + ShellQuoted(argument);
  return "start the brain in another terminal:\n\n" + line + "\n\n" + program.debug_hint;
}

}  // namespace smile::brain
