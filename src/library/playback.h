#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "library/view.h"
#include "model/model.h"
#include "recording/recording.h"
#include "recording/trace.h"

namespace smile::library {

/// A recording that is shown, without physics: its trace, moment by moment. Going to any moment
/// takes a few milliseconds, however long the recording is.
///
/// Belongs to one thread. No wall clock: whoever owns it calls Tick() when it is time.
class Playback {
 public:
  static constexpr double kMaxRate = 16;

  /// Stands still at its start.
  /// @throws InputError if it cannot be read.
  Playback(std::string id, const std::filesystem::path& directory);
  ~Playback();
  Playback(const Playback&) = delete;
  Playback& operator=(const Playback&) = delete;

  const std::string& id() const;
  const recording::Recording& recording() const;
  /// Of its scene and robot: what it is that is shown.
  const model::Model& model() const;

  double seconds() const;  ///< from its start [s]
  double length() const;   ///< [s]
  double rate() const;     ///< of recorded to real time; 0: it stands still
  /// From its end, it begins anew.
  /// @throws std::invalid_argument if the rate is not within 0 and kMaxRate.
  void SetRate(double rate);
  /// To the tick nearest to that, within 0 and length().
  /// @throws std::invalid_argument if it is not a number.
  void Seek(double seconds);
  /// 1/60 s goes by; at its end it stands still.
  void Tick();

  /// What was recorded of this moment.
  const recording::TraceTick& moment() const;
  /// Ids of the objects that have come to the floor by then, also of those that are gone since. In
  /// the order in which they did; empty of recordings that do not tell.
  std::vector<std::string> fallen() const;
  /// `scene` is the caller's to fill in. Its model lasts as long as this.
  View view() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace smile::library
