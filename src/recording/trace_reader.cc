#include "recording/trace_reader.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "base/diagnostic.h"
#include "recording/internal_trace_format.h"
#include "recording/internal_trace_records.h"
#include "scene/bond_points.h"
#include "scene/controls_of.h"

namespace smile::recording {
namespace {

/// Largest deviation of a quaternion's length from 1.
constexpr double kUnitLength = 1e-6;
/// Maximal number of bookmarks, each with a complete tick.
constexpr std::uint64_t kMaxBookmarks = 256;
/// Number of bytes of the header that are loaded first, and a limit on those of a damaged one.
constexpr std::size_t kFirstHeader = std::size_t{4} << 10, kLargestHeader = std::size_t{64} << 20;
/// Limit on the size of an event: one that names a million objects is smaller.
constexpr std::uint64_t kMaxEventBytes = std::uint64_t{1} << 28;

// Readers for the parts of a tick's record, in their order. Each updates `tick`, which starts as a
// copy of the tick before, because a record contains changes only. Each returns false if its part
// is damaged.

/// Every index is checked before use: the file is untrusted input. Indices increase, so a record
/// of as many objects as there are has each of them.
bool ReadMoved(std::uint32_t num_moved, std::uint32_t num_objects, ByteReader* in,
               TraceTick* tick) {
  std::uint32_t smallest = 0;
  for (std::uint32_t k = 0; k < num_moved; ++k) {
    const auto i = in->Get<std::uint32_t>();
    if (i < smallest || i >= num_objects) return false;
    smallest = i + 1;
    TracePose& object = tick->objects[i];
    const auto what = in->Get<std::uint8_t>();
    object.is_present = (what & kIsPresent) != 0;
    object.is_awake = (what & kIsAwake) != 0;
    for (double& number : object.position) number = in->Get<double>();
    for (double& number : object.rotation) number = in->Get<double>();
    const bool is_unit = std::abs(object.rotation.norm() - 1) < kUnitLength;
    if (!object.position.allFinite() || !is_unit) return false;
  }
  return true;
}

bool ReadJoints(ByteReader* in, TraceTick* tick) {
  for (double& q : tick->joints) q = in->Get<double>();
  return std::ranges::all_of(tick->joints, [](double q) { return std::isfinite(q); });
}

/// A record has all controls if any has changed; the same holds for bonds and joints.
bool ReadControls(const TraceLimits& limits, std::size_t num_controls, ByteReader* in,
                  TraceTick* tick) {
  for (const auto i : IndexRange<model::ControlIndex>(num_controls)) {
    model::ControlState& control = tick->controls[i];
    control.state = in->Get<int>();
    control.override_state = in->Get<int>();
    control.position = in->Get<int>();
    if (!limits.Allow(i, control)) return false;
  }
  return true;
}

bool ReadBonds(const TraceLimits& limits, std::size_t num_bonds, ByteReader* in, TraceTick* tick) {
  for (const auto i : IndexRange<model::HostIndex>(num_bonds)) {
    model::HostState& bond = tick->bonds[i];
    const int guest = in->Get<int>();
    if (guest < -1) return false;
    bond.guest = IndexOf<model::GuestIndex>(guest);
    bond.tightness = in->Get<int>();
    bond.is_locked = in->Get<std::uint8_t>() != 0;
    if (!limits.Allow(i, bond)) return false;
  }
  return true;
}

bool ReadFaceExpression(ByteReader* in, TraceTick* tick) {
  const auto face_expression = in->Get<std::uint8_t>();
  if (face_expression >= robot::kFaceExpressions.size()) return false;
  tick->face_expression = robot::kFaceExpressions[face_expression];
  return true;
}

}  // namespace

TraceLimits::TraceLimits(const scene::SceneSpec& scene) {
  counts.emplace_back();
  // counts[n] are the totals over the first n objects: the only counts that a record may have.
  for (const scene::ObjectSpec& object : scene.objects) {
    for (const scene::Part* control : scene::ControlsOf(object.whole)) {
      num_states.push_back(scene::NumStatesOf(*control));
    }
    for (const auto& host : scene::HostsOf(object.whole)) {
      max_tightness.push_back(static_cast<int>(host.point->stages.size()));
    }
    num_guests += scene::GuestsOf(object.whole).size();
    counts.push_back({.objects = static_cast<std::uint32_t>(counts.size()),
                      .controls = static_cast<std::uint32_t>(num_states.size()),
                      .bonds = static_cast<std::uint32_t>(max_tightness.size())});
  }
}

bool TraceLimits::Allow(model::ControlIndex control, const model::ControlState& state) const {
  return state.state >= 0 && state.state < num_states[control] && state.override_state >= -1 &&
         state.override_state < num_states[control] && state.position >= 0 && state.position <= 1;
}

bool TraceLimits::Allow(model::HostIndex host, const model::HostState& bond) const {
  // Tightness is 0 exactly if nothing is fastened.
  return (!bond.guest || *bond.guest < num_guests) && bond.tightness >= 0 &&
         bond.tightness <= max_tightness[host] && bond.guest.has_value() == (bond.tightness > 0);
}

bool TraceLimits::Allow(const TraceCounts& found) const {
  return found.objects < counts.size() && counts[found.objects] == found;
}

TraceReader::TraceReader(const Recording& recording, const scene::SceneSpec& scene, Unopened)
    : path_(recording.directory / "trace.bin"), file_(path_), limits_(scene) {
  ReadHeader(recording, scene);
  Survey();
  FindSegments();
}

TraceReader::TraceReader(const Recording& recording)
    : TraceReader(recording, recording.scene(), Unopened()) {
  FindPathTo(size_);
  ReadEventsBeforeStart();
}

TraceReader::TraceReader(const Recording& recording, TracePlace end)
    : TraceReader(recording, recording.scene(), Unopened()) {
  FindPathTo(end);
  ReadEventsBeforeStart();
}

// A point lies on the branch that was current when its line was written: the last segment whose
// return is not later in the log.
TraceReader::TraceReader(const Recording& recording, const HistoryPoint& point)
    : TraceReader(recording, SceneAfter(recording, point.line), Unopened()) {
  auto segment =
      std::upper_bound(segments_.begin(), segments_.end(), point.line,
                       [](std::size_t line, const BranchSegment& s) { return line < s.log_line; });
  FindPathTo((--segment)->end);
  // Several actions may have happened at the same tick. Those on the path to the point are counted,
  // so that the reader can stop between two events of one tick.
  last_tick_ = point.tick;
  for (const LoggedCommand& logged : recording.log.PathTo(point.line)) {
    const bool is_last = logged.line > recording.info.start.line && logged.tick == point.tick;
    if (is_last && IsAction(logged.command)) ++num_last_actions_;
  }
  ReadEventsBeforeStart();
}

// Events before the first tick's record describe the state that the start inherits.
void TraceReader::ReadEventsBeforeStart() {
  while (IsAtRecord()) {
    const RecordHead head = HeadOf(place_);
    if (head.flags != kIsEvent) break;
    events_before_start_.push_back(ReadEvent(place_, head));
    if (!IsSound(events_before_start_.back())) FailInEvent();
    place_ += head.size;
  }
  bookmarks_.push_back(MakeBookmark());
  FindEntriesOnPath(segments_left_.empty() ? 0 : HeadOf(place_).tick);
}

void TraceReader::Fail(const std::string& message) const {
  throw InputError({path_.string(), 0, "", message});
}

void TraceReader::FailInEvent() const {
  Fail("is damaged in an event after tick " + std::to_string(now_.tick));
}

void TraceReader::FailInRecord() const {
  Fail("is damaged in the record after tick " + std::to_string(now_.tick));
}

// The size of the header is known only from reading it: more of it is loaded until it is complete.
void TraceReader::ReadHeader(const Recording& recording, const scene::SceneSpec& scene) {
  for (std::size_t loaded = kFirstHeader;; loaded *= 4) {
    ByteReader in(file_.At(0, loaded));
    const std::size_t available = in.remaining();
    for (char letter : kTraceMagic) {
      // A file that is too short yields zeros here, which fail as well.
      if (in.Get<char>() != letter) Fail("this is not a trace of a recording");
    }
    version_ = in.Get<std::uint32_t>();
    if (version_ < kOldestTraceVersion || version_ > kTraceVersion) {
      Fail("its format is version " + std::to_string(version_) + ", expected " +
           std::to_string(kOldestTraceVersion) + " to " + std::to_string(kTraceVersion));
    }
    object_names_ = GetNames(kMaxNames, &in);
    joint_names_ = GetNames(kMaxNames, &in);
    if (in.ok()) {
      begin_ = available - in.remaining();
      break;
    }
    if (available < loaded || loaded > kLargestHeader) Fail("its header is truncated");
  }

  bool fits = std::ranges::equal(object_names_, recording.start_scene().objects, {}, {},
                                 &scene::ObjectSpec::id);
  const std::size_t num_joints = recording.robot() ? recording.robot()->model.links.size() : 0;
  if (!fits || joint_names_.size() != num_joints) {
    Fail("belongs to another scene or robot than scene.xml and the robot's files");
  }
  // The header names the objects of the start. Objects that the scene has beyond these were added
  // later; they are absent until a record's counts include them.
  first_counts_ = limits_.counts[object_names_.size()];
  counts_ = first_counts_;
  for (std::size_t i = object_names_.size(); i < scene.objects.size(); ++i) {
    object_names_.push_back(scene.objects[i].id());
  }
  now_.objects.resize(object_names_.size(), TracePose{.is_present = false});
  now_.joints.resize(joint_names_.size());
  now_.controls.resize(limits_.num_states.size());
  now_.bonds.resize(limits_.max_tightness.size());
  nothing_ = now_;
}

RecordHead TraceReader::HeadOf(TracePlace place) {
  const auto head = HeadAt(place, counts_, joint_names_.size(), &file_);
  // It was complete when the trace was opened.
  if (!head) Fail("became shorter while it was read");
  return *head;
}

RecordHead TraceReader::HeadOf(const TraceEntry& entry) {
  const RecordHead head = HeadOf(entry.place);
  using enum TraceEntry::Kind;
  const bool is_kind = entry.kind == kKeyframe ? head.is_keyframe()
                       : entry.kind == kEvent  ? head.flags == kIsEvent
                                               : head.flags == kIsReturn;
  if (is_kind && head.tick == entry.tick && head.hash == entry.hash) return head;
  throw InputError({TraceIndexOf(path_).string(), 0, "",
                    "does not fit trace.bin at byte " + std::to_string(entry.place) +
                        "; the recording can be read without it"});
}

// The index leads to the last keyframe. From there on, or from the beginning of a trace without an
// index, all records are gone through by their heads.
void TraceReader::Survey() {
  index_ = ReadTraceIndex(path_, &file_);
  // The end of the trace may be missing.
  const auto is_complete = [this](const TraceEntry& entry) {
    return HeadAt(entry.place, counts_, joint_names_.size(), &file_).has_value();
  };
  while (!index_.empty() &&
         (index_.back().kind != TraceEntry::Kind::kKeyframe || !is_complete(index_.back()))) {
    index_.pop_back();
  }
  size_ = begin_;
  if (!index_.empty()) {
    (void)HeadOf(index_.back());
    size_ = index_.back().place;
    index_.pop_back();
  }
  // Where all objects move, each record may be complete: keyframes are kept at some distance.
  TracePlace next_keyframe = 0;
  while (const auto head = HeadAt(size_, counts_, joint_names_.size(), &file_)) {
    if (!head->is_tick()) {
      AddToIndex(size_, *head);
      // The first record after a return is needed: its segment begins there.
      if (head->flags == kIsReturn) next_keyframe = 0;
    } else if (head->is_keyframe() && size_ >= next_keyframe) {
      AddToIndex(size_, *head);
      next_keyframe = size_ + kKeyframeBytes;
    }
    counts_ = head->counts;
    size_ += head->size;
  }
  // The counts were advanced in file order; reading starts again with those of the header.
  counts_ = first_counts_;
}

void TraceReader::AddToIndex(TracePlace place, const RecordHead& head) {
  using enum TraceEntry::Kind;
  index_.push_back({.place = place,
                    .tick = head.tick,
                    .hash = head.hash,
                    .kind = head.is_tick()           ? kKeyframe
                            : head.flags == kIsEvent ? kEvent
                                                     : kReturn});
}

// Each return begins a segment whose past ends at some earlier record, so segments form a tree as
// the log does.
void TraceReader::FindSegments() {
  segments_.push_back({.begin = begin_});
  for (const TraceEntry& entry : index_) {
    if (entry.kind != TraceEntry::Kind::kReturn) continue;
    const RecordHead head = HeadOf(entry);
    segments_.back().end = entry.place;
    // Places decrease towards the start, so every path ends.
    if (head.past > entry.place) {
      Fail("returns to a later position, at byte " + std::to_string(entry.place));
    }
    if (head.log_line <= segments_.back().log_line) {
      Fail("returns in another order than the log, at byte " + std::to_string(entry.place));
    }
    segments_.push_back({.begin = entry.place + head.size,
                         .past = head.past,
                         .tick = head.tick,
                         .log_line = head.log_line});
  }
  segments_.back().end = size_;
}

// Walks from `end` back to the header. Segments are pushed last first, so the vector works as a
// stack whose top is the next to be read. Places decrease strictly, so the walk ends.
void TraceReader::FindPathTo(TracePlace end) {
  while (true) {
    // The segment that contains `end`; the path uses it only up to there.
    auto segment =
        std::upper_bound(segments_.begin(), segments_.end(), end,
                         [](TracePlace at, const BranchSegment& s) { return at < s.begin; });
    if (segment == segments_.begin()) Fail("returns into its header");
    BranchSegment part = *--segment;
    part.end = std::min(end, part.end);
    segments_left_.push_back(part);
    if (segment == segments_.begin()) break;
    end = part.past;
  }
  place_ = segments_left_.back().begin;
  path_segments_ = segments_left_;
}

// Entries and segments are both in the order of the file, and so are the segments of a path. Ticks
// follow each other without a gap, so they increase by at most one per record. This is checked
// here, as moments and the last tick are found by entries, without reading what lies between them.
void TraceReader::FindEntriesOnPath(std::uint64_t first_tick) {
  TraceEntry last{.place = place_, .tick = first_tick};
  const auto is_before = [](const TraceEntry& entry, TracePlace place) {
    return entry.place < place;
  };
  for (auto part = path_segments_.rbegin(); part != path_segments_.rend(); ++part) {
    // Events before the start lie before the first tick.
    const TracePlace begin = std::max(part->begin, place_);
    auto entry = std::lower_bound(index_.begin(), index_.end(), begin, is_before);
    for (; entry != index_.end() && entry->place < part->end; ++entry) {
      const bool is_possible =
          entry->tick >= last.tick &&
          entry->tick - last.tick <= (entry->place - last.place) / kSmallestTickRecord;
      if (!is_possible) {
        // It is the index that is wrong, if the two differ.
        (void)HeadOf(*entry);
        Fail("is damaged between bytes " + std::to_string(last.place) + " and " +
             std::to_string(entry->place) + ": tick " + std::to_string(entry->tick) +
             " cannot follow tick " + std::to_string(last.tick) + " there");
      }
      last = *entry;
      if (entry->kind == TraceEntry::Kind::kKeyframe) keyframes_.push_back(*entry);
      if (entry->kind == TraceEntry::Kind::kEvent) event_entries_.push_back(*entry);
    }
  }
}

TraceReader::Bookmark TraceReader::MakeBookmark() const {
  return {.moment = now_,
          .has_begun = has_begun_,
          .places = places_,
          .place = place_,
          .counts = counts_,
          .num_segments_left = segments_left_.size()};
}

void TraceReader::GoTo(const Bookmark& bookmark) {
  now_ = bookmark.moment;
  has_begun_ = bookmark.has_begun;
  places_ = bookmark.places;
  place_ = bookmark.place;
  counts_ = bookmark.counts;
  // The stack after reading is always a prefix of the whole path, so its size is enough to restore
  // it.
  segments_left_.assign(
      path_segments_.begin(),
      path_segments_.begin() + static_cast<std::ptrdiff_t>(bookmark.num_segments_left));
}

void TraceReader::GoTo(const TraceEntry& keyframe) {
  (void)HeadOf(keyframe);
  now_ = nothing_;
  has_begun_ = false;
  counts_ = first_counts_;
  place_ = keyframe.place;
  // The first one last: the segments up to the one that contains the keyframe are left.
  const auto end =
      std::find_if(path_segments_.begin(), path_segments_.end(),
                   [&](const BranchSegment& segment) { return segment.begin <= keyframe.place; });
  segments_left_.assign(path_segments_.begin(), std::next(end));
}

const TraceEntry* TraceReader::KeyframeBefore(std::uint64_t tick) const {
  const auto after = std::upper_bound(
      keyframes_.begin(), keyframes_.end(), tick,
      [](std::uint64_t wanted, const TraceEntry& entry) { return wanted < entry.tick; });
  return after == keyframes_.begin() ? nullptr : &*std::prev(after);
}

const TraceReader::Bookmark& TraceReader::BookmarkBefore(std::uint64_t tick) const {
  const auto after = std::upper_bound(
      std::next(bookmarks_.begin()), bookmarks_.end(), tick,
      [](std::uint64_t wanted, const Bookmark& mark) { return wanted < mark.moment.tick; });
  return *std::prev(after);
}

void TraceReader::GoNear(std::uint64_t tick) {
  const TraceEntry* keyframe = KeyframeBefore(tick);
  const Bookmark& bookmark = BookmarkBefore(tick);
  const bool is_keyframe_nearer = keyframe != nullptr && keyframe->place >= bookmark.place;
  // Places increase along the path: what lies between the two is read on.
  const TracePlace nearest = is_keyframe_nearer ? keyframe->place : bookmark.place;
  if (has_begun_ && now_.tick <= tick && place_ >= nearest) return;
  if (is_keyframe_nearer) {
    GoTo(*keyframe);
  } else {
    GoTo(bookmark);
  }
}

void TraceReader::MarkIfFar() {
  const TraceEntry* keyframe = KeyframeBefore(now_.tick);
  const TracePlace nearest =
      std::max(BookmarkBefore(now_.tick).place, keyframe != nullptr ? keyframe->place : 0);
  if (place_ < nearest + std::max(kKeyframeBytes, size_ / kMaxBookmarks)) return;
  const auto after =
      std::upper_bound(bookmarks_.begin(), bookmarks_.end(), place_,
                       [](TracePlace place, const Bookmark& mark) { return place < mark.place; });
  bookmarks_.insert(after, MakeBookmark());
}

// At the end of a segment, the path continues with the next one, which must begin at the tick where
// this one stopped.
bool TraceReader::IsAtRecord() {
  while (!segments_left_.empty() && place_ >= segments_left_.back().end) {
    if (place_ > segments_left_.back().end) {
      Fail("returns to a position that is not the end of a record, at byte " +
           std::to_string(segments_left_.back().end));
    }
    segments_left_.pop_back();
    if (segments_left_.empty()) break;
    place_ = segments_left_.back().begin;
    if (has_begun_ && now_.tick != segments_left_.back().tick) {
      Fail("returns to tick " + std::to_string(segments_left_.back().tick) +
           ", but the record there has tick " + std::to_string(now_.tick));
    }
  }
  return !segments_left_.empty();
}

bool TraceReader::Advance() {
  if (!IsAtRecord()) return false;
  ReadTick();
  try {
    ReadEvents();
  } catch (...) {
    // Without its events it is none of the moments: At() reads it again.
    has_begun_ = false;
    throw;
  }
  // The point is reached: what follows on the path is not part of it.
  if (now_.tick == last_tick_) segments_left_.clear();
  return true;
}

std::optional<TraceTick> TraceReader::Next() {
  if (!Advance()) return std::nullopt;
  return now_;
}

std::optional<TraceTick> TraceReader::At(std::uint64_t tick) {
  if (last_tick_ && tick > *last_tick_) return std::nullopt;
  GoNear(tick);
  while ((!has_begun_ || now_.tick < tick) && Advance()) MarkIfFar();
  if (!has_begun_ || now_.tick != tick) return std::nullopt;
  return now_;
}

std::optional<TraceTick> TraceReader::Last() {
  GoNear(last_tick_.value_or(std::numeric_limits<std::uint64_t>::max()));
  while (Advance()) MarkIfFar();
  if (!has_begun_) return std::nullopt;
  return now_;
}

std::optional<std::uint64_t> TraceReader::LastTick() {
  const Bookmark here = MakeBookmark();
  std::optional<std::uint64_t> last;
  try {
    last = PassHeads();
  } catch (...) {
    GoTo(here);
    throw;
  }
  GoTo(here);
  return last;
}

std::optional<std::uint64_t> TraceReader::PassHeads() {
  GoNear(last_tick_.value_or(std::numeric_limits<std::uint64_t>::max()));
  std::optional<std::uint64_t> last;
  if (has_begun_) last = now_.tick;
  // Only the heads of the records: their ticks must follow each other, as when they are read.
  while (last != last_tick_ || !last) {
    if (!IsAtRecord()) break;
    const RecordHead head = HeadOf(place_);
    if (head.is_tick()) {
      if (last && head.tick != *last + 1) FailInRecord();
      last = now_.tick = head.tick;
      has_begun_ = true;
    }
    counts_ = head.counts;
    place_ += head.size;
  }
  return last;
}

std::vector<TracedEvent> TraceReader::Events() {
  std::vector<TracedEvent> events;
  std::size_t num_last_actions = 0;
  for (const TraceEntry& entry : event_entries_) {
    if (last_tick_ && entry.tick > *last_tick_) break;
    sim::Event event = ReadEvent(entry.place, HeadOf(entry));
    if (entry.tick == last_tick_ && BeginsAction(event) && ++num_last_actions > num_last_actions_) {
      break;
    }
    if (!IsSound(event)) FailInEvent();
    events.push_back({entry.tick, std::move(event)});
  }
  return events;
}

void TraceReader::ReadEvents() {
  // Returns may lead between two events of the same tick, so each place is kept.
  places_ = {place_};
  std::size_t num_actions = 0;
  while (IsAtRecord()) {
    const RecordHead head = HeadOf(place_);
    if (head.flags != kIsEvent) break;
    if (head.tick != now_.tick) FailInEvent();
    sim::Event event = ReadEvent(place_, head);
    place_ += head.size;
    if (BeginsAction(event)) ++num_actions;
    // Stops before the first action after the point. Its events are not validated either: they may
    // refer to objects that only it adds.
    if (now_.tick == last_tick_ && num_actions > num_last_actions_) break;
    if (!IsSound(event)) FailInEvent();
    now_.events.push_back(std::move(event));
    places_.push_back(place_);
  }
}

void TraceReader::ReadTick() {
  const RecordHead head = HeadOf(place_);
  // Ticks follow each other without a gap. Objects are only ever added at the end of the lists, so
  // counts never decrease along a path, and each count of objects determines the other counts.
  const bool is_possible =
      (head.flags & ~kTickFlags) == 0 && (!has_begun_ || head.tick == now_.tick + 1) &&
      (!head.has(kCountsChanged) ||
       (head.counts.objects >= counts_.objects && limits_.Allow(head.counts))) &&
      head.num_moved <= head.counts.objects;
  // Checked before its bytes are loaded: from here on, its size is bounded by the scene.
  if (!is_possible) FailInRecord();
  const auto record = file_.At(place_, head.size);
  if (record.size() < head.size) Fail("became shorter while it was read");
  ByteReader in(record);
  in.GetBytes(kRecordHead + (head.has(kCountsChanged) ? kCountsRecord : 0) + sizeof head.num_moved);
  // A copy, so that a damaged record leaves the reader at the last sound tick.
  TraceTick next = now_;
  next.events.clear();
  next.tick = head.tick;
  next.hash = head.hash;
  next.is_robot_shown = !head.has(kRobotHidden);
  // Short-circuit evaluation keeps the order of the parts in the file.
  const bool is_sound =
      ReadMoved(head.num_moved, head.counts.objects, &in, &next) &&
      (!head.has(kJointsChanged) || ReadJoints(&in, &next)) &&
      (!head.has(kControlsChanged) || ReadControls(limits_, head.counts.controls, &in, &next)) &&
      (!head.has(kBondsChanged) || ReadBonds(limits_, head.counts.bonds, &in, &next)) &&
      (!head.has(kFaceExpressionChanged) || ReadFaceExpression(&in, &next));
  if (!is_sound) FailInRecord();
  has_begun_ = true;
  counts_ = head.counts;
  now_ = std::move(next);
  place_ += head.size;
}

// Events that pass have valid objects and indices, so that users need no checks of their own.
bool TraceReader::IsSound(const sim::Event& event) const {
  using enum sim::EventKind;
  const auto is_one_of = [](const auto& index, std::size_t count) {
    return index && *index < count;
  };
  // Classic recordings may contain a release without its object.
  const bool may_be_nameless = event.kind == kReleased && event.object.empty();
  const auto is_object = [this](const std::string& id) {
    return std::ranges::find(object_names_, id) != object_names_.end();
  };
  // Exactly the events without a hand that concern several objects have a list of them.
  const bool is_of_several = event.kind == kAdded || event.kind == kRemoved ||
                             event.kind == kDisplaced || event.kind == kCleared;
  if (is_of_several != !event.objects.empty()) return false;
  if (is_of_several) return event.object.empty() && std::ranges::all_of(event.objects, is_object);
  const bool is_known = is_object(event.object);
  if (!is_known && !may_be_nameless) return false;
  switch (event.kind) {
    case kFastened:
    case kLoosened:
      // Without a hand if a tool fastened it, or its bond ended.
      return is_one_of(event.host, now_.bonds.size()) && is_one_of(event.guest, limits_.num_guests);
    case kGrasped:
    case kReleased:
    case kDestroyed:
    case kPointed:
    case kTriggered:
    case kAttended:
      return event.hand.has_value();
    case kPressed:
      return event.by.empty() || is_object(event.by);
    case kUsed:
      return is_object(event.by) &&
             (event.state == "cut" || event.state == "fasten" || event.state == "loosen");
    // Refusals change nothing and are never recorded.
    case kCommandRefused:
      return false;
    default:
      return true;
  }
}

sim::Event TraceReader::ReadEvent(TracePlace place, const RecordHead& head) {
  if (head.size > kMaxEventBytes) FailInEvent();
  constexpr std::uint64_t kHead = kRecordHead + 4;
  const auto record = file_.At(place, head.size);
  if (record.size() < head.size) Fail("became shorter while it was read");
  ByteReader in(record.subspan(kHead));
  std::optional<sim::Event> event = GetEvent(&in);
  if (!event || in.remaining() > 0) FailInEvent();
  return *std::move(event);
}

}  // namespace smile::recording
