#include "recording/trace_writer.h"

#include "base/files.h"
#include "recording/internal_trace_format.h"
#include "recording/trace_reader.h"

// Records of `trace.bin`, see internal_trace_format.h. A tick's record has what changed since the
// record before; the first one after the start or a return is complete, so that a reader can begin
// there, and so is one now and then. An entry of the index is written after its record: an index
// may end before its trace, but never names a record that is missing.

namespace smile::recording {

namespace {

/// Replaces an index by what a reader found, and opens it for appending.
AppendFile Indexed(const TraceReader& trace) {
  const std::filesystem::path path = TraceIndexOf(trace.path());
  const std::vector<std::byte> bytes = BytesOf(trace.index());
  WriteFile(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  return AppendFile(path, AppendFile::kExisting);
}

}  // namespace

TraceWriter::TraceWriter(const std::filesystem::path& path, const model::Model& model)
    : file_(path), index_(TraceIndexOf(path)) {
  ByteWriter out;
  for (char letter : kTraceMagic) out.Put(letter);
  out.Put(kTraceVersion);
  std::vector<std::string> names;
  for (const scene::ObjectSpec& object : model.scene().objects) names.push_back(object.id());
  PutNames(names, &out);
  names.clear();
  if (model.robot() != nullptr) {
    for (const auto& link : model.robot()->links) names.push_back(link.joint_name);
  }
  PutNames(names, &out);
  file_.Append(out.bytes());
  index_.Append(BytesOf(std::span<const TraceEntry>()));
}

// last_ stays empty: the first record contains everything, so it does not depend on what was cut
// off.
TraceWriter::TraceWriter(const TraceReader& trace, std::uint64_t tick)
    : file_(trace.path(), AppendFile::kExisting), index_(Indexed(trace)), tick_(tick) {
  file_.Cut(trace.size());
}

void TraceWriter::Append(const ByteWriter& record, const std::optional<TraceEntry>& entry) {
  file_.Append(record.bytes());
  if (entry) index_.Append(BytesOf(*entry));
}

bool TraceWriter::IsKeyframeDue() const {
  const std::uint64_t since = file_.size() - keyframe_place_;
  return since >= kKeyframeBytes && since >= kKeyframeSizes * keyframe_size_;
}

void TraceWriter::Add(const TraceTick& tick) {
  // A record contains what changed since the tick before. After a change of counts everything is
  // written, as indices and sizes refer to other lists. A keyframe contains the counts in any case.
  const TraceCounts counts = CountsOf(tick);
  const bool is_keyframe = !last_ || CountsOf(*last_) != counts || IsKeyframeDue();
  if (is_keyframe) last_.reset();
  ByteWriter record;
  record.Put(tick.tick);
  record.Put(tick.hash);
  const bool joints_changed = !last_ || tick.joints != last_->joints;
  const bool controls_changed = !last_ || tick.controls != last_->controls;
  const bool bonds_changed = !last_ || tick.bonds != last_->bonds;
  const bool face_expression_changed = !last_ || tick.face_expression != last_->face_expression;
  record.Put(static_cast<std::uint8_t>(
      (joints_changed ? kJointsChanged : 0) | (tick.is_robot_shown ? 0 : kRobotHidden) |
      (controls_changed ? kControlsChanged : 0) | (bonds_changed ? kBondsChanged : 0) |
      (face_expression_changed ? kFaceExpressionChanged : 0) | (is_keyframe ? kCountsChanged : 0)));
  if (is_keyframe) Put(counts, &record);
  // Sleeping objects keep their poses bit by bit, so most ticks of a quiet scene name no object.
  std::vector<std::uint32_t> moved;
  for (std::uint32_t i = 0; i < tick.objects.size(); ++i) {
    if (!last_ || tick.objects[i] != last_->objects[i]) moved.push_back(i);
  }
  // Each moved object: index u32, flags u8, position and quaternion as seven doubles.
  record.Put(static_cast<std::uint32_t>(moved.size()));
  for (std::uint32_t i : moved) {
    record.Put(i);
    record.Put(static_cast<std::uint8_t>((tick.objects[i].is_present ? kIsPresent : 0) |
                                         (tick.objects[i].is_awake ? kIsAwake : 0)));
    for (double number : tick.objects[i].position) record.Put(number);
    for (double number : tick.objects[i].rotation) record.Put(number);
  }
  if (joints_changed) {
    for (double q : tick.joints) record.Put(q);
  }
  if (controls_changed) {
    for (const model::ControlState& control : tick.controls) {
      record.Put(control.state);
      record.Put(control.override_state);
      record.Put(control.position);
    }
  }
  if (bonds_changed) {
    for (const model::HostState& bond : tick.bonds) {
      record.Put(NumberOf(bond.guest));
      record.Put(bond.tightness);
      record.Put(bond.is_locked);
    }
  }
  if (face_expression_changed) record.Put(static_cast<std::uint8_t>(tick.face_expression));
  std::optional<TraceEntry> entry;
  if (is_keyframe) {
    keyframe_place_ = file_.size();
    keyframe_size_ = record.size();
    entry = {.place = keyframe_place_, .tick = tick.tick, .hash = tick.hash};
  }
  Append(record, entry);
  last_ = tick;
  tick_ = tick.tick;
}

void TraceWriter::Add(const sim::Event& event) {
  ByteWriter content;
  Put(event, &content);
  ByteWriter record;
  record.Put(tick_);
  // Events and returns have no hash; the field keeps the heads of all records alike.
  record.Put(std::uint64_t{0});
  record.Put(kIsEvent);
  record.Put(static_cast<std::uint32_t>(content.size()));
  record.PutBytes(content.bytes());
  Append(record,
         TraceEntry{.place = file_.size(), .tick = tick_, .kind = TraceEntry::Kind::kEvent});
}

void TraceWriter::Return(TracePlace place, std::size_t log_line, std::uint64_t tick) {
  ByteWriter record;
  record.Put(tick);
  record.Put(std::uint64_t{0});
  record.Put(kIsReturn);
  record.Put(place);
  record.Put(std::uint64_t{log_line});
  Append(record,
         TraceEntry{.place = file_.size(), .tick = tick, .kind = TraceEntry::Kind::kReturn});
  tick_ = tick;
  // The tick before, in the file, is not the one before on the path: write everything.
  last_.reset();
}

}  // namespace smile::recording
