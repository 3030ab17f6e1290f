#include "page/internal_pose_broadcaster.h"

#include <algorithm>
#include <limits>

// Each frame has the version at which it last changed. A client's message is the set of frames that
// changed after the version that it knows, so no history of messages is needed, and a client that
// skipped a hundred of them still receives each frame at most once.

namespace smile::page {
namespace {

constexpr std::size_t kValuesPerFrame = 7;

}  // namespace

void PoseBroadcaster::Update(const Poses& poses) {
  // A partial update before the first key could contain frames whose other values are unknown.
  // Changes make sense only relative to a key of the same scene.
  if (!poses.is_key && (version_ == 0 || poses.scene != scene_)) return;
  scene_ = poses.scene;
  tick_ = poses.tick;
  // The tick alone is no new version; it travels with the next change or acknowledgment.
  if (poses.frames.empty() && !poses.is_key) return;
  ++version_;
  cached_ = {};
  if (poses.is_key) {
    key_ = version_;
    // Frame numbers count from 0; the largest one determines the size.
    const std::size_t num_frames =
        poses.frames.empty() ? 0 : std::size_t{1} + *std::ranges::max_element(poses.frames);
    values_.assign(kValuesPerFrame * num_frames, 0);
    changed_.assign(num_frames, 0);
  }
  for (std::size_t k = 0; k < poses.frames.size(); ++k) {
    const std::size_t frame = poses.frames[k];
    // A frame that the key did not announce is not drawn by any page.
    if (frame >= changed_.size()) continue;
    changed_[frame] = version_;
    std::copy_n(&poses.values[k * kValuesPerFrame], kValuesPerFrame,
                &values_[frame * kValuesPerFrame]);
  }
}

PoseBroadcaster::Change PoseBroadcaster::Since(Version known) {
  // Most clients know the same version, so the bytes are shared.
  if (cached_.bytes && cached_for_ == known) return cached_;
  auto bytes = std::make_shared<std::string>();
  Change change{.is_key = known < key_};
  // The count in the header has 16 bits.
  const std::size_t most = std::numeric_limits<std::uint16_t>::max();
  for (std::uint32_t frame = 0; frame < changed_.size() && change.count < most; ++frame) {
    // A key need not contain every frame.
    if (change.is_key ? changed_[frame] == 0 : changed_[frame] <= known) continue;
    // A record of 32 bytes: the frame's number (u32), then seven floats in the order of
    // Poses::values, in the byte order of the machine, which is little-endian on all supported
    // ones.
    bytes->append(reinterpret_cast<const char*>(&frame), sizeof frame);
    bytes->append(reinterpret_cast<const char*>(&values_[frame * kValuesPerFrame]),
                  kValuesPerFrame * sizeof(float));
    ++change.count;
  }
  change.bytes = std::move(bytes);
  cached_for_ = known;
  return cached_ = change;
}

}  // namespace smile::page
