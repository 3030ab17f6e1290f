#include "experiment/rerender.h"

#include "base/files.h"
#include "experiment/move_aside.h"
#include "picture/recording_renderer.h"
#include "recording/view_sample.h"

namespace smile::experiment {
namespace {

constexpr std::size_t kMaxMarkBytes = 1 << 20;

/// Returns the request for pictures like those of the recording's eye.
picture::RenderRequest RenderRequestOf(const model::EyeSpec& eye) {
  return {.camera = model::kEyeCamera,
          .eye = eye.camera,
          .width_px = eye.width_px,
          .height_px = eye.height_px};
}

/// True if the mark of a copy has this text: the copy is complete and up to date.
bool IsMarked(const std::filesystem::path& mark, const std::string& text) {
  std::error_code error;
  return std::filesystem::exists(mark, error) && ReadFile(mark, kMaxMarkBytes) == text;
}

}  // namespace

std::size_t Rerender(const recording::Recording& recording, const std::filesystem::path& out,
                     const classic::RedrawOptions& copy, const Callbacks& callbacks) {
  const model::Model& model = *recording.model;
  // nullptr without a demonstrator in the pictures.
  const auto demonstrator = picture::DemonstratorOf(recording, copy.demonstrator);
  picture::RecordingRenderer renderer(
      model, RenderRequestOf(EyeOf(recording.info).value_or(model::EyeSpec())), demonstrator.get());
  return Redraw(
      recording, out, copy,
      [&renderer](const recording::TraceTick& moment) -> const Image& {
        return renderer.Take(moment);
      },
      callbacks.ProgressOf("drawing"));
}

std::vector<std::filesystem::path> MakeCopies(const DemonstratorCopies& copies,
                                              const std::filesystem::path& folder,
                                              const Callbacks& callbacks) {
  MakeDirectories(folder);
  const std::string text = ToText(copies.depends_on, 2) + "\n";
  std::vector<std::filesystem::path> paths;
  for (const std::string& appearance : copies.demonstrators) {
    const std::filesystem::path copy = folder / appearance, mark = folder / (appearance + ".json");
    std::error_code error;
    const bool exists = std::filesystem::exists(copy, error);
    if (!exists || !IsMarked(mark, text)) {
      // A copy without a mark was interrupted, or is of another recording: either way it may be
      // worth keeping.
      if (exists) MoveAside(copy, callbacks);
      Rerender(recording::OpenRecording(copies.demonstration), copy,
               {.demonstrator = recording::ParseDemonstratorAppearance(appearance),
                .has_symbols = copies.has_symbols},
               callbacks);
      // Written after the copy, so that a partial copy has no mark.
      WriteFile(mark, text);
    }
    paths.push_back(copy);
  }
  return paths;
}

}  // namespace smile::experiment
