#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "record/recording.h"
#include "studio/stage.h"

namespace smile::studio {

/// A recording that is shown, without physics: its trace, moment by moment.
class Playback {
 public:
  /// @throws InputError if it cannot be read.
  Playback(std::string id, const std::filesystem::path& directory);
  ~Playback();

  const std::string& id() const;
  const record::Recording& recording() const;
  double seconds() const;  ///< from its start [s]
  double length() const;   ///< [s]
  double rate() const;     ///< of recorded to real time; 0: it stands still
  void SetRate(double rate);
  /// Within 0 and length().
  void Seek(double seconds);
  /// 1/60 s goes by; at its end it stands still.
  void Tick();
  /// `scene` is the caller's to fill in.
  View view() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace smile::studio
