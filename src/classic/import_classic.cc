// Import in three steps: read and check everything, rehearse the playback against the scene, then
// write. A bad recording is thus rejected before the first file is made, and BeginningMark marks a
// directory whose writing was interrupted.

#include "classic/import_classic.h"

#include <map>
#include <set>
#include <stdexcept>
#include <system_error>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/wording.h"
#include "classic/internal_classic_player.h"
#include "classic/placeholder_objects.h"
#include "model/eye.h"
#include "recording/beginning.h"
#include "recording/recording.h"
#include "recording/recording_files.h"
#include "recording/trace_writer.h"

namespace smile::classic {
namespace {

/// Frame rate of the original program; its recordings do not contain it.
constexpr double kFramesPerSecond = 4;
constexpr std::uint64_t kTicksPerFrame = 15;
static_assert(kTicksPerFrame * kFramesPerSecond == sim::kTicksPerSecond);

/// Index in a scene for each object of a recording.
using Places = std::map<std::string, std::size_t>;

/// Returns the places of a recording's objects in its scene; throws InputError with all that are
/// missing.
Places PlacesIn(const scene::SceneSpec& scene, const ClassicRecording& recording,
                const std::filesystem::path& classic) {
  // All missing ids are reported together: usually it is the wrong scene, and the list shows it.
  Places in_scene, places;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) in_scene[scene.objects[i].id()] = i;
  std::string missing;
  for (const std::string& object : recording.Objects()) {
    const auto found = in_scene.find(object);
    if (found != in_scene.end()) {
      places.insert(*found);
    } else {
      missing += (missing.empty() ? "" : ", ") + object;
    }
  }
  if (missing.empty()) return places;
  throw InputError(
      {classic.string(), 0, "",
       "contains objects that the scene " + Quoted(scene.name) + " does not have: " + missing});
}

Places PlacesOfPlaceholders(const ClassicRecording& recording) {
  Places places;
  for (const std::string& object : recording.Objects()) places.insert({object, places.size()});
  return places;
}

/// Returns remarks on what placeholder objects cannot represent.
std::vector<std::string> RemarksOnPlaceholders(const ClassicRecording& recording,
                                               const scene::SceneSpec& scene) {
  // Counts controls, not lines about them: a control that changes often is still one.
  std::set<std::string> controls;
  std::size_t num_bonds = 0;
  for (const ClassicFile& segment : recording.segments) {
    for (const ClassicLine& line : segment.lines) {
      if (const auto* control = std::get_if<ClassicControl>(&line.what)) {
        controls.insert(control->control);
      } else if (const auto* action = std::get_if<ClassicAction>(&line.what)) {
        if (!action->host.empty()) ++num_bonds;
      }
    }
  }
  std::vector<std::string> remarks{
      "without its scene, every object is shown as a block; name the scene with --scene"};
  if (!controls.empty()) {
    remarks.push_back("blocks have no controls: the states of " + std::to_string(controls.size()) +
                      " appear in the texts only");
  }
  if (num_bonds > 0) {
    remarks.push_back("blocks have no bond points: " + std::to_string(num_bonds) +
                      " fasten and loosen actions appear in the texts only");
  }
  const std::vector<std::string> objects = recording.Objects();
  std::string renamed;
  std::size_t num_renamed = 0;
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::string& id = scene.objects[i].id();
    if (id != objects[i] && ++num_renamed == 1) renamed = objects[i] + " is now " + id;
  }
  if (num_renamed > 0) {
    remarks.push_back("not all ids are valid in scene files: " + std::to_string(num_renamed) +
                      " are changed, for example " + renamed);
  }
  return remarks;
}

void WriteTrace(const std::filesystem::path& path, ClassicPlayer player,
                const model::Model& model) {
  recording::TraceWriter trace(path, model);
  recording::TraceTick last;
  for (std::uint64_t frame = 0; auto next = player.Next(); ++frame) {
    // Fills the ticks between two frames with the state of the earlier one. An action is written
    // with the frame after it, although it happened before: its events go before that frame's tick.
    for (std::uint64_t tick = last.tick + 1; tick < frame * kTicksPerFrame; ++tick) {
      last.tick = tick;
      trace.Add(last);
    }
    const auto add_events = [&trace](const std::vector<sim::Event>& events) {
      for (const sim::Event& event : events) trace.Add(event);
    };
    // The state of this frame; it fills the ticks up to the next one.
    last = std::move(next->moment);
    last.tick = frame * kTicksPerFrame;
    // In the first frame, the holds precede the start and the events follow it.
    add_events(next->holds);
    if (frame > 0) add_events(next->events);
    trace.Add(last);
    if (frame == 0) add_events(next->events);
  }
}

