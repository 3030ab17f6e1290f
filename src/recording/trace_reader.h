#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/file_windows.h"
#include "recording/recording.h"
#include "recording/trace.h"
#include "recording/trace_index.h"

namespace smile::recording {

struct RecordHead;

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

/// Event of a trace, and the tick after which it happened.
struct TracedEvent {
  std::uint64_t tick = 0;
  sim::Event event;

  bool operator==(const TracedEvent&) const = default;
};

/// Reads a trace along one path through its returns: tick by tick, or at any tick. A file cut in
/// the middle of a record ends with the last whole one.
///
/// The file is read in windows, and only where it is needed: opening a trace of any length reads
/// its header, its index and its end, and a tick is read from the keyframe before it. A trace
/// without an index, as older programs made them, is gone through once when it is opened.
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
  /// @throws InputError if a record contradicts the header or the record before it, as do all
  ///         members that read.
  std::optional<TraceTick> Next();
  /// Returns the moment at a tick, after which Next() continues; nullopt if the path has none.
  std::optional<TraceTick> At(std::uint64_t tick);
  /// Returns the last moment of the path; nullopt if it has none.
  std::optional<TraceTick> Last();
  /// Returns its tick, without reading its state.
  std::optional<std::uint64_t> LastTick();
  /// Returns all events of the path, in order, except those before the start. Reads no ticks.
  std::vector<TracedEvent> Events();
  /// Returns the places after the last tick: first before all of its events, then after each.
  const std::vector<TracePlace>& places() const { return places_; }

  /// Returns true if the file ends with an incomplete record: the recording was interrupted.
  bool is_cut() const { return size_ < file_.size(); }
  /// Returns the size of the complete records and the header [bytes].
  TracePlace size() const { return size_; }
  /// Returns the line of the log of the last return; 0 if there is none.
  std::size_t last_return() const { return segments_.back().log_line; }
  const std::filesystem::path& path() const { return path_; }
  /// Returns the index of the whole file, all paths.
  const std::vector<TraceEntry>& index() const { return index_; }
  /// Returns the number of bytes of the trace that were read so far; some may have been read twice.
  std::uint64_t bytes_read() const { return file_.bytes_read(); }

 private:
  /// State of the reader between two records, to which it can return.
  struct Bookmark {
    TraceTick moment;
    bool has_begun = false;
    std::vector<TracePlace> places;
    TracePlace place = 0;
    TraceCounts counts;
    std::size_t num_segments_left = 0;
  };
  /// Tag of the constructor that does not yet select a path.
  struct Unopened {};
  TraceReader(const Recording& recording, const scene::SceneSpec& scene, Unopened);
  void ReadHeader(const Recording& recording, const scene::SceneSpec& scene);
  /// Finds the keyframes, events and returns, and the end of the last complete record.
  void Survey();
  /// Adds a record to the index.
  void AddToIndex(TracePlace place, const RecordHead& head);
  void FindSegments();
  void FindPathTo(TracePlace end);
  /// @param first_tick  of the path.
  void FindEntriesOnPath(std::uint64_t first_tick);
  void ReadEventsBeforeStart();
  /// Reads the next tick of the path with its events into `now_`; returns false after the last one.
  bool Advance();
  /// Prepares to read on from the keyframe or bookmark before a tick that is nearest to it, unless
  /// the reader stands there or between the two.
  void GoNear(std::uint64_t tick);
  void GoTo(const Bookmark& bookmark);
  void GoTo(const TraceEntry& keyframe);
  /// Goes to the end of the path by the heads of its records, without reading states, and returns
  /// the last tick. The caller restores the state.
  std::optional<std::uint64_t> PassHeads();
  Bookmark MakeBookmark() const;
  /// Makes a bookmark if the last tick is far from those that exist and from keyframes.
  void MarkIfFar();
  /// Returns the last keyframe of the path that is not after a tick; nullptr if there is none.
  const TraceEntry* KeyframeBefore(std::uint64_t tick) const;
  const Bookmark& BookmarkBefore(std::uint64_t tick) const;
  /// Reads the events of the current tick.
  void ReadEvents();
  bool IsAtRecord();
  /// Returns the beginning of the record at a place inside the trace.
  RecordHead HeadOf(TracePlace place);
  /// Returns the beginning of an entry's record, after comparing both.
  RecordHead HeadOf(const TraceEntry& entry);
  void ReadTick();
  /// Reads an event without checking its content, see IsSound().
  sim::Event ReadEvent(TracePlace place, const RecordHead& head);
  bool IsSound(const sim::Event& event) const;
  [[noreturn]] void Fail(const std::string& message) const;
  [[noreturn]] void FailInEvent() const;
  [[noreturn]] void FailInRecord() const;

  std::filesystem::path path_;
  FileWindows file_;
  std::vector<std::string> object_names_, joint_names_;
  TraceLimits limits_;
  std::uint32_t version_ = 0;
  TraceCounts first_counts_;                  ///< those of the header's objects
  TraceCounts counts_;                        ///< at the last record
  std::vector<TraceEntry> index_;             ///< in the order of the file
  std::vector<BranchSegment> segments_;       ///< in the order of the file
  std::vector<BranchSegment> path_segments_;  ///< of the path, the first one last
  std::vector<BranchSegment> segments_left_;  ///< of the path, still to be read, the next one last
  std::vector<TraceEntry> keyframes_;         ///< of the path, in order
  std::vector<TraceEntry> event_entries_;     ///< of the path, in order
  std::optional<std::uint64_t> last_tick_;    ///< to be read; nullopt: all
  std::size_t num_last_actions_ = 0;          ///< of it
  TracePlace begin_ = 0;                      ///< of the records
  TracePlace size_ = 0;
  TracePlace place_ = 0;  ///< of the next record
  std::vector<sim::Event> events_before_start_;
  TraceTick nothing_;  ///< before the first tick: everything is absent
  TraceTick now_;
  bool has_begun_ = false;
  std::vector<TracePlace> places_;
  std::vector<Bookmark> bookmarks_;  ///< in order; the first one is before the first tick
};

}  // namespace smile::recording
