#include "app/dress.h"

#include "app/interrupt.h"
#include "app/move_aside.h"
#include "app/open_recording.h"
#include "app/progress.h"
#include "base/diagnostic.h"
#include "base/files.h"
#include "picture/photographer.h"
#include "record/sight.h"

namespace smile::app {
namespace {

constexpr std::size_t kMaxMarkBytes = 1 << 20;

/// What draws the pictures of a recording again.
picture::Shot ShotOf(const model::EyeSpec& eye) {
  return {.camera = model::kEyeCamera,
          .eye = eye.camera,
          .width_px = eye.width_px,
          .height_px = eye.height_px};
}

/// Whether a copy is there that was made of the same.
bool IsMarked(const std::filesystem::path& mark, const std::string& text) {
  std::error_code error;
  return std::filesystem::exists(mark, error) && ReadFile(mark, kMaxMarkBytes) == text;
}

}  // namespace

std::size_t Dress(const record::Recording& recording, const std::filesystem::path& out,
                  const record::RedrawOptions& copy) {
  const model::Model model(recording.scene, recording.robot);
  const auto demonstrator = picture::DemonstratorOf(recording, model, copy.demonstrator);
  picture::Photographer photographer(
      model, ShotOf(EyeOf(recording.info).value_or(model::EyeSpec())), demonstrator.get());
  ProgressLine line("drawing");
  return Redraw(
      recording, out, copy,
      [&photographer](const record::TraceTick& moment) -> const Image& {
        return photographer.Take(moment);
      },
      [&line](double done, double total) {
        line.Show(done, total);
        return !IsInterrupted();
      });
}

std::vector<std::filesystem::path> DressAll(const std::string& demo,
                                            const std::vector<std::string>& looks, bool has_symbols,
                                            const std::filesystem::path& folder,
                                            const Json& depends_on) {
  MakeDirectories(folder);
  std::vector<std::filesystem::path> copies;
  for (const std::string& look : looks) {
    const std::filesystem::path copy = folder / look, mark = folder / (look + ".json");
    const std::string text = ToText(depends_on, 2) + "\n";
    std::error_code error;
    const bool is_there = std::filesystem::exists(copy, error);
    if (!is_there || !IsMarked(mark, text)) {
      if (is_there) MoveAside(copy);
      Dress(record::OpenRecording(demo), copy,
            {.demonstrator = record::ParseDemonstratorLook(look), .has_symbols = has_symbols});
      WriteFile(mark, text);
    }
    copies.push_back(copy);
  }
  return copies;
}

}  // namespace smile::app
