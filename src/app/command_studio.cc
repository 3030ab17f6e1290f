// `smile studio`: a page in the browser for demonstrating.

#include <spawn.h>
#include <sys/wait.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/exit_code.h"
#include "app/imitate_arguments.h"
#include "app/interrupt.h"
#include "app/options.h"
#include "base/files.h"
#include "picture/rendered_eye.h"
#include "studio/studio.h"
#include "study/participant_requests.h"

extern char** environ;

namespace smile::app {
namespace {

struct StudioCommand {
  std::string scene, recordings = "recordings", address = "127.0.0.1";
  std::vector<std::string> brains;
  std::string tls_certificate, tls_key;
  int port = 0;
  double rate = 4;
  bool no_open = false, no_pictures = false, is_participant = false;
  EyeOptions eye;
  RobotOptions robot;
  PathOptions path;
};

/// Returns the folder of the built page.
/// @throws std::runtime_error if it has not been built.
std::filesystem::path PageFolder() {
  try {
    return DataFile("build/page");
  } catch (const std::runtime_error&) {
    throw std::runtime_error("the studio's page is not built; run ./run studio to build it");
  }
}

/// Opens the link in the user's browser, if there is a screen. A shell starts it in the background,
/// so that it is not a child of this process.
void OpenInBrowser(const std::string& link) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr) return;
  std::string shell = "sh", option = "-c", line = "xdg-open \"$0\" >/dev/null 2>&1 &", page = link;
  char* const arguments[] = {shell.data(), option.data(), line.data(), page.data(), nullptr};
  pid_t child = 0;
  if (posix_spawnp(&child, "sh", nullptr, nullptr, arguments, environ) == 0)
    waitpid(child, nullptr, 0);
}

/// Returns how the page generates and exports: by this program, with the same robot.
datasets::DatasetOptions DatasetOptionsOf(const StudioCommand& options) {
  return {.program = std::filesystem::read_symlink("/proc/self/exe"),
          .robot_arguments = ArgumentsOf({.robot = options.robot, .path = options.path}, "", "")};
}

int RunStudio(const StudioCommand& options) {
  picture::RenderedEye eye(EyeSpecOf(options.eye));
  studio::StudioOptions plan{.datasets = DatasetOptionsOf(options)};
  plan.session = {.scene = options.scene.empty() ? DataFile("scenes/tower.xml")
                                                 : std::filesystem::path(options.scene),
                  .reader = options.path.reader(),
                  .robot = PlaceRobot(options.robot, options.path, "parked"),  // clears its view
                  .recordings = options.recordings,
                  .recording = {.frames_per_second = options.rate},
                  .eye = options.no_pictures ? nullptr : &eye,
                  .brains = {options.brains.begin(), options.brains.end()}};
  if (options.is_participant) plan.refuse = &study::RefuseToParticipant;
  plan.server = {.address = options.address, .port = options.port, .page = PageFolder()};
  if (!options.tls_certificate.empty()) {
    plan.server.tls =
        web_server::TlsFiles{.certificate = options.tls_certificate, .key = options.tls_key};
  }
  studio::Studio studio(std::move(plan));
  std::printf("%s\n", studio.link().c_str());
  // stdout is buffered if it is a pipe, and would stay so until the studio ends.
  std::fflush(stdout);
  std::fprintf(stderr, "smile: the studio is open at this link; Ctrl-C closes it\n");
  if (!options.no_open) OpenInBrowser(studio.link());
  studio.Run(&IsInterrupted);
  return kDone;
}

}  // namespace

void AddStudio(CLI::App* program, ExitAnswer answer) {
  auto options = std::make_shared<StudioCommand>();
  CLI::App* studio = program->add_subcommand(
      "studio", "Open the studio in a browser: demonstrate, edit and watch");
  studio->add_option("SCENE", options->scene, "scene file (default: the shipped tower.xml)")
      ->check(NotEmpty());
  studio
      ->add_option("--port", options->port,
                   "port of the page; 0 for the first free port from 8470 on")
      ->capture_default_str()
      ->check(CLI::Range(0, 65535));
  studio
      ->add_option("--listen", options->address,
                   "address on which other machines can connect, with the token of the printed "
                   "link; 0.0.0.0 for all addresses of this machine")
      ->capture_default_str()
      ->check(NotEmpty());
  CLI::Option* certificate =
      studio
          ->add_option("--tls-cert", options->tls_certificate,
                       "certificate chain in PEM format; the page is served at https:// only")
          ->check(CLI::ExistingFile);
  CLI::Option* key = studio
                         ->add_option("--tls-key", options->tls_key,
                                      "key of the certificate in PEM format, without a password")
                         ->check(CLI::ExistingFile)
                         ->needs(certificate);
  certificate->needs(key);
  studio->add_flag("--no-open", options->no_open, "do not open the browser");
  studio->add_option("--recordings", options->recordings, "folder of the recordings")
      ->capture_default_str()
      ->check(NotEmpty());
  Repeatable(studio->add_option(
                 "--brains", options->brains,
                 "folder with your own brains, listed before the shipped ones; may be repeated"))
      ->check(CLI::ExistingDirectory);
  studio->add_flag("--no-pictures", options->no_pictures,
                   "recordings without the robot's pictures; no view of the robot's eye");
  studio->add_flag("--participant", options->is_participant,
                   "allow only what a participant of a study may do: demonstrate");
  studio->add_option("--rate", options->rate, "pictures per second of recordings")
      ->capture_default_str()
      ->check(NumberBetween(0.001, sim::kTicksPerSecond));
  AddEyeOptions(studio, &options->eye);
  AddRobotOptions(studio, /*may_be_absent=*/true, &options->robot);
  AddPathOption(studio, &options->path);
  studio->callback([options, answer] { *answer = RunStudio(*options); });
}

}  // namespace smile::app
