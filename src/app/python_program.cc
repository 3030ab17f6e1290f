#include "app/python_program.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "brain/python_command.h"

namespace smile::app {
namespace {

/// The same as `-m MODULE`, except for the message about a package that is missing.
constexpr const char* kStart = R"python(
import importlib, sys
module, needs = sys.argv[1:3]
try:
    main = importlib.import_module(module + ".__main__").main
except ImportError as error:
    print("smile: " + needs.format(error=error, python=sys.executable), file=sys.stderr)
    sys.exit(3)
sys.exit(main(sys.argv[3:]))
)python";

[[noreturn]] void ContinueAsPython(const char* module, const char* needs,
                                   const std::vector<std::string>& arguments) {
  process::ChildCommand command = brain::PythonCommand();
  command.arguments.insert(command.arguments.end(), {"-c", kStart, module, needs});
  command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
  for (const auto& [name, value] : command.environment) {
    setenv(name.c_str(), value.c_str(), /*overwrite=*/1);
  }
  std::vector<char*> words;
  for (std::string& argument : command.arguments) words.push_back(argument.data());
  words.push_back(nullptr);
  // In place of this process: Ctrl-C and exit codes are Python's.
  execv(words.front(), words.data());
  throw std::runtime_error(command.arguments.front() +
                           ": cannot be started: " + std::strerror(errno));
}

}  // namespace

void ContinueAsPythonDatasets(const std::vector<std::string>& arguments) {
  ContinueAsPython("smile.datasets",
                   "datasets need a Python package: {error}; get it by\n  {python} -m pip install "
                   "pyarrow\nor name another Python in SMILE_PYTHON (docs/datasets.md)",
                   arguments);
}

void ContinueAsPythonRos(const std::vector<std::string>& arguments) {
  ContinueAsPython("smile.ros",
                   "ROS needs Debian's packages: {error}; get them by\n  tools/get_ros.sh "
                   "(docs/real-robot.md)",
                   arguments);
}

}  // namespace smile::app
