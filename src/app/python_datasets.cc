#include "app/python_datasets.h"

#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include "brain/python_command.h"

namespace smile::app {
namespace {

/// The same as `-m smile.datasets`, except for the message.
constexpr const char* kStart = R"python(
import sys
try:
    from smile.datasets.__main__ import main
except ImportError as error:
    print(f"smile: datasets need a Python package: {error}; get it by\n"
          f"  {sys.executable} -m pip install pyarrow\n"
          "or name another Python in SMILE_PYTHON (docs/datasets.md)", file=sys.stderr)
    sys.exit(3)
sys.exit(main(sys.argv[1:]))
)python";

}  // namespace

void ContinueAsPythonDatasets(const std::vector<std::string>& arguments) {
  process::ChildCommand command = brain::PythonCommand();
  command.arguments.insert(command.arguments.end(), {"-c", kStart});
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

}  // namespace smile::app