void CopyAsItIs(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::error_code error;
  std::filesystem::copy_file(from, to, error);
  if (error) throw std::runtime_error(to.string() + ": cannot be written: " + error.message());
}

/// Copies texts and pictures unchanged and writes `frames.csv`, which the original does not have.
void CopyView(const std::filesystem::path& classic, const ClassicRecording& recording,
              const std::filesystem::path& directory) {
  std::map<std::uint64_t, std::string> image_of;
  for (std::size_t segment = 0; segment < recording.segments.size(); ++segment) {
    const std::string name = std::to_string(segment);
    CopyAsItIs(classic / (name + ".txt"), directory / (name + ".txt"));
    MakeDirectories(directory / name);
  }
  for (const ClassicPicture& picture : recording.pictures) {
    const std::string name =
        std::to_string(picture.segment) + "/" + std::to_string(picture.frame) + ".png";
    CopyAsItIs(classic / name, directory / name);
    image_of[picture.frame] = name;
  }
  recording::AppendFile index(directory / "frames.csv");
  index.Append("frame,tick,image\n");
  const std::uint64_t last_frame = recording.last_frame();
  // The original has no index: a frame exists if it lies between 0 and the last one, with or
  // without lines.
  for (std::uint64_t frame = 0; frame <= last_frame; ++frame) {
    const auto image = image_of.find(frame);
    index.Append(std::to_string(frame) + "," + std::to_string(frame * kTicksPerFrame) + "," +
                 (image != image_of.end() ? image->second : "") + "\n");
  }
}

recording::DemoInfo InfoOfImport(const ClassicRecording& recording, const model::Model& model,
                                 const ImportOptions& options) {
  recording::DemoInfo info{.scene = model.scene().name,
                           .title = options.title,
                           .notes = options.notes,
                           .meters_per_unit = model.scene().meters_per_unit,
                           .physics_version = model.scene().physics_version,
                           .origin = recording::Origin::kImported,
                           .frames_per_second = kFramesPerSecond};
  if (recording.pictures.empty()) return info;
  // The original did not record the camera; views need some eye with the size of the pictures.
  info.eye = model::EyeView(
      model, {},
      {.width_px = recording.picture_width_px, .height_px = recording.picture_height_px});
  return info;
}

/// Returns the name of a folder: `demo` for `demo`, `demo/` and, inside it, `.`.
std::string NameOfFolder(const std::filesystem::path& folder) {
  // `demo/` and `.` have no file name of their own.
  const auto path = std::filesystem::weakly_canonical(folder);
  return path.filename().string();
}

}  // namespace

ImportReport ImportClassic(const std::filesystem::path& classic,
                           const std::filesystem::path& directory, const ImportOptions& options) {
  recording::RequireNewDirectory(directory);
  const ClassicRecording recording = ReadClassic(classic);
  ImportReport report{.frames = recording.last_frame() + 1,
                      .segments = recording.segments.size(),
                      .objects = recording.Objects().size(),
                      .pictures = recording.pictures.size()};
  scene::SceneSpec scene;
  Places places;
  if (options.scene) {
    scene = *options.scene;
    places = PlacesIn(scene, recording, classic);
  } else {
    scene = MakePlaceholders(recording);
    scene.name = NameOfFolder(classic);
    places = PlacesOfPlaceholders(recording);
    report.remarks = RemarksOnPlaceholders(recording, scene);
  }
  const model::Model model(scene);
  const ClassicPlayer player(recording, model, places, options.scene.has_value());
  // Rehearses the whole recording, so that nothing is written if a line is invalid.
  for (ClassicPlayer rehearsal = player; rehearsal.Next();) continue;

  recording::BeginningMark mark(directory);
  recording::WriteWorld(directory, model);
  WriteFile(directory / "commands.jsonl", "");
  WriteTrace(directory / "trace.bin", player, model);
  CopyView(classic, recording, directory);
  // Written last: a directory with demo.json can be opened.
  WriteFile(directory / "demo.json",
            recording::ToJsonText(InfoOfImport(recording, model, options)));
  mark.Remove();
  return report;
}

}  // namespace smile::classic
