#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "recording/recording.h"
#include "recording/trace.h"

namespace smile::recording {

/// Limits on values in a trace: those that objects, controls and bonds of a scene can have.
struct TraceLimits {
  std::vector<int> num_states;      ///< for each control
  std::vector<int> max_tightness;   ///< for each host point
  std::vector<TraceCounts> counts;  ///< that the scene had when its last objects were not yet
                                    ///< added: by the number of objects
  std::size_t num_guests = 0;

  explicit TraceLimits(const scene::SceneSpec& scene);
  bool Allow(model::ControlIndex control, const model::ControlState& state) const;
  bool Allow(model::HostIndex host, const model::HostState& bond) const;
  bool Allow(const TraceCounts& found) const;
};

/// Reads a trace, tick by tick, along one path through its returns. A file cut in the middle of a
/// record ends with the last whole one.
///
/// Each tick has all objects of the scene at the end of the path. Those that were not yet added are
/// absent, as those that are gone.
class TraceReader {
 private:
  /// Records that follow one another in the file without a return.
  struct BranchSegment {
    TracePlace begin = 0, end = 0;
    TracePlace past = 0;     ///< end of the records that precede it on its path
    std::uint64_t tick = 0;  ///< at its begin
    std::size_t log_line = 0;
  };

 public:
  /// Reads the path to the recording's end.
  /// @throws InputError if this is not a trace of a known format version, or not one of the
  ///         recording's objects and robot, or damaged.
  explicit TraceReader(const Recording& recording);
  /// Reads the path to a place between two records, where the scene is that of `recording`.
  TraceReader(const Recording& recording, TracePlace end);
  /// Reads the path to a point of the recording's history, with the scene at that point; ends
  /// earlier if the trace does not reach that point.
  TraceReader(const Recording& recording, const HistoryPoint& point);

  const std::vector<std::string>& object_names() const { return object_names_; }
  const std::vector<std::string>& joint_names() const { return joint_names_; }
  /// Returns the events before the recording's start that still matter: falls to the floor, grasps
  /// of objects still held, and attention to properties of objects.
  const std::vector<sim::Event>& events_before_start() const { return events_before_start_; }

  /// Returns false for traces of old versions, which contain no events.
  bool has_events() const { return version_ >= 3; }

  /// Returns the next tick; nullopt after the last one.
  /// @throws InputError if a record contradicts the header or the record before it.
  std::optional<TraceTick> Next();
  /// Returns the places after the last tick: first before all of its events, then after each.
  const std::vector<TracePlace>& places() const { return places_; }

  /// Tick that was read, to which the reader can return.
  class Bookmark {
   public:
    const TraceTick& moment() const { return moment_; }

   private:
    friend class TraceReader;
    TraceTick moment_;
    std::vector<TracePlace> places_;
    TracePlace place_ = 0;
    TraceCounts counts_;
    std::size_t num_segments_left_ = 0;
  };
  /// Returns a bookmark of the last tick.
  Bookmark MakeBookmark() const;
  /// Makes Next() continue after a tick that this reader marked.
  void ReturnTo(const Bookmark& bookmark);

  /// Returns true if the file ends with an incomplete record: the recording was interrupted.
  bool is_cut() const { return size_ < bytes_.size(); }
  /// Returns the size of the complete records and the header [bytes].
  TracePlace size() const { return size_; }
  /// Returns the line of the log of the last return; 0 if there is none.
  std::size_t last_return() const { return segments_.back().log_line; }

 private:
  /// Tag of the constructor that does not yet select a path.
  struct Unopened {};
  TraceReader(const Recording& recording, const scene::SceneSpec& scene, Unopened);
  void ReadHeader(const Recording& recording, const scene::SceneSpec& scene);
  /// Finds the segments and the end of the last complete record.
  void Survey();
  void FindPathTo(TracePlace end);
  void ReadEventsBeforeStart();
  /// Reads the events of the current tick.
  void ReadEvents();
  bool IsAtRecord();
  /// Returns the flags of the record at a place.
  std::uint8_t FlagsAt(TracePlace place) const;
  /// Returns the size of the record at a place [bytes]; nullopt if it is incomplete.
  std::optional<std::uint64_t> SizeAt(TracePlace place) const;
  ByteReader BytesAt(TracePlace place) const;
  void ReadTick();
  /// Reads an event without checking its content, see IsSound().
  sim::Event ReadEvent();
  bool IsSound(const sim::Event& event) const;
  [[noreturn]] void Fail(const std::string& message) const;
  [[noreturn]] void FailInEvent() const;

  std::filesystem::path path_;
  std::string bytes_;
  std::vector<std::string> object_names_, joint_names_;
  TraceLimits limits_;
  std::uint32_t version_ = 0;
  TraceCounts first_counts_;                  ///< those of the header's objects
  TraceCounts counts_;                        ///< at the last record
  std::vector<BranchSegment> segments_;       ///< in the order of the file
  std::vector<BranchSegment> path_segments_;  ///< of the path, the first one last
  std::vector<BranchSegment> segments_left_;  ///< of the path, still to be read, the next one last
  std::optional<std::uint64_t> last_tick_;    ///< to be read; nullopt: all
  std::size_t num_last_actions_ = 0;          ///< of it
  TracePlace size_ = 0;
  TracePlace place_ = 0;  ///< of the next record
  std::vector<sim::Event> events_before_start_;
  TraceTick now_;
  bool has_begun_ = false;
  std::vector<TracePlace> places_;
};

}  // namespace smile::recording
