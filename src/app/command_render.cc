#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <utility>

#include "app/commands.h"
#include "app/console_reporter.h"
#include "app/exit_code.h"
#include "app/open_recording.h"
#include "app/options.h"
#include "base/diagnostic.h"
#include "picture/film.h"
#include "picture/recording_renderer.h"
#include "picture/viewpoint.h"
#include "recording/markers.h"
#include "scene_xml/scene_reader.h"

namespace smile::app {
namespace {

struct RenderCommandOptions {
  std::string subject, camera = "nice", size = "1280x720", channels = "rgb", out;
  std::string demonstrator = "invisible";
  std::optional<double> at;
  recording::TimeRange range;
  double rate = 30, speed = 1;
  bool as_pictures = false;
  bool prints_progress = false;
  RobotOptions robot;
  PathOptions path;
};

/// Output of the command: one picture, a film, or a film as numbered pictures.
enum class Product { kPicture, kFilm, kPictures };

/// Returns the product, from the form of the output path.
Product ProductOf(const RenderCommandOptions& options) {
  const std::filesystem::path out = options.out;
  std::error_code error;
  if (options.as_pictures || !out.has_filename() || std::filesystem::is_directory(out, error)) {
    return Product::kPictures;
  }
  if (out.extension() == ".mp4") return Product::kFilm;
  if (out.extension() == ".png") return Product::kPicture;
  throw std::invalid_argument("--out is '" + options.out +
                              "', expected a .png or .mp4 file, or a directory: DIR/");
}

void CheckTimes(const RenderCommandOptions& options, Product product) {
  if (options.at && product != Product::kPicture) {
    throw std::invalid_argument("--at is for a picture; a film has --from and --to");
  }
  if (options.range != recording::TimeRange() && product == Product::kPicture) {
    throw std::invalid_argument("--from and --to are for films; a picture has --at");
  }
}

/// @param eye  camera for the name `eye`.
picture::RenderRequest RenderRequestOf(const RenderCommandOptions& options,
                                       const std::string& eye) {
  const PictureSize size = ParseSize(options.size);
  return {.camera = options.camera,
          .eye = eye,
          .width_px = size.width_px,
          .height_px = size.height_px,
          .channels = picture::ParseChannels(options.channels)};
}

recording::DemonstratorAppearance AppearanceOf(const RenderCommandOptions& options) {
  return recording::ParseDemonstratorAppearance(options.demonstrator);
}

/// Draws a moment and writes a file per channel; prints their paths.
void RenderPicture(const model::Model& model, const recording::TraceTick& moment,
                   const std::vector<Vector3>& markers, const RenderCommandOptions& options,
                   const std::string& eye, const picture::SeenDemonstrator* demonstrator) {
  const picture::RenderRequest request = RenderRequestOf(options, eye);
  picture::RecordingRenderer renderer(model, request, demonstrator);
  for (const auto& path :
       picture::WriteChannels(options.out, renderer.Take(moment, markers), request.channels)) {
    std::printf("%s\n", path.c_str());
  }
}

/// Draws a scene file in its initial state, with its robot in its initial pose.
void RenderScene(const RenderCommandOptions& options, Product product) {
  const model::Model model(scene_xml::LoadScene(options.subject, options.path.reader()),
                           PlaceRobot(options.robot, options.path));
  const std::string but = ", but '" + options.subject + "' is not one";
  if (product != Product::kPicture) throw std::invalid_argument("a film needs a recording" + but);
  if (options.at) throw std::invalid_argument("--at needs a recording" + but);
  if (AppearanceOf(options) != recording::DemonstratorAppearance::kInvisible) {
    throw std::invalid_argument("--demonstrator needs a recording" + but);
  }
  RenderPicture(model, recording::StartOf(model), {}, options, model::kEyeCamera, nullptr);
}

/// Draws a recording at the time `--at`, or at its end.
void RenderMoment(const recording::Recording& recording, const RenderCommandOptions& options) {
  const recording::TickRange whole = TicksOf(recording);
  const std::uint64_t tick = options.at ? TickAt(*options.at, whole, "at") : whole.last;
  const auto moment = MomentAt(recording, tick);
  if (!moment) throw InputError({options.subject, 0, "", "its trace contains no moment"});
  const model::Model& model = *recording.model;
  const auto demonstrator = picture::DemonstratorOf(recording, AppearanceOf(options));
  RenderPicture(model, *moment, recording::MarkerTrack(recording).At(tick), options,
                recording.info.eye_camera, demonstrator.get());
}

/// Prints each second of the recording that has been filmed, for programs that read the output.
recording::Progress PrintingProgress(recording::Progress progress) {
  return [progress = std::move(progress), next = 0.0](double done, double total) mutable {
    if (done >= next) {
      std::fprintf(stderr, "filming: %.0f of %.0f s\n", std::floor(done), std::ceil(total));
      next = std::floor(done) + 1;
    }
    return progress(done, total);
  };
}

void RenderFilm(const recording::Recording& recording, const RenderCommandOptions& options,
                Product product) {
  if (product == Product::kFilm && options.channels != "rgb") {
    // Films are compressed with loss, which would change depths and ids.
    throw std::invalid_argument(
        "a film has the channel rgb only; numbered pictures (DIR/) have all");
  }
  const picture::FilmOptions film{.request = RenderRequestOf(options, recording.info.eye_camera),
                                  .frames_per_second = options.rate,
                                  .speed = options.speed,
                                  .range = options.range,
                                  .demonstrator = AppearanceOf(options)};
  ConsoleReporter console;
  recording::Progress progress = console.callbacks().ProgressOf("filming");
  if (options.prints_progress) progress = PrintingProgress(std::move(progress));
  (product == Product::kFilm ? picture::Film : picture::FilmAsPictures)(recording, options.out,
                                                                        film, progress);
  console.Clear();
  std::printf("%s\n", options.out.c_str());
}

int Render(const RenderCommandOptions& options) {
  const Product product = ProductOf(options);
  RequireOutsideOfRecordings(options.out);
  CheckTimes(options, product);
  if (!recording::IsRecording(options.subject)) {
    RenderScene(options, product);
    return kDone;
  }
  if (options.robot != RobotOptions() || !options.path.roots.empty()) {
    throw std::invalid_argument(
        "the robot's options and --path are for scenes; a recording has its own robot and files");
  }
  const recording::Recording recording = OpenAndReport(options.subject);
  if (product == Product::kPicture) {
    RenderMoment(recording, options);
  } else {
    RenderFilm(recording, options, product);
  }
  return kDone;
}

}  // namespace

void AddRender(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<RenderCommandOptions>();
  CLI::App* render = program->add_subcommand(
      "render",
      "Render a picture of a scene or of a moment of a recording, or a film of a recording");
  render->add_option("SUBJECT", options->subject, "scene file, or directory of a recording")
      ->required();
  render
      ->add_option("--out", options->out,
                   "output: .png, .mp4, or DIR/ for a film as numbered pictures")
      ->required()
      ->check(NotEmpty());
  render->add_flag("--frames", options->as_pictures,
                   "film as numbered pictures, also if --out does not end in /");
  render->add_option("--at", options->at, "time of the picture [s] (default: the end)");
  render->add_option("--from", options->range.from,
                     "start of the film [s] (default: the start of the recording)");
  render->add_option("--to", options->range.to,
                     "end of the film [s] (default: the end of the recording)");
  std::string names;
  for (const std::string& name : picture::ViewNames()) names += name + ", ";
  render
      ->add_option(
          "--camera", options->camera,
          "camera: " + names +
              "or FROM:TO[:FOV] with points x,y,z in units and FOV in degrees; of the robot: eye, "
              "head, left_hand, right_hand; or the id of a camera of the scene")
      ->capture_default_str();
  render->add_option("--size", options->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  render
      ->add_option("--channels", options->channels,
                   "channels of numbered pictures: comma-separated list of rgb, depth and id")
      ->capture_default_str();
  AddDemonstratorOption(render, &options->demonstrator)->capture_default_str();
  render->add_option("--rate", options->rate, "frames per second of the film")
      ->capture_default_str()
      ->check(NumberBetween(0.001, 240.0));
  render->add_option("--speed", options->speed, "speed of the film; 2 is twice real time")
      ->capture_default_str()
      ->check(NumberBetween(0.01, 100.0));
  render->add_flag("--progress", options->prints_progress,
                   "print each second of the film on stderr when it is done, a line each");
  AddRobotOptions(render, /*may_be_absent=*/true, &options->robot);
  AddPathOption(render, &options->path);
  render->callback([options, answer] { *answer = Render(*options); });
}

}  // namespace smile::app
