// A preview simulates anyway, so it keeps what it simulated: Save() then only draws pictures. Valid
// only if neither the edits nor any file of the recording changed since; file states (inode, size,
// time) are compared, which is cheap for large recordings.

#include "editing/edit_previews.h"

#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include "base/file_state.h"
#include "base/temporary_directory.h"
#include "classic/redraw.h"
#include "editing/edit_json.h"
#include "recording/segment_files.h"
#include "recording/view_sample.h"

namespace smile::editing {
namespace {

namespace fs = std::filesystem;

/// State of each file in a directory and below, by relative path.
using FileStates = std::map<fs::path, FileState>;

/// Returns the states of all files; nullopt if changes could go unnoticed: a file is a link, or
/// cannot be inspected.
std::optional<FileStates> StatesOfFilesIn(const fs::path& directory) {
  FileStates states;
  std::error_code error;
  for (fs::recursive_directory_iterator entry(directory, error), end; !error && entry != end;
       entry.increment(error)) {
    // The target of a link may change without a trace in this directory.
    if (entry->is_symlink()) return std::nullopt;
    const FileState state = StateOf(entry->path());
    if (!state.is_directory) states[entry->path().lexically_relative(directory)] = state;
  }
  if (error) return std::nullopt;
  return states;
}

/// Eye for the simulation of a preview: returns pictures of one pixel, so that the recorder runs
/// the same code without rendering.
class PlaceholderEye : public sim::Eye {
 public:
  explicit PlaceholderEye(const sim::EyeSpec& spec) : spec_(spec) {}

  const Image& Draw(const scene::VisualModel&, const sim::ViewSample&) override { return pixel_; }
  const sim::EyeSpec& spec() const override { return spec_; }

 private:
  sim::EyeSpec spec_;
  Image pixel_{.width_px = 1, .height_px = 1, .color = {0, 0, 0}};
};

/// Makes a recording whose index lists its pictures, but whose folders are empty: saving fills
/// them.
EditReport MakePreview(const recording::Recording& recording,
                       const recording::Demonstration& edited, const fs::path& directory,
                       const recording::Progress& progress) {
  const auto spec = EyeOf(recording.info);
  if (!spec) return MakeEdited(recording, edited, {.directory = directory}, progress);
  PlaceholderEye eye(*spec);
  EditReport report =
      MakeEdited(recording, edited, {.directory = directory, .eye = &eye}, progress);
  for (int segment = 0; fs::is_directory(recording::SegmentPictures(directory, segment));
       ++segment) {
    const fs::path pictures = recording::SegmentPictures(directory, segment);
    // Redraw() writes each picture again; those of one pixel would only be in its way.
    fs::remove_all(pictures);
    fs::create_directory(pictures);
  }
  return report;
}

}  // namespace

/// Preview: a recording as it will be saved, except for its pictures.
struct EditPreviews::Kept {
  EditRequest request;
  FileStates source;  ///< the files of the edited recording
  EditReport report;
  std::chrono::steady_clock::time_point made;
  TemporaryDirectory folder;

  fs::path directory() const { return folder.path() / "edited"; }
};

EditPreviews::EditPreviews(MakeEye make_eye) : make_eye_(std::move(make_eye)) {}
EditPreviews::~EditPreviews() = default;

EditReport EditPreviews::Preview(const EditRequest& request, const recording::Progress& progress) {
  // The former preview goes first: two would need twice the space, and only the newest is kept.
  RemoveOlderThan({});
  // Before anything is read, so that later changes are noticed.
  auto source = StatesOfFilesIn(request.recording);
  const recording::Recording recording = recording::OpenRecording(request.recording);
  // Invalid edits throw here, before anything is simulated.
  const auto edited = EditedByAll(DemonstrationOf(recording), request.edits);
  bool should_continue = true;
  const recording::Progress watch = [&](double done, double total) {
    should_continue = !progress || progress(done, total);
    return should_continue;
  };
  if (source) {
    try {
      auto kept = std::make_shared<Kept>();
      kept->report = MakePreview(recording, edited, kept->directory(), watch);
      kept->request = request;
      kept->source = *std::move(source);
      kept->made = std::chrono::steady_clock::now();
      const std::lock_guard lock(mutex_);
      kept_ = kept;
      return kept->report;
    } catch (const std::runtime_error&) {
      if (!should_continue) throw;
      // The preview could not be written, for example because the disk is full: simulates without
      // output. All other errors recur there.
    }
  }
  EditReport report = ReSimulate(recording, edited, std::nullopt, watch);
  if (!should_continue) throw std::runtime_error("interrupted");
  return report;
}

std::shared_ptr<const EditPreviews::Kept> EditPreviews::Find(const EditRequest& request) const {
  std::shared_ptr<const Kept> kept;
  {
    const std::lock_guard lock(mutex_);
    kept = kept_;
  }
  // The temporary directory may have been deleted in the meantime.
  const bool is_usable = kept && kept->request == request &&
                         StatesOfFilesIn(request.recording) == kept->source &&
                         recording::IsRecording(kept->directory());
  return is_usable ? kept : nullptr;
}

EditReport EditPreviews::Save(const EditRequest& request, const fs::path& directory,
                              const recording::Progress& progress) {
  // A shared pointer: a new Preview() may replace it meanwhile, but the folder stays until the copy
  // is done.
  const auto kept = Find(request);
  const recording::Recording recording =
      recording::OpenRecording(kept ? kept->directory() : request.recording);
  // With a preview, only the pictures are missing; otherwise everything is simulated.
  std::unique_ptr<sim::Eye> eye;
  if (const auto spec = EyeOf(recording.info)) eye = make_eye_(*spec);
  if (!kept) {
    const auto edited = EditedByAll(DemonstrationOf(recording), request.edits);
    return MakeEdited(recording, edited, {.directory = directory, .eye = eye.get()}, progress);
  }
  classic::DrawMoment draw;
  if (eye) {
    draw = [&](const recording::TraceTick& moment) -> const Image& {
      const model::Model& model = *recording.model;
      return eye->Draw(model.visual_model(), ViewSampleAt(moment, model, eye->spec()));
    };
  }
  classic::Redraw(recording, directory, {.has_symbols = recording.info.has_symbols}, draw,
                  progress);
  recording::WriteConflicts(directory, kept->report.conflicts);
  const std::lock_guard lock(mutex_);
  // Unless another thread has made a newer preview.
  if (kept_ == kept) kept_.reset();
  return kept->report;
}

void EditPreviews::RemoveOlderThan(std::chrono::steady_clock::duration age) {
  std::shared_ptr<const Kept> old;
  const std::lock_guard lock(mutex_);
  const bool is_old = kept_ && std::chrono::steady_clock::now() - kept_->made >= age;
  // Declared before the lock, `old` is destroyed after it is released: deleting files takes time.
  if (is_old) old = std::exchange(kept_, nullptr);
}

}  // namespace smile::editing
