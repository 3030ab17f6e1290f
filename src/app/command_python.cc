// `smile doctor`: checks a dataset. `smile ros`: robots behind ROS.

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "app/commands.h"
#include "app/python_program.h"

namespace smile::app {

void AddDoctor(CLI::App* program, ExitAnswer /*answer*/) {
  auto dataset = std::make_shared<std::string>();
  CLI::App* doctor = program->add_subcommand(
      "doctor",
      "Check a dataset for faults with which programs fail to read it or learn nothing "
      "from it (docs/datasets.md)");
  doctor->add_option("DATASET", *dataset, "directory of the dataset")->required();
  doctor->callback([dataset] { ContinueAsPythonDatasets({"doctor", *dataset}); });
}

void AddRos(CLI::App* program, ExitAnswer /*answer*/) {
  CLI::App* ros = program->add_subcommand(
      "ros",
      "Show the simulated robot to ROS as a real one, or let a real one perform an imitation "
      "(docs/real-robot.md); `smile ros --help` lists the commands");
  // Its words are Python's.
  ros->prefix_command()->set_help_flag();
  ros->callback([ros] { ContinueAsPythonRos(ros->remaining()); });
}

}  // namespace smile::app
