#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/bytes.h"
#include "recording/recording.h"
#include "recording/trace.h"

namespace smile::recording {

/// What a trace of a scene may say of its objects, controls and bonds.
struct TraceLimits {
  std::vector<int> num_states;      ///< of each control
  std::vector<int> max_tightness;   ///< of each host point
  std::vector<TraceCounts> counts;  ///< that the scene had when its last objects were not yet
                                    ///< added: by the number of objects
  std::size_t num_guests = 0;

  explicit TraceLimits(const scene::SceneSpec& scene);
  bool Allow(model::ControlIndex control, const model::ControlState& state) const;
  bool Allow(model::HostIndex host, const model::HostState& bond) const;
  bool Allow(const TraceCounts& found) const;
};

/// Reads a trace, tick by tick, along one way through its returns. A file cut in the middle of a
/// record ends with the last whole one.
///
/// Each moment has all objects of the scene that the way ends with. Those that were not yet added
/// are absent, as those that are gone.
class TraceReader {
 private:
  /// Records that follow one another without a return.
  struct Stretch {
    TracePlace begin = 0, end = 0;
    TracePlace past = 0;     ///< what was written before goes before it
    std::uint64_t tick = 0;  ///< of the moment there
    std::size_t log_line = 0;
  };

 public:
  /// Along the way the recording ends with.
  /// @throws InputError if this is not a trace of a known format version, or not one of the
  ///         recording's objects and robot, or damaged.
  explicit TraceReader(const Recording& recording);
  /// Along the way to some place between two records, where the scene is that of `recording`.
  TraceReader(const Recording& recording, TracePlace end);
  /// Along the way to a moment of the recording's history, with the scene of that moment; ends
  /// before if there is none.
  TraceReader(const Recording& recording, const Moment& moment);

  const std::vector<std::string>& object_names() const { return object_names_; }
  const std::vector<std::string>& joint_names() const { return joint_names_; }
  /// What happened before and still mattered when the recording began: falls to the floor, grasps
  /// of what hands held, and what had been said of objects.
  const std::vector<sim::Event>& events_before_start() const { return events_before_start_; }

  /// False of traces of old versions, which tell of nothing that happened between two moments.
  bool has_events() const { return version_ >= 3; }

  /// The next moment; nullopt after the last one.
  /// @throws InputError if a record contradicts the header or the record before it.
  std::optional<TraceTick> Next();
  /// The places behind the last moment: first before all of its events, then after each.
  const std::vector<TracePlace>& places() const { return places_; }

  /// A moment that was read, to which the reader can come back.
  class Bookmark {
   public:
    const TraceTick& moment() const { return moment_; }

   private:
    friend class TraceReader;
    TraceTick moment_;
    std::vector<TracePlace> places_;
    TracePlace place_ = 0;
    TraceCounts counts_;
    std::size_t num_stretches_ = 0;  ///< still to be read
  };
  /// Of the last moment.
  Bookmark Mark() const;
  /// Next() goes on after a moment that this reader marked.
  void ReturnTo(const Bookmark& bookmark);

  /// True when bytes were left over at the end: the recording was interrupted.
  bool is_cut() const { return size_ < bytes_.size(); }
  /// Of what can be read.
  TracePlace size() const { return size_; }
  /// The line of the log at which the trace returned last; 0 if it never did.
  std::size_t last_return() const { return stretches_.back().log_line; }

 private:
  /// Leaves the way open.
  struct Unopened {};
  TraceReader(const Recording& recording, const scene::SceneSpec& scene, Unopened);
  void ReadHeader(const Recording& recording, const scene::SceneSpec& scene);
  /// Finds the stretches, and where what is whole ends.
  void Survey();
  void FindWayTo(TracePlace end);
  void ReadEventsBeforeStart();
  /// Reads what happened at this moment.
  void ReadEvents();
  bool IsAtRecord();
  /// The flags of the record at a place.
  std::uint8_t FlagsAt(TracePlace place) const;
  /// How long the record at a place is; nullopt if it is not there whole.
  std::optional<std::uint64_t> SizeAt(TracePlace place) const;
  ByteReader BytesAt(TracePlace place) const;
  void ReadTick();
  /// Reads an event whatever it says.
  sim::Event ReadEvent();
  bool IsSound(const sim::Event& event) const;
  [[noreturn]] void Fail(const std::string& message) const;
  [[noreturn]] void FailInEvent() const;

  std::filesystem::path path_;
  std::string bytes_;
  std::vector<std::string> object_names_, joint_names_;
  TraceLimits limits_;
  std::uint32_t version_ = 0;
  TraceCounts first_counts_;                ///< those of the header's objects
  TraceCounts counts_;                      ///< at the last record
  std::vector<Stretch> stretches_;          ///< in the order of the file
  std::vector<Stretch> whole_way_;          ///< the first one last
  std::vector<Stretch> way_;                ///< still to be read, the next one last
  std::optional<std::uint64_t> last_tick_;  ///< to be read, when not all is
  std::size_t num_last_actions_ = 0;        ///< of it
  TracePlace size_ = 0;
  TracePlace place_ = 0;  ///< of the next record
  std::vector<sim::Event> events_before_start_;
  TraceTick now_;
  bool has_begun_ = false;
  std::vector<TracePlace> places_;
};

}  // namespace smile::recording
