#include "recording/trace_reader.h"

#include <algorithm>
#include <cmath>

#include "base/diagnostic.h"
#include "base/files.h"
#include "recording/internal_trace_format.h"
#include "scene/bond_points.h"
#include "scene/controls_of.h"

namespace smile::recording {
namespace {

/// Largest deviation of a quaternion's length from 1.
constexpr double kUnitLength = 1e-6;
constexpr std::size_t kMaxTraceBytes = std::size_t{4} << 30;

// Readers for the parts of a tick's record, in their order. Each updates `tick`, which starts as a
// copy of the tick before, because a record contains changes only. Each returns false if its part
// is damaged.

/// Objects are only ever added at the end of the lists, so counts never decrease along a path, and
/// each count of objects determines the other counts.
bool ReadCounts(const TraceLimits& limits, TraceCounts* counts, ByteReader* in) {
  const TraceCounts found = GetCounts(in);
  if (found.objects < counts->objects || !limits.Allow(found)) return false;
  *counts = found;
  return true;
}

/// Every index is checked before use: the file is untrusted input.
bool ReadMoved(std::uint32_t num_objects, ByteReader* in, TraceTick* tick) {
  const auto num_moved = in->Get<std::uint32_t>();
  if (num_moved > num_objects) return false;
  for (std::uint32_t k = 0; k < num_moved; ++k) {
    const auto i = in->Get<std::uint32_t>();
    if (i >= num_objects) return false;
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
    : path_(recording.directory / "trace.bin"),
      bytes_(ReadFile(path_, kMaxTraceBytes)),
      limits_(scene) {
  ReadHeader(recording, scene);
  Survey();
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
  while (IsAtRecord() && FlagsAt(place_) == kIsEvent) {
    events_before_start_.push_back(ReadEvent());
    if (!IsSound(events_before_start_.back())) FailInEvent();
  }
}

void TraceReader::Fail(const std::string& message) const {
  throw InputError({path_.string(), 0, "", message});
}

void TraceReader::FailInEvent() const {
  Fail("is damaged in an event after tick " + std::to_string(now_.tick));
}

ByteReader TraceReader::BytesAt(TracePlace place) const {
  return ByteReader(std::as_bytes(std::span(bytes_)).subspan(place));
}

void TraceReader::ReadHeader(const Recording& recording, const scene::SceneSpec& scene) {
  ByteReader in = BytesAt(0);
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
  if (!in.ok()) Fail("its header is truncated");
  // Records begin here; Survey() advances size_ over the complete ones.
  size_ = bytes_.size() - in.remaining();

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
}

std::uint8_t TraceReader::FlagsAt(TracePlace place) const {
  return static_cast<std::uint8_t>(bytes_[place + kRecordHead - 1]);
}

// Records carry no length, except events: the size follows from flags and counts. `counts_` must be
// those of the record before, and the number of joints never changes.
std::optional<std::uint64_t> TraceReader::SizeAt(TracePlace place) const {
  ByteReader in = BytesAt(place);
  in.GetBytes(kRecordHead - 1);
  const auto flags = in.Get<std::uint8_t>();
  std::uint64_t size = kRecordHead;
  TraceCounts counts = counts_;
  if (flags == kIsReturn) {
    size += 2 * 8;
  } else if (flags == kIsEvent) {
    size += 4 + std::uint64_t{in.Get<std::uint32_t>()};
  } else {
    if ((flags & kCountsChanged) != 0) {
      counts = GetCounts(&in);
      size += kCountsRecord;
    }
    size += 4 + kMovedObject * in.Get<std::uint32_t>();
    if ((flags & kJointsChanged) != 0) size += 8 * now_.joints.size();
    if ((flags & kControlsChanged) != 0) size += kControlRecord * counts.controls;
    if ((flags & kBondsChanged) != 0) size += kBondRecord * counts.bonds;
    if ((flags & kFaceExpressionChanged) != 0) size += kFaceExpressionRecord;
  }
  // An incomplete record is the end of a recording that was interrupted.
  if (!in.ok() || size > bytes_.size() - place) return std::nullopt;
  return size;
}

// First pass: finds the ends of all records and cuts the file at its returns. Each return begins a
// segment whose past ends at some earlier record, so segments form a tree as the log does. `bounds`
// is sorted by construction.
void TraceReader::Survey() {
  segments_.push_back({.begin = size_});
  std::vector<TracePlace> bounds{size_};
  while (const auto size = SizeAt(size_)) {
    const TracePlace place = size_;
    size_ += *size;
    bounds.push_back(size_);
    const std::uint8_t flags = FlagsAt(place);
    if (flags != kIsReturn) {
      if ((flags & kCountsChanged) != 0) {
        ByteReader in = BytesAt(place + kRecordHead);
        counts_ = GetCounts(&in);
      }
      continue;
    }
    // A return ends the segment before it and stores where the past of the next one ends.
    segments_.back().end = place;
    ByteReader in = BytesAt(place);
    BranchSegment next{.begin = size_, .tick = in.Get<std::uint64_t>()};
    in.GetBytes(kRecordHead - 8);
    next.past = in.Get<TracePlace>();
    next.log_line = in.Get<std::uint64_t>();
    // A place inside a record or in the future would make the reader misinterpret bytes or loop.
    if (next.past > place || !std::binary_search(bounds.begin(), bounds.end(), next.past)) {
      Fail("returns to a position that is not the end of a record, at byte " +
           std::to_string(place));
    }
    if (next.log_line <= segments_.back().log_line) {
      Fail("returns in another order than the log, at byte " + std::to_string(place));
    }
    segments_.push_back(next);
  }
  // The counts were advanced in file order; reading starts again with those of the header.
  segments_.back().end = size_;
  counts_ = first_counts_;
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

TraceReader::Bookmark TraceReader::MakeBookmark() const {
  Bookmark bookmark;
  bookmark.moment_ = now_;
  bookmark.places_ = places_;
  bookmark.place_ = place_;
  bookmark.counts_ = counts_;
  bookmark.num_segments_left_ = segments_left_.size();
  return bookmark;
}

void TraceReader::ReturnTo(const Bookmark& bookmark) {
  now_ = bookmark.moment_;
  places_ = bookmark.places_;
  place_ = bookmark.place_;
  counts_ = bookmark.counts_;
  // The stack after reading is always a prefix of the whole path, so its size is enough to restore
  // it.
  segments_left_.assign(
      path_segments_.begin(),
      path_segments_.begin() + static_cast<std::ptrdiff_t>(bookmark.num_segments_left_));
  has_begun_ = true;
}

// At the end of a segment, the path continues with the next one, which must begin at the tick where
// this one stopped.
bool TraceReader::IsAtRecord() {
  while (!segments_left_.empty() && place_ == segments_left_.back().end) {
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

std::optional<TraceTick> TraceReader::Next() {
  if (!IsAtRecord()) return std::nullopt;
  ReadTick();
  ReadEvents();
  // The point is reached: what follows on the path is not part of it.
  if (now_.tick == last_tick_) segments_left_.clear();
  return now_;
}

void TraceReader::ReadEvents() {
  // Returns may lead between two events of the same tick, so each place is kept.
  places_ = {place_};
  std::size_t num_actions = 0;
  while (IsAtRecord() && FlagsAt(place_) == kIsEvent) {
    sim::Event event = ReadEvent();
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
  ByteReader in = BytesAt(place_);
  // A copy, so that a damaged record leaves the reader at the last sound tick.
  TraceTick next = now_;
  next.events.clear();
  next.tick = in.Get<std::uint64_t>();
  next.hash = in.Get<std::uint64_t>();
  const auto flags = in.Get<std::uint8_t>();
  next.is_robot_shown = (flags & kRobotHidden) == 0;
  const auto has = [flags](std::uint8_t part) { return (flags & part) != 0; };
  // Short-circuit evaluation keeps the order of the parts in the file. Ticks follow each other
  // without a gap.
  const bool is_sound =
      (flags & ~kTickFlags) == 0 && (!has_begun_ || next.tick == now_.tick + 1) &&
      (!has(kCountsChanged) || ReadCounts(limits_, &counts_, &in)) &&
      ReadMoved(counts_.objects, &in, &next) && (!has(kJointsChanged) || ReadJoints(&in, &next)) &&
      (!has(kControlsChanged) || ReadControls(limits_, counts_.controls, &in, &next)) &&
      (!has(kBondsChanged) || ReadBonds(limits_, counts_.bonds, &in, &next)) &&
      (!has(kFaceExpressionChanged) || ReadFaceExpression(&in, &next));
  if (!is_sound) Fail("is damaged in the record after tick " + std::to_string(now_.tick));
  has_begun_ = true;
  now_ = std::move(next);
  // SizeAt() uses the counts that were just read; for this record it reads the same ones again.
  place_ += *SizeAt(place_);
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
  // Exactly the events that add or remove objects have a list of objects.
  const bool is_of_several =
      event.kind == kAdded || event.kind == kRemoved || event.kind == kCleared;
  if (is_of_several != !event.objects.empty()) return false;
  if (is_of_several) return event.object.empty() && std::ranges::all_of(event.objects, is_object);
  const bool is_known = is_object(event.object);
  if (!is_known && !may_be_nameless) return false;
  switch (event.kind) {
    case kFastened:
    case kLoosened:
      return (event.hand || event.kind == kLoosened) && is_one_of(event.host, now_.bonds.size()) &&
             is_one_of(event.guest, limits_.num_guests);
    case kGrasped:
    case kReleased:
    case kDestroyed:
    case kPointed:
    case kTriggered:
    case kAttended:
      return event.hand.has_value();
    // Refusals change nothing and are never recorded.
    case kCommandRefused:
      return false;
    default:
      return true;
  }
}

sim::Event TraceReader::ReadEvent() {
  const std::uint64_t size = *SizeAt(place_);
  constexpr std::uint64_t kHead = kRecordHead + 4;
  ByteReader in(std::as_bytes(std::span(bytes_)).subspan(place_ + kHead, size - kHead));
  std::optional<sim::Event> event = GetEvent(&in);
  if (!event || in.remaining() > 0) FailInEvent();
  place_ += size;
  return *std::move(event);
}

}  // namespace smile::recording
