#include "sharing/shared_recording.h"

#include <cstdint>
#include <utility>

#include "base/bytes.h"
#include "base/diagnostic.h"
#include "base/file_state.h"
#include "classic/frame_index.h"
#include "library/gzip.h"
#include "library/timeline.h"
#include "page/scene_message.h"
#include "recording/time_range.h"
#include "recording/trace_reader.h"
#include "recording/view_sample.h"
#include "sharing/pose_track.h"
#include "sim/event_words.h"
#include "texts/message_json.h"

// A page gets the recording as it is now: what was undone, the owner's notes, commands and files
// are not part of it.

namespace smile::sharing {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void FailAsTooLong(const fs::path& directory) {
  throw InputError(Diagnostic{.file = (directory / "trace.bin").string(),
                              .message = "is too long to be shared"});
}

Json GoneAt(const recording::TraceTick& moment, const model::Model& model) {
  Json gone = Json::array();
  for (const model::ObjectIndex object : model.objects()) {
    if (!moment.objects[object].is_present) gone.push_back(model.id(object));
  }
  return gone;
}

/// Goes through a trace once, and collects poses and what else changes.
class Moments {
 public:
  explicit Moments(const recording::Recording& recording)
      : recording_(recording),
        trace_(recording),
        track_((recording.directory / "trace.bin").string(), recording.info.meters_per_unit) {}

  void ReadAll() {
    while (const auto moment = trace_.Next()) Take(*moment);
  }

  const PoseTrack& track() const { return track_; }
  const Json& changes() const { return changes_; }
  /// Returns the choices at the start.
  const std::vector<int>& first_looks() const { return first_looks_; }
  std::uint64_t first_tick() const { return first_tick_; }
  std::vector<recording::TracedEvent> Events() { return trace_.Events(); }

 private:
  void Take(const recording::TraceTick& moment) {
    scene::VisualState state = recording::VisualStateAt(moment, *recording_.model);
    if (track_.num_ticks() == 0) {
      first_tick_ = moment.tick;
      first_looks_ = state.variants;
    }
    // An imported trace may lack ticks, in which nothing moves.
    while (track_.num_ticks() < moment.tick - first_tick_) track_.Add(poses_);
    track_.Add(state.poses);
    poses_ = std::move(state.poses);
    Json change = {{"tick", moment.tick - first_tick_}};
    if (Json looks = state.variants; looks != looks_) change["looks"] = looks_ = std::move(looks);
    if (Json gone = GoneAt(moment, *recording_.model); gone != gone_) {
      change["gone"] = gone_ = std::move(gone);
    }
    if (change.size() > 1) changes_.push_back(std::move(change));
    if (changes_.size() > kMaxSharedChanges) FailAsTooLong(recording_.directory);
  }

  const recording::Recording& recording_;
  recording::TraceReader trace_;
  PoseTrack track_;
  std::uint64_t first_tick_ = 0;
  std::vector<int> first_looks_;
  scene::FramePoses poses_;  ///< at the last tick
  Json looks_, gone_, changes_ = Json::array();
};

/// Returns what a page shows of an event that no action reports; nullopt for all others.
std::optional<Json> Describe(const sim::Event& event) {
  using Kind = sim::EventKind;
  Json described = {{"kind", ToString(event.kind)}};
  if (const auto words = sim::WordsOf(event)) {
    described["words"] = texts::ToJson(*words);
    return described;
  }
  if (event.kind == Kind::kControlChanged) {
    described.update({{"object", event.control}, {"state", event.state}});
    return described;
  }
  if (event.kind != Kind::kFell && event.kind != Kind::kGripperHolds &&
      event.kind != Kind::kGripperReleased) {
    return std::nullopt;
  }
  described["object"] = event.object;
  if (!event.arm.empty()) described["arm"] = event.arm;
  return described;
}

Json DescribeEvents(const recording::Recording& recording, Moments* moments) {
  Json events = Json::array();
  for (const recording::TracedEvent& traced : moments->Events()) {
    auto event = Describe(traced.event);
    if (!event || traced.tick < moments->first_tick()) continue;
    (*event)["seconds"] = recording::SecondsInto(recording, traced.tick);
    events.push_back(*std::move(event));
    if (events.size() == kMaxSharedEvents) break;
  }
  return events;
}

/// Returns the whole for a page: its description, then the poses.
std::string BytesOf(const Json& description, const PoseTrack& track) {
  ByteWriter writer;
  writer.PutString(ToText(description));
  writer.Put(static_cast<std::uint32_t>(track.num_ticks()));
  const std::span<const std::byte> head = writer.bytes();
  return std::string(reinterpret_cast<const char*>(head.data()), head.size()) + track.bytes();
}

/// Pictures of the robot's eye.
struct EyePictures {
  Json ticks = Json::array();  ///< of each, from the start
  std::vector<std::string> files;
};

EyePictures EyePicturesOf(const fs::path& directory, const Moments& moments) {
  EyePictures pictures;
  const std::uint64_t first_tick = moments.first_tick();
  const fs::path index = directory / "frames.csv";
  if (!StateOf(index).is_file) return pictures;
  for (classic::FrameEntry& frame : classic::ReadFrameIndex(index)) {
    if (frame.image.empty() || frame.tick < first_tick) continue;
    if (frame.tick - first_tick >= moments.track().num_ticks()) break;
    pictures.ticks.push_back(frame.tick - first_tick);
    pictures.files.push_back(std::move(frame.image));
  }
  return pictures;
}

}  // namespace

PageRecording ReadForPage(const fs::path& directory) {
  const recording::Recording recording = recording::OpenRecording(directory);
  Moments moments(recording);
  moments.ReadAll();
  const model::Model& model = *recording.model;
  auto meshes = std::make_unique<const page::PageMeshes>(model.visual_model());
  EyePictures eye = EyePicturesOf(directory, moments);
  const Json description = {
      {"title", recording::TitleOf(recording)},
      {"scene", page::SceneMessage(kSharedScene, model, *meshes, moments.first_looks())},
      {"segments", library::TimelineOf(recording)["segments"]},
      {"changes", moments.changes()},
      {"events", DescribeEvents(recording, &moments)},
      {"eye", std::move(eye.ticks)}};
  std::string bytes = BytesOf(description, moments.track());
  if (bytes.size() > kMaxSharedBytes) FailAsTooLong(directory);
  return {
      .bytes = std::move(bytes), .meshes = std::move(meshes), .eye_pictures = std::move(eye.files)};
}

SharedRecording::SharedRecording(const fs::path& directory) {
  PageRecording read = ReadForPage(directory);
  gzipped_ = std::make_shared<const std::string>(library::Gzipped(read.bytes));
  meshes_ = std::move(read.meshes);
  eye_pictures_ = std::move(read.eye_pictures);
}

std::optional<std::string> SharedRecording::EyePicture(std::size_t number) const {
  if (number >= eye_pictures_.size()) return std::nullopt;
  return eye_pictures_[number];
}

}  // namespace smile::sharing
