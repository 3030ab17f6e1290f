#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "library/displayed_state.h"
#include "model/model.h"
#include "recording/recording.h"
#include "recording/trace.h"

namespace smile::library {

/// Playback: shows a recording tick by tick from its trace, without physics. Seeking takes a few
/// milliseconds, independent of the length of the recording.
///
/// Belongs to one thread. Uses no wall clock: the owner calls Tick().
class Playback {
 public:
  static constexpr double kMaxRate = 16;

  /// Opens a recording, paused at its start.
  /// @throws InputError if it cannot be read.
  Playback(std::string id, const std::filesystem::path& directory);
  ~Playback();
  Playback(const Playback&) = delete;
  Playback& operator=(const Playback&) = delete;

  const std::string& id() const;
  const recording::Recording& recording() const;
  /// Returns the model of its scene and robot.
  const model::Model& model() const;

  double seconds() const;  ///< from its start [s]
  double length() const;   ///< [s]
  double rate() const;     ///< of recorded to wall-clock time; 0: paused
  /// Sets the rate; continues from the start if the recording is at its end.
  /// @throws std::invalid_argument if the rate is not within 0 and kMaxRate; std::runtime_error
  ///         with the reason if playing has ended because the recording could not be read.
  void SetRate(double rate);
  /// Seeks the tick nearest to `seconds`, within 0 and length().
  /// @throws std::invalid_argument if it is not a number; InputError if the recording cannot be
  ///         read there.
  void Seek(double seconds);
  /// Advances by 1/60 s of wall-clock time; pauses at the end, and where the recording cannot be
  /// read.
  void Tick();

  /// Returns the recorded tick that is shown.
  const recording::TraceTick& moment() const;
  /// Returns the ids of the objects that have fallen to the floor so far, in order, including those
  /// that are gone since; empty if the recording does not contain them.
  std::vector<std::string> fallen() const;
  /// Returns the view, whose `scene` the caller sets. Its model is valid as long as this object.
  DisplayedState view() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace smile::library
