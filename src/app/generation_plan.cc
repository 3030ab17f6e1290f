#include "app/generation_plan.h"

#include <algorithm>
#include <sstream>
#include <stdexcept>

#include "app/open_recording.h"
#include "base/wording.h"
#include "experiment/robot_region.h"
#include "layout/layout_choice.h"
#include "model/eye.h"
#include "scene_xml/scene_reader.h"

namespace smile::app {
namespace {

void RequireOrder(const experiment::VariationChoices& choices) {
  for (const experiment::Range& range : {choices.joints, choices.image, choices.depth}) {
    if (range.low > range.high) {
      throw std::invalid_argument("noise: found the range " + NumberText(range.low) + ".." +
                                  NumberText(range.high) + ", expected the lower number first");
    }
  }
}

/// Parses `joints=0..0.01,image=0.02`: a range or a value for each kind of noise.
void ParseNoiseRanges(const std::string& text, experiment::VariationChoices* choices) {
  std::string low, high;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t dots = part.find("..");
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::string key = part.substr(0, equals);
    if (key == "seed") {
      throw std::invalid_argument("noise: found \"seed\", which the seed of each attempt is");
    }
    const std::string comma = low.empty() ? "" : ",";
    low += comma + part.substr(0, dots);
    high += comma + (dots == std::string::npos ? part : key + "=" + part.substr(dots + 2));
  }
  const brain::SensorNoise least = ParseNoise(low), most = ParseNoise(high);
  choices->joints = {least.joints, most.joints};
  choices->image = {least.image, most.image};
  choices->depth = {least.depth, most.depth};
  RequireOrder(*choices);
}

/// Returns the noise as the argument of `--noise`; empty for none.
std::string NoiseText(const brain::SensorNoise& noise) {
  if (noise.joints == 0 && noise.image == 0 && noise.depth == 0) return "";
  return "joints=" + NumberText(noise.joints) + ",image=" + NumberText(noise.image) +
         ",depth=" + NumberText(noise.depth) + ",seed=" + std::to_string(noise.seed);
}

std::vector<std::string> ImitateArguments(const GenerateOptions& options,
                                          const experiment::Attempt& attempt,
                                          const std::string& out) {
  std::vector<std::string> arguments{"imitate",
                                     options.demo,
                                     attempt.variation.scene,
                                     "--brain",
                                     options.brain,
                                     "--seed",
                                     std::to_string(attempt.seed),
                                     "--level",
                                     attempt.variation.level,
                                     "--out",
                                     out,
                                     "--hold",
                                     NumberText(options.hold),
                                     "--verify",
                                     "--no-pictures"};
  for (std::string& argument :
       ArgumentsOf(options.settings, attempt.variation.eye, NoiseText(attempt.variation.noise))) {
    arguments.push_back(std::move(argument));
  }
  // Left out if nothing is changed, as in a command that a person types.
  if (const std::string changes = ChangesText(attempt.variation); !changes.empty()) {
    arguments.insert(arguments.end(), {"--variation", changes});
  }
  return arguments;
}

/// Checks that the cameras to displace exist: in a scene, one that does not has no effect.
void RequireCameras(const std::vector<std::string>& cameras, const scene::SceneSpec& scene,
                    const sim::RobotPlacement& robot) {
  if (cameras.empty()) return;
  const std::vector<std::string> names = model::CameraNames(model::Model(scene, robot));
  const std::vector<std::string_view> words(names.begin(), names.end());
  for (const std::string& camera : cameras) {
    if (std::ranges::find(names, camera) != names.end()) continue;
    throw std::invalid_argument("jitter-camera: found " + Quoted(camera) + ", expected " +
                                OneOf(words) + DidYouMean(camera, words));
  }
}

/// Adds the colors of the scenes' objects, which are varied one by one.
void AddColors(const std::vector<experiment::GenerationScene>& scenes,
               experiment::VariationChoices* choices) {
  for (const experiment::GenerationScene& scene : scenes) {
    std::vector<std::string> colors = experiment::ColorsOf(scene.spec);
    if (colors.size() > experiment::kMaxColors) {
      throw std::invalid_argument(scene.name + ": the objects have " +
                                  std::to_string(colors.size()) + " colors, expected at most " +
                                  std::to_string(experiment::kMaxColors));
    }
    choices->colors[scene.name] = std::move(colors);
  }
}

}  // namespace

experiment::GenerationPlan PlanOf(const GenerateOptions& options) {
  const std::filesystem::path out = options.out.empty()
                                        ? std::filesystem::path("out/generate") /
                                              std::filesystem::path(options.scenes.front()).stem()
                                        : std::filesystem::path(options.out);
  RequireOutsideOfRecordings(out.string());
  // Checks all inputs now, since an error in a run would appear as many times as there are runs.
  OpenAndReport(options.demo);
  for (const std::string& eye : options.eyes) {
    EyeSpecOf({.camera = eye, .size = options.settings.size});
  }
  const auto robot = PlaceRobot(options.settings.robot, options.settings.path);
  const experiment::Shard shard = experiment::ParseShard(options.pool.shard);
  experiment::GenerationPlan plan{
      .demonstration = options.demo,
      .robot = robot->files,
      .brain = options.brain,
      .choices = {.scenes = options.scenes, .levels = options.levels, .eyes = options.eyes},
      .count = options.count,
      .tries = options.tries,
      .first_seed = options.seed,
      .shard = shard,
      .jobs = options.pool.jobs,
      .wall_seconds = options.pool.wall_seconds,
      .out = out,
      .program = std::filesystem::read_symlink("/proc/self/exe"),
      .settings = ArgumentsOf(options.settings, "", "")};
  plan.settings.insert(plan.settings.end(), {"--hold", NumberText(options.hold)});
  ParseNoiseRanges(options.noise, &plan.choices);
  AddChoices(options.variation, &plan.choices);
  for (const std::string& scene : options.scenes) {
    plan.scenes.push_back({scene, scene_xml::LoadScene(scene, options.settings.path.reader())});
    RequireCameras(plan.choices.looks.cameras, plan.scenes.back().spec, robot.value());
  }
  AddColors(plan.scenes, &plan.choices);
  plan.layout = [scenes = plan.scenes, robot](const experiment::Attempt& attempt) {
    const auto scene =
        std::ranges::find(scenes, attempt.variation.scene, &experiment::GenerationScene::name);
    const auto level = layout::ParseLayoutLevel(attempt.variation.level).value();
    return layout::LaidOut(scene->spec, {.seed = attempt.seed, .level = level}, [&](double height) {
      return experiment::RegionOf(robot.value(), height);
    });
  };
  plan.arguments = [options](const experiment::Attempt& attempt, const std::filesystem::path& to) {
    return ImitateArguments(options, attempt, to.string());
  };
  return plan;
}

}  // namespace smile::app
