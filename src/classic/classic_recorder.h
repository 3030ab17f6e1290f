#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/sharing_list.h"
#include "classic/frame_writer.h"
#include "model/eye.h"
#include "recording/append_file.h"
#include "recording/trace.h"

namespace smile::classic {

struct ClassicOptions {
  double frames_per_second = 4;  ///< at most 60
  bool has_symbols = true;       ///< false: pictures only
};

/// Writer of the classic view of a recording, during the simulation or from its trace: numbered
/// text segments, one action in each, and a picture of the robot's eye for every frame in which
/// something changed.
///
///     0.txt  0/0.png      what is there
///     1.txt  1/4.png …    `4,grasp,AnyHand,b01`, then what moved
///
/// The layout is the original's (docs/recording-format.md); `frames.csv` is an addition with tick
/// and picture of every frame.
class ClassicRecorder {
 public:
  /// @param eye       takes the pictures; nullptr for text only.
  /// @param model     of the moment's objects and robot. The eye must outlive this.
  /// @param first  its first tick.
  /// @param standing  see TraceReader::events_before_start().
  ClassicRecorder(const std::filesystem::path& directory, const ClassicOptions& options,
                  model::Eye* eye, std::shared_ptr<const model::Model> model,
                  const recording::TraceTick& first, const std::vector<sim::Event>& standing);

  /// Replaces the model for the following ticks: more objects, or fewer after their addition was
  /// undone.
  void Use(std::shared_ptr<const model::Model> model) { model_ = std::move(model); }
  /// Writes an event. An action of a hand begins a new segment.
  void Note(const sim::Event& event);
  /// Writes a frame if one is due. Its picture may be written later, see FrameWriter.
  /// @throws std::runtime_error with path and reason if an earlier one could not be written.
  void WriteFrameIfDue(const recording::TraceTick& now);
  /// Waits until all pictures are written. Throws like WriteFrameIfDue().
  void Flush() { frames_.Flush(); }

 private:
  struct Written {                       ///< an object's last `move` line
    Vector3 position = Vector3::Zero();  ///< [units]
    Vector3 angles_deg = Vector3::Zero();
    bool is_awake = false;
  };
  /// State that following lines depend on.
  struct State {
    int segment = 0;
    std::uint64_t frame = 0;  ///< next to be written
    SharingList<std::optional<Written>> written;
    std::vector<model::ObjectIndex> falling;  ///< objects on the floor that have no last line yet
    std::vector<bool> is_gone;                ///< fell: has no more lines
    bool has_news = false;                    ///< appearance changed although nothing moved
  };

 public:
  /// Position to return to.
  struct Savepoint {
    State state;
    std::uint64_t text_size = 0, index_size = 0;
  };
  Savepoint MakeSavepoint() const {
    return {state_, text_ ? text_->size() : 0, frames_.index_size()};
  }
  /// Removes everything written since the savepoint.
  void Return(const Savepoint& savepoint);

 private:
  void OpenSegment();
  void WriteCreate(model::ObjectIndex object);
  void WriteControl(model::ControlIndex control, const model::ControlState& state);
  void WriteStart(const recording::TraceTick& first, const std::vector<sim::Event>& standing);
  model::ObjectIndex IndexOf(const std::string& object) const;
  /// Returns the fields of a hand's action, without the frame: `grasp,LeftHand,b01`.
  std::string FieldsOf(const sim::Event& event) const;
  /// Returns the fields of what contact or a tool did without a command:
  /// `press,Power,left_gripper`.
  static std::string FieldsOfEffect(const sim::Event& event);
  /// Opens a segment with objects that were added or removed, one line for each.
  void BeginWithoutHand(const sim::Event& event);
  void WriteLine(const std::string& fields);
  void WriteFrame(const recording::TraceTick& now);
  /// Writes the pose of an object if it has changed; returns true if it did.
  bool WriteMove(model::ObjectIndex object, const recording::TracePose& pose, bool is_last = false);
  std::string PathOf(std::uint64_t frame) const;

  std::filesystem::path directory_;
  ClassicOptions options_;
  model::Eye* eye_;
  std::shared_ptr<const model::Model> model_;
  std::uint64_t first_tick_;
  State state_;
  std::optional<recording::AppendFile> text_;
  FrameWriter frames_;
};

}  // namespace smile::classic
