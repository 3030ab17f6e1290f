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
                       "seed of random starting positions, which replace those of the scene")
          ->check(CLI::NonNegativeNumber);
  command
      ->add_option("--level", options->level,
                   "difficulty of the random starting positions (docs/experiments.md)")
      ->capture_default_str()
      ->check(IsLayoutLevel())
      ->needs(seed);
  return seed;
}

}  // namespace smile::app
