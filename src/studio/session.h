#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/json.h"
#include "image/image.h"
#include "library/displayed_state.h"
#include "page/requests.h"
#include "studio/session_options.h"

namespace smile::studio {

/// The updates of a session: all its messages except replies.
struct SessionUpdates {
  std::vector<Json> messages;  ///< for all clients, in order; see docs/studio-protocol.md
  std::optional<Image> view;   ///< the newest picture of the robot's eye
  bool is_view_recorded = false;
};

/// Session of one user, without a network: a live scene, commands by mouse and keys, recordings in
/// progress, playback of recordings, and a brain.
///
/// Belongs to one thread. Has no wall clock: its owner calls Tick() on time.
class Session {
 public:
  /// @throws InputError if the scene is invalid.
  explicit Session(SessionOptions options);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Returns the table of requests; other parts may add theirs.
  page::RequestTable& requests();
  const page::RequestTable& requests() const;
  /// Returns the requested ratio of simulated to wall-clock time, for the loop that calls Tick().
  double speed_factor() const;
  /// Sets the ratio that was achieved over the last second.
  void SetMeasuredSpeed(double factor);
  /// Advances by 1/60 s: the simulation unless it is paused, or the playback.
  /// @returns false if the world waits because a brain starts or thinks.
  bool Tick();
  /// Returns the present view.
  library::DisplayedState view() const;
  /// Returns the updates since the last call.
  SessionUpdates TakeUpdates();
  /// Returns the messages for a new client: scene, variants, output and score of brains, and
  /// last the state. The eye's picture follows with the updates.
  std::vector<Json> Everything() const;
  /// Returns the triangles of a mesh of the present scene or a recent one
  /// (docs/studio-protocol.md); nullopt if it does not exist. From any thread.
  std::optional<std::string> MeshBytes(std::uint32_t scene, std::size_t mesh) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace smile::studio
