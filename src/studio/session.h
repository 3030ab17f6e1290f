#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "image/image.h"
#include "library/view.h"
#include "page/requests.h"
#include "studio/session_options.h"

namespace smile::studio {

/// The updates of a session: all its messages except replies.
struct SessionUpdates {
  std::vector<Json> messages;  ///< for all clients, in order; see docs/studio-protocol.md
  std::optional<Image> view;   ///< the newest picture of the robot's eye
  bool is_view_recorded = false;
};

/// Session of one person, without a network: a scene come alive, what is commanded by mouse and
/// keys, a recording in the making, a recording that is shown, a brain at work.
///
/// Belongs to one thread. No wall clock: whoever owns it calls Tick() when it is time.
class Session {
 public:
  /// @throws InputError if the scene is wrong.
  explicit Session(SessionOptions options);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// All that may be asked of it; others may add what they can do.
  page::RequestTable& requests();
  const page::RequestTable& requests() const;
  /// How fast people want time to go, of real time: the loop that calls Tick() keeps to it.
  double speed_factor() const;
  /// What came of that over the last second.
  void SetMeasuredSpeed(double factor);
  /// 1/60 s goes by: of the simulation unless it is paused, or of what is shown.
  /// @returns false if the world stood still because a robot program starts or thinks.
  bool Tick();
  /// What is to be seen now.
  library::View view() const;
  /// Returns the updates since the last call.
  SessionUpdates TakeUpdates();
  /// All a new client has to know: scene, looks, what robot programs printed and achieved, and last
  /// the state. The eye's picture follows with the updates.
  std::vector<Json> Everything() const;
  /// Triangles of a mesh of the present scene or one of those shortly before, as
  /// docs/studio-protocol.md has them; nullopt if there is none. From any thread.
  std::optional<std::string> MeshBytes(std::uint32_t scene, std::size_t mesh) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace smile::studio
