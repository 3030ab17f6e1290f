#include "experiment/demonstration_frames.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/diagnostic.h"
#include "classic/frame_index.h"
#include "image/png.h"
#include "recording/trace_reader.h"
#include "recording/view_sample.h"

namespace smile::experiment {
namespace {

std::string SizeText(int width_px, int height_px) {
  return std::to_string(width_px) + "x" + std::to_string(height_px);
}

/// Reads the frames of a demonstration: recorded pictures if there are any, otherwise pictures
/// drawn from the trace by an eye.
class FrameReader {
 public:
  FrameReader(const std::filesystem::path& demonstration, sim::Eye* eye)
      : recording_(recording::OpenRecording(demonstration)),
        eye_(eye),
        csv_(demonstration / "frames.csv"),
        frames_(classic::ReadFrameIndex(csv_)),
        trace_(recording_) {
    const auto has_image = [](const classic::FrameEntry& frame) { return !frame.image.empty(); };
    const auto first = std::find_if(frames_.begin(), frames_.end(), has_image);
    // Without the eye's description, pictures could not be interpreted: their pose and focal length
    // are part of each frame.
    const std::optional<model::EyeSpec> spec = EyeOf(recording_.info);
    has_pictures_ = spec && first != frames_.end();
    // Frames before the first picture cannot be shown. Later frames without a picture repeat the
    // one before.
    if (has_pictures_) frames_.erase(frames_.begin(), first);
    if (!has_pictures_ && eye_ == nullptr) {
      throw InputError(
          {demonstration.string(), 0, "", "has no pictures, and no eye to render them is given"});
    }
    spec_ = spec ? *spec : eye_->spec();
  }

  std::optional<brain::DemonstrationFrame> Next() {
    if (next_ == frames_.size()) return std::nullopt;
    const classic::FrameEntry& frame = frames_[next_++];
    // Read for each frame, also for pictures from files: the pose of the eye depends on the robot's
    // joints.
    const recording::TraceTick moment = ReadMomentOf(frame, csv_, &trace_);
    if (!has_pictures_) {
      Draw(moment);
    } else if (!frame.image.empty()) {
      Read(recording_.directory / frame.image);
    }
    return brain::DemonstrationFrame{.tick = frame.tick - frames_.front().tick,
                                     .view = EyeView(*recording_.model, moment.joints, spec_),
                                     .image = image_};
  }

 private:
  void Draw(const recording::TraceTick& moment) {
    const Image& drawn = eye_->Draw(recording_.model->visual_model(),
                                    recording::ViewSampleAt(moment, *recording_.model, spec_));
    // Only color: a demonstration that was filmed has no depth either.
    image_ = {.width_px = drawn.width_px, .height_px = drawn.height_px, .color = drawn.color};
  }

  void Read(const std::filesystem::path& png) {
    image_ = ReadPng(png);
    if (image_.width_px == spec_.width_px && image_.height_px == spec_.height_px) return;
    throw InputError({png.string(), 0, "",
                      "is " + SizeText(image_.width_px, image_.height_px) + ", expected " +
                          SizeText(spec_.width_px, spec_.height_px) + " as in demo.json"});
  }

  recording::Recording recording_;
  sim::Eye* eye_;
  std::filesystem::path csv_;
  std::vector<classic::FrameEntry> frames_;
  recording::TraceReader trace_;
  bool has_pictures_ = false;
  model::EyeSpec spec_;  ///< of the eye that saw the demonstration
  std::size_t next_ = 0;
  Image image_;  ///< of the frame returned last
};

}  // namespace

brain::DemonstrationFrames FramesOf(std::filesystem::path demonstration, sim::Eye* eye) {
  // Shared, since a std::function must be copyable. Opened on first use, as many brains do not
  // watch.
  return [demonstration = std::move(demonstration), eye,
          reader = std::shared_ptr<FrameReader>()]() mutable {
    if (!reader) reader = std::make_shared<FrameReader>(demonstration, eye);
    return reader->Next();
  };
}

}  // namespace smile::experiment
