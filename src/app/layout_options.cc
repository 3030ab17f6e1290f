#include "app/layout_options.h"

#include <vector>

namespace smile::app {

CLI::Validator IsLayoutLevel() {
  return CLI::IsMember(
      std::vector<std::string>(layout::kLayoutLevelWords.begin(), layout::kLayoutLevelWords.end()));
}

CLI::Option* AddLayoutOptions(CLI::App* command, LayoutOptions* options) {
  CLI::Option* seed =
      command
          ->add_option("--seed", options->seed,
                       "random starting positions instead of those of the scene; the same seed "
                       "gives the same")
          ->check(CLI::NonNegativeNumber);
  command->add_option("--level", options->level, "how hard they make it (docs/experiments.md)")
      ->capture_default_str()
      ->check(IsLayoutLevel())
      ->needs(seed);
  return seed;
}

}  // namespace smile::app
