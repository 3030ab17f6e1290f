#include "recorder/recording_controller.h"

#include <algorithm>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "base/diagnostic.h"
#include "model/eye.h"
#include "recorder/internal_replay_along.h"
#include "recording/recording_files.h"
#include "recording/recording_history.h"
#include "recording/recording_names.h"
#include "recording/time_range.h"
#include "texts/user_message.h"

// Starts and finishes recordings on command, and forwards the simulation's calls to the recorder.
// An error while recording (a full disk, a removed folder) ends the recording and is kept for the
// next question; the simulation continues.

namespace smile::recorder {

using texts::Say;

RecordingController::RecordingController(sim::Simulation* simulation, Options options)
    : options_(std::move(options)) {
  simulation->AddListener(this);
  simulation->SetRecordingControl(this);
}

std::optional<sim::Refusal> RecordingController::Start(const sim::Simulation& simulation,
                                                       const sim::StartRecording& start) {
  std::string name = start.name.empty() ? simulation.scene().name : start.name;
  // A scene's name need not be a valid name of a directory.
  if (start.name.empty() && !recording::IsRecordingName(name)) name = "recording";
  if (!recording::IsRecordingName(name)) return recording::FaultOfName(name);
  if (recording::IsBlank(start.title)) return recording::BlankTitle();
  RecorderOptions options = options_.recording;
  // What the command leaves open comes from the options of the program.
  if (!start.title.empty()) options.title = start.title;
  if (!start.notes.empty()) options.notes = start.notes;
  try {
    Start(recording::NewDirectory(options_.root, name), options, simulation);
  } catch (const InputError& error) {
    // A fault of the request: the simulation is not affected.
    return error.what();
  } catch (const std::exception& error) {
    failure_ = texts::UserMessage(error.what());
    return failure_;
  }
  return std::nullopt;
}

void RecordingController::Start(const std::filesystem::path& directory,
                                const RecorderOptions& options, const sim::Simulation& simulation) {
  // The failure of the recording before has been reported, or no longer matters.
  failure_.reset();
  recorder_ = std::make_unique<Recorder>(directory, options, options_.eye, simulation);
  directories_.push_back(directory);
}

void RecordingController::StartIn(const std::filesystem::path& directory,
                                  const sim::Simulation& simulation) {
  Start(directory, options_.recording, simulation);
}

void RecordingController::Continue(const std::filesystem::path& directory,
                                   const recording::HistoryPoint& from, sim::Simulation* simulation,
                                   const recording::Progress& progress) {
  recorder_ = Recorder::Continue(directory, from, options_.eye, simulation, progress);
  directories_.push_back(directory);
}

std::optional<sim::Refusal> RecordingController::Finish(const sim::Simulation&) {
  EndIfRemoved();
  Flush();
  // It ended by itself: the reason answers the command.
  if (!recorder_) return failure_;
  recorder_.reset();
  return std::nullopt;
}

/// demo.json is the last file of a new recording, so it exists as long as the directory does.
void RecordingController::EndIfRemoved() {
  const std::filesystem::path file = directories_.back() / "demo.json";
  std::error_code error;
  if (std::filesystem::exists(file, error) || error) return;
  failure_ = texts::Say("recorder.wasRemoved", {{"file", file.string()}});
  recorder_.reset();
}

template <class Part>
void RecordingController::OrRemove(const std::filesystem::path& directory, const Part& part) {
  try {
    part();
  } catch (...) {
    recorder_.reset();
    std::error_code ignored;
    std::filesystem::remove_all(directory, ignored);
    throw;
  }
}

template <class Part>
void RecordingController::Record(const Part& part) {
  if (!recorder_) return;
  try {
    // Errors of the disk end the recording, not the simulation.
    part(*recorder_);
  } catch (const std::exception& error) {
    failure_ = texts::UserMessage(error.what());
    recorder_.reset();
  }
}

void RecordingController::Correct(const recording::Recording& recording, double seconds,
                                  const std::filesystem::path& chosen, sim::Simulation* simulation,
                                  const recording::Progress& progress) {
  const std::string name = recording::RecordingNameFor(NameOf(recording) + "-corrected");
  const auto directory = chosen.empty() ? recording::NewDirectory(options_.root, name) : chosen;
  const std::uint64_t tick = recording::TickAt(seconds, recording::TicksOf(recording), "at");
  const recording::HistoryPoint until = recording::HistoryPointBefore(recording, tick);
  RecorderOptions options = options_.recording;
  options.corrects = {.recording = NameOf(recording), .seconds = SecondsInto(recording, tick)};
  options.title = CorrectedTitleOf(recording);
  recording::RequireNewDirectory(directory);
  ReplayAlong replay(recording, recording.log.PathTo(until.line), until, simulation);
  OrRemove(directory, [&] {
    replay.Go(progress, [&] { Start(directory, options, *simulation); });
    if (failure_) throw std::runtime_error(*failure_);
  });
  if (const auto* robot = simulation->robot()) {
    (void)simulation->Apply(sim::StillVelocities(robot->model()));
  }
}

void RecordingController::Flush() {
  Record([](Recorder& recorder) { recorder.Flush(); });
}

std::optional<sim::Refusal> RecordingController::Refuse(const sim::Simulation& simulation,
                                                        const sim::Command& command) {
  if (std::holds_alternative<sim::StartRecording>(command) && recorder_) {
    return Say("recorder.isRecording", {{"directory", directories_.back().string()}});
  }
  if (std::holds_alternative<sim::FinishRecording>(command) && !recorder_) {
    return Say("recorder.isIdle");
  }
  // A recording has its own reasons to refuse; without one, only the camera matters.
  if (recorder_) return recorder_->Refuse(simulation, command);
  const auto* load = std::get_if<sim::Load>(&command);
  return load != nullptr ? RefuseWithoutCamera(simulation, *load) : std::nullopt;
}

std::optional<sim::Refusal> RecordingController::RefuseWithoutCamera(
    const sim::Simulation& simulation, const sim::Load& load) const {
  if (options_.eye == nullptr) return std::nullopt;
  const std::string& camera = options_.eye->spec().camera;
  // Cameras of the robot and the fixed eye exist in every scene.
  if (!model::IsSceneCamera(simulation.model(), camera)) return std::nullopt;
  const auto& cameras = load.scene->cameras;
  if (std::ranges::find(cameras, camera, &scene::CameraSpec::id) != cameras.end()) {
    return std::nullopt;
  }
  return Say("recorder.lacksCamera", {{"camera", camera}});
}

void RecordingController::OnCommand(const sim::Simulation& simulation,
                                    const sim::Command& command) {
  Record([&](Recorder& recorder) { recorder.OnCommand(simulation, command); });
}

void RecordingController::OnEvent(const sim::Simulation& simulation, const sim::Event& event) {
  Record([&](Recorder& recorder) { recorder.OnEvent(simulation, event); });
}

void RecordingController::OnMove(const sim::Simulation& simulation, sim::ActionId from,
                                 sim::ActionId to) {
  Record([&](Recorder& recorder) { recorder.OnMove(simulation, from, to); });
}

void RecordingController::OnTick(const sim::Simulation& simulation) {
  // Once a second is often enough, and costs little.
  if (recorder_ && simulation.tick() % sim::kTicksPerSecond == 0) EndIfRemoved();
  Record([&](Recorder& recorder) { recorder.OnTick(simulation); });
}

}  // namespace smile::recorder
