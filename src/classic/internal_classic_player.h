#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "classic/classic_reader.h"
#include "recording/trace.h"

namespace smile::classic {

/// Frame of a classic recording, reconstructed from its lines.
struct ClassicFrame {
  recording::TraceTick moment;     ///< without tick
  std::vector<sim::Event> holds;   ///< before the first frame
  std::vector<sim::Event> events;  ///< since the frame before; of the first, since then
};

/// Player of a classic recording: returns the state of a model frame by frame. State that a frame
/// does not mention is unchanged.
class ClassicPlayer {
 public:
  /// @param model       of its scene, or of placeholder objects. Must outlive this, as the
  /// recording.
  /// @param objects     for each of the recording's, its place in the scene.
  /// @param has_scene   false for placeholder objects, which have neither controls nor bond points.
  ClassicPlayer(const ClassicRecording& recording, const model::Model& model,
                std::map<std::string, std::size_t> objects, bool has_scene);

  /// Returns the next frame; nullopt after the last one.
  /// @throws InputError if a line names what the scene does not have.
  std::optional<ClassicFrame> Next();

 private:
  [[noreturn]] void Fail(const std::string& message) const;
  void Follow(const ClassicCreate& create);
  void Follow(const ClassicDelete& gone);
  void Follow(const ClassicMove& move);
  void Follow(const ClassicControl& control);
  void Follow(const ClassicControlChange& change);
  void Follow(const ClassicAction& action);
  void Follow(const ClassicEffect& effect);
  /// Returns the id in the scene, which may differ from the id in the recording.
  const std::string& NameOf(const std::string& object) const;
  model::ControlIndex FindControl(const std::string& id) const;
  void SetControl(model::ControlIndex control, const std::string& recorded);
  /// Fastens or loosens, and sets host and guest of the event.
  void FollowBond(const ClassicAction& action, sim::Event* event);
  void SetBond(model::HostIndex host, const model::HostState& bond);

  const ClassicRecording& recording_;
  const model::Model& model_;
  std::map<std::string, std::size_t> objects_;
  bool has_scene_;
  std::uint64_t last_frame_;
  std::uint64_t frame_ = 0;             ///< the next one
  std::size_t segment_ = 0, line_ = 0;  ///< the next line
  ClassicFrame now_;
};

}  // namespace smile::classic
