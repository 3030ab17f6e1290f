#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "record/append_file.h"
#include "sim/eye.h"
#include "sim/simulation.h"

namespace smile::record {

/// Writes the classic view of a recording while it happens: numbered text segments, one action in
/// each, and a picture of the robot's eye for every frame in which something moved.
///
///     0.txt  0/0.png      what is there
///     1.txt  1/4.png …    `4,grasp,AnyHand,b01`, then what moved
///
/// The layout is the original's (docs/recording-format.md); `frames.csv` is ours and tells tick and
/// picture of every frame.
class ClassicRecorder {
 public:
  /// @param eye  takes the pictures; nullptr for text only.
  ClassicRecorder(const std::filesystem::path& directory, double frames_per_second, sim::Eye* eye,
                  const sim::Simulation& simulation);

  /// A hand did something: a new segment begins. What that changed goes into it.
  void Note(const sim::Event& event, const sim::Simulation& simulation);
  /// To be called after each tick, and once at the start: writes a frame when one is due.
  void Watch(const sim::Simulation& simulation);

 private:
  struct Written {                       ///< an object's last `move` line
    Vector3 position = Vector3::Zero();  ///< [units]
    Vector3 angles_deg = Vector3::Zero();
    bool is_awake = false;
  };

  void OpenSegment();
  void WriteStart(const sim::Simulation& simulation);
  /// Opens a segment with its action, which is its first line.
  void Begin(const std::string& action, const sim::Event& event, const std::string& fields = {});
  void WriteLine(const std::string& fields);
  void WriteFrame(const sim::Simulation& simulation);
  bool WriteMove(const sim::Simulation& simulation, std::size_t object);

  std::filesystem::path directory_;
  double frames_per_second_;
  sim::Eye* eye_;
  std::uint64_t first_tick_;
  int segment_ = -1;
  std::uint64_t frame_ = 0;  ///< the next one to be written
  std::optional<AppendFile> text_;
  AppendFile index_;
  std::vector<std::optional<Written>> written_;
  bool has_news_ = false;  ///< something looks different, though nothing moved
};

}  // namespace smile::record
