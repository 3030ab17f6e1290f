#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/film.h"
#include "app/options.h"
#include "app/viewpoint.h"
#include "base/diagnostic.h"
#include "camera/renderer.h"
#include "record/png.h"
#include "record/sight.h"
#include "scene_xml/scene_reader.h"

namespace smile::app {
namespace {

struct RenderCommandOptions {
  std::string subject, camera = "nice", size = "1280x720", channels = "rgb", out;
  double rate = 30, speed = 1;
  RobotOptions robot;
  PathOptions path;
};

struct Channels {
  bool rgb = false, depth = false, id = false;
};

Channels ParseChannels(const std::string& text) {
  Channels channels;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    const std::string name = text.substr(start, end - start);
    if (name == "rgb") {
      channels.rgb = true;
    } else if (name == "depth") {
      channels.depth = true;
    } else if (name == "id") {
      channels.id = true;
    } else {
      throw std::invalid_argument("channel is '" + name + "', expected rgb, depth or id");
    }
    start = end + 1;
  }
  return channels;
}

/// `out/um.png` and "depth" make `out/um.depth.png`.
std::filesystem::path WithTag(std::filesystem::path path, const std::string& tag) {
  return path.replace_extension("." + tag + path.extension().string());
}

void RenderPicture(const sim::Simulation& simulation, const record::TraceTick& moment,
                   const RenderCommandOptions& options) {
  const Channels channels = ParseChannels(options.channels);
  const bool is_eye = options.camera == "eye";
  const camera::RenderOptions render{
      .color = channels.rgb,
      .depth = channels.depth,
      .ids = channels.id,
      .look = is_eye ? camera::Look::kRobotEye : camera::Look::kPresentation,
      .excluded_frames = HiddenFrames(moment, simulation, is_eye)};
  const Image image = camera::Renderer().Render(
      simulation.visual_model(), record::VisualStateAt(moment, simulation),
      FindView(options.camera, simulation, moment.joints, ParseSize(options.size)), render);
  const auto write = [](auto writer, const std::filesystem::path& path, const Image& what) {
    writer(path, what);
    std::printf("%s\n", path.c_str());
  };
  if (channels.rgb) write(&record::WritePng, options.out, image);
  if (channels.depth) write(&record::WriteDepthPng, WithTag(options.out, "depth"), image);
  if (channels.id) write(&record::WriteIdPng, WithTag(options.out, "id"), image);
}

int Render(const RenderCommandOptions& options) {
  const bool is_film = std::filesystem::path(options.out).extension() == ".mp4";
  if (!is_film && std::filesystem::path(options.out).extension() != ".png") {
    throw std::invalid_argument("--out is '" + options.out + "', expected a .png or .mp4 file");
  }
  if (!record::IsRecording(options.subject)) {
    const sim::Simulation simulation(scene_xml::LoadScene(options.subject, options.path.reader()),
                                     PlaceRobot(options.robot));
    if (is_film) {
      throw std::invalid_argument("a film needs a recording, but '" + options.subject +
                                  "' is none");
    }
    RenderPicture(simulation, record::Observe(simulation), options);
    return kDone;
  }
  const record::Recording recording = record::OpenRecording(options.subject);
  if (is_film) {
    if (options.channels != "rgb") throw std::invalid_argument("a film has the channel rgb only");
    Film(recording, options.out,
         {.camera = options.camera,
          .size = ParseSize(options.size),
          .frames_per_second = options.rate,
          .speed = options.speed,
          .progress = "filming"});
    std::printf("%s\n", options.out.c_str());
    return kDone;
  }
  const sim::Simulation simulation(recording.scene, recording.robot);
  const auto last = LastMoment(recording);
  if (!last) throw InputError({options.subject, 0, "", "its trace holds no moment"});
  RenderPicture(simulation, *last, options);
  return kDone;
}

}  // namespace

void AddRender(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<RenderCommandOptions>();
  CLI::App* render = program->add_subcommand(
      "render", "Draw a scene or the end of a recording as .png, or film a recording as .mp4");
  render->add_option("SUBJECT", options->subject, "scene file or directory of a recording")
      ->required();
  render->add_option("--out", options->out, "file to write: .png or .mp4")->required();
  std::string names;
  for (const std::string& name : ViewNames()) names += (names.empty() ? "" : ", ") + name;
  render->add_option("--camera", options->camera, "one of " + names)->capture_default_str();
  render->add_option("--size", options->size, "WIDTHxHEIGHT")->capture_default_str();
  render->add_option("--channels", options->channels, "of a picture: rgb,depth,id")
      ->capture_default_str();
  render->add_option("--rate", options->rate, "film frames per second")
      ->capture_default_str()
      ->check(NumberBetween(1.0, 240.0));
  render->add_option("--speed", options->speed, "of a film: 2 is twice as fast")
      ->capture_default_str()
      ->check(NumberBetween(0.01, 100.0));
  render->add_flag("--no-robot", options->robot.no_robot, "a scene without the robot");
  render->add_flag("--classic", options->robot.classic, "the robot where the original put it");
  AddPathOption(render, &options->path);
  render->callback([options, answer] { *answer = Render(*options); });
}

}  // namespace smile::app
