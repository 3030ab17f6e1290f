#include "app/photographer.h"

#include <stdexcept>

#include "app/viewpoint.h"
#include "base/wording.h"
#include "record/png.h"
#include "record/sight.h"

namespace smile::app {
namespace {

/// `out/um.png` and "depth" make `out/um.depth.png`.
std::filesystem::path WithTag(std::filesystem::path path, const std::string& tag) {
  return path.replace_extension("." + tag + path.extension().string());
}

}  // namespace

Channels ParseChannels(const std::string& text) {
  Channels channels{.rgb = false};
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
      throw std::invalid_argument("channel is " + Quoted(name) + ", expected rgb, depth or id");
    }
    start = end + 1;
  }
  return channels;
}

Photographer::Photographer(const sim::Simulation& stage, Shot shot)
    : stage_(stage),
      shot_(std::move(shot)),
      fixed_view_(FindView(shot_.camera, stage.scene(), shot_.size)) {}

const Image& Photographer::Take(const record::TraceTick& moment) {
  sim::Sight sight = record::SightAt(moment, stage_, shot_.size);
  if (fixed_view_) {
    sight.view = *fixed_view_;
    // Only the eye does not see the head it sits in.
    if (moment.is_robot_shown) sight.hidden_frames.clear();
  }
  renderer_.Render(stage_.visual_model(), sight.state, sight.view,
                   {.color = shot_.channels.rgb,
                    .depth = shot_.channels.depth,
                    .ids = shot_.channels.id,
                    .look = fixed_view_ ? camera::Look::kPresentation : camera::Look::kRobotEye,
                    .excluded_frames = sight.hidden_frames},
                   &image_);
  return image_;
}

std::vector<std::filesystem::path> WriteChannels(const std::filesystem::path& png,
                                                 const Image& image, const Channels& channels) {
  std::vector<std::filesystem::path> written;
  const auto write = [&](auto writer, const std::filesystem::path& path) {
    writer(path, image);
    written.push_back(path);
  };
  if (channels.rgb) write(&record::WritePng, png);
  if (channels.depth) write(&record::WriteDepthPng, WithTag(png, "depth"));
  if (channels.id) write(&record::WriteIdPng, WithTag(png, "id"));
  return written;
}

}  // namespace smile::app
