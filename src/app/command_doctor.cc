// `smile doctor`: checks a dataset.

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "app/commands.h"
#include "app/python_datasets.h"

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

}  // namespace smile::app
