#include "app/layout_options.h"

#include <utility>
#include <vector>

namespace smile::app {

CLI::Option* AddLayoutOptions(CLI::App* command, LayoutOptions* options) {
  CLI::Option* seed =
      command
          ->add_option("--seed", options->seed,
                       "random starting positions instead of those of the scene; the same seed "
                       "gives the same")
          ->check(CLI::NonNegativeNumber);
  const std::vector<std::string> words(layout::kLayoutLevelWords.begin(),
                                       layout::kLayoutLevelWords.end());
  command->add_option("--level", options->level, "how hard they make it (docs/experiments.md)")
      ->capture_default_str()
      ->check(CLI::IsMember(words))
      ->needs(seed);
  return seed;
}

scene::SceneSpec LaidOut(scene::SceneSpec scene, const LayoutOptions& options) {
  if (!options.seed) return scene;
  return layout::RandomLayout(std::move(scene), *options.seed,
                              layout::ParseLayoutLevel(options.level).value());
}

}  // namespace smile::app
