// The classic view is written in step with the simulation and must be able to go back: after an
// undo, Return() removes the files and lines after a savepoint. Therefore all state that later
// lines depend on is in one struct, and files are append-only with known sizes.

#include "classic/classic_recorder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/files.h"
#include "classic/classic_text.h"
#include "math/angles.h"
#include "recording/segment_files.h"
#include "recording/time_range.h"
#include "recording/view_sample.h"
#include "scene/controls_of.h"
#include "scene/units.h"
#include "sim/action_summary.h"

namespace smile::classic {
namespace {

// Thresholds of the original: an object has moved if its position or an angle changed by more since
// its last line.
constexpr double kMovedSquared = 0.001;  ///< [units squared]
constexpr double kTurned_deg = 0.5;

/// True if any angle changed by more than kTurned_deg; remainder() takes the shorter way around the
/// circle.
bool HasTurned(const Vector3& from_deg, const Vector3& to_deg) {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(std::remainder(to_deg[i] - from_deg[i], 360.0)) > kTurned_deg) return true;
  }
  return false;
}

/// Returns texts, escaped, each after a comma.
std::string Joined(const std::vector<std::string>& texts) {
  std::string joined;
  for (const std::string& text : texts) joined += "," + ClassicValue(text);
  return joined;
}

}  // namespace

ClassicRecorder::ClassicRecorder(const std::filesystem::path& directory,
                                 const ClassicOptions& options, model::Eye* eye,
                                 std::shared_ptr<const model::Model> model,
                                 const recording::TraceTick& first,
                                 const std::vector<sim::Event>& standing)
    : directory_(directory),
      options_(options),
      eye_(eye),
      model_(std::move(model)),
      first_tick_(first.tick),
      frames_(directory / "frames.csv") {
  // Indices of objects are stable: added ones follow at the end.
  state_.written.Resize(first.objects.size());
  state_.is_gone.resize(first.objects.size());
  frames_.Add({.picture = {}, .image = {}, .line = "frame,tick,image\n"});
  OpenSegment();
  WriteStart(first, standing);
  WriteFrameIfDue(first);
}

void ClassicRecorder::OpenSegment() {
  MakeDirectories(recording::SegmentPictures(directory_, state_.segment));
  // Without symbols there are folders of pictures only.
  if (options_.has_symbols) text_.emplace(recording::SegmentText(directory_, state_.segment));
}

void ClassicRecorder::WriteCreate(model::ObjectIndex index) {
  const scene::ObjectSpec& object = model_->object(index);
  std::string line = "create," + object.id();
  for (const scene::Description& description : object.descriptions) {
    line += "," + description.name + "," + ClassicValue(description.value);
  }
  WriteLine(line);
}

// RecordedState() gives the position of a switch but the state of other controls, as the original
// wrote them.
void ClassicRecorder::WriteControl(model::ControlIndex index, const model::ControlState& state) {
  const model::Control& control = model_->control(index);
  WriteLine("initializeControl," + control.id() + "," + scene::KindOf(*control.part) + "," +
            model_->id(control.object) + "," + RecordedState(control, state));
}

void ClassicRecorder::WriteStart(const recording::TraceTick& first,
                                 const std::vector<sim::Event>& standing) {
  // Objects that lay on the floor before the start are gone; the order of lines is objects,
  // controls, holds.
  for (const sim::Event& event : standing) {
    if (event.kind == sim::EventKind::kFell) state_.is_gone[IndexOf(event.object)] = true;
  }
  for (const auto i : IndexRange<model::ObjectIndex>(first.objects.size())) {
    if (first.objects[i].is_present && !state_.is_gone[i]) WriteCreate(i);
  }
  for (model::ControlIndex i : model_->controls()) {
    const model::ObjectIndex object = model_->control(i).object;
    if (!first.objects[object].is_present || state_.is_gone[object]) continue;
    WriteControl(i, first.controls[i]);
  }
  for (const sim::Event& event : standing) {
    const bool is_written =
        event.kind == sim::EventKind::kGrasped || event.kind == sim::EventKind::kAttended;
    if (is_written) WriteLine(FieldsOf(event));
  }
}

model::ObjectIndex ClassicRecorder::IndexOf(const std::string& object) const {
  // Events refer to objects of the scene only.
  return *model_->FindObject(object);
}

void ClassicRecorder::WriteLine(const std::string& fields) {
  if (text_) text_->Append(std::to_string(state_.frame) + "," + fields + "\n");
}

std::string ClassicRecorder::FieldsOf(const sim::Event& event) const {
  const std::string action =
      std::string(ClassicWordFor(event.kind)) + "," + std::string(ClassicHandName(*event.hand));
  using enum sim::EventKind;
  switch (event.kind) {
    case kGrasped:
      return action + "," + event.object;
    case kPointed:
      return action + "," + event.part + "," + event.object;
    case kTriggered:
      return action + "," + event.control;
    case kFastened:
    case kLoosened: {
      const model::Host& host = model_->host(*event.host);
      const model::Guest& guest = model_->guest(*event.guest);
      return action + "," + host.point->id + "," + model_->id(host.object) + "," + guest.point->id +
             "," + event.object + "," + std::to_string(event.tightness);
    }
    case kAttended:
      return action + "," + event.object + Joined(event.properties);
    case kUsed:
      return action + Joined({event.by, event.state, event.part});
    default:
      return action;
  }
}

std::string ClassicRecorder::FieldsOfEffect(const sim::Event& event) {
  const std::string by = event.arm.empty() ? event.by : event.arm + std::string(kGripperSuffix);
  if (event.kind == sim::EventKind::kPressed) {
    return std::string(kPressWord) + "," + event.control + (by.empty() ? "" : "," + by);
  }
  const std::string user = event.arm.empty() ? std::string(kTurningHand) : by;
  return std::string(ClassicWordFor(event.kind)) + "," + user +
         Joined({event.by, event.state, event.part});
}

void ClassicRecorder::BeginWithoutHand(const sim::Event& event) {
  ++state_.segment;
  OpenSegment();
  state_.has_news = true;
  const bool is_new = event.kind == sim::EventKind::kAdded;
  state_.written.Resize(model_->objects().size());
  state_.is_gone.resize(model_->objects().size());
  // Where they are now is written with the next frame, as that of everything that moves.
  if (event.kind == sim::EventKind::kDisplaced) return;
  // All objects first, then their controls, as at the start.
  for (const std::string& id : event.objects) {
    const model::ObjectIndex object = IndexOf(id);
    if (is_new) {
      WriteCreate(object);
    } else if (!state_.is_gone[object]) {
      WriteLine("delete," + id);
    }
  }
  for (const std::string& id : event.objects) {
    if (!is_new) break;
    for (model::ControlIndex i : model_->controls_of(IndexOf(id))) {
      WriteControl(i, model_->initial_state().controls[i]);
    }
  }
}

void ClassicRecorder::Note(const sim::Event& event) {
  using enum sim::EventKind;
  if (event.kind == kAdded || event.kind == kRemoved || event.kind == kDisplaced ||
      event.kind == kCleared) {
    return BeginWithoutHand(event);
  }
  // The action is the first line of its segment. A picture of a frame belongs to the segment that
  // is open at its time.
  if (BeginsAction(event)) {
    ++state_.segment;
    OpenSegment();
    WriteLine(FieldsOf(event));
  }
  switch (event.kind) {
    case kControlChanged:
      WriteLine("changeControlState," + event.control + "," + event.state);
      state_.has_news = true;
      break;
    case kPressed:
      WriteLine(FieldsOfEffect(event));
      break;
    case kUsed:
      if (!event.hand) WriteLine(FieldsOfEffect(event));
      break;
    case kFell:
      // A fallen object gets a last position with the next frame, then it is deleted from the view.
      state_.falling.push_back(IndexOf(event.object));
      break;
    // A destroyed object is deleted in the segment that its action has just opened.
    case kDestroyed:
      if (!event.hand) break;
      WriteLine("delete," + event.object);
      state_.has_news = true;
      break;
    case kAttended:
      if (event.hand) WriteLine(FieldsOf(event));
      break;
    default:
      break;
  }
}

void ClassicRecorder::WriteFrameIfDue(const recording::TraceTick& now) {
  if (recording::IsFrameDue(state_.frame, now.tick - first_tick_, options_.frames_per_second))
    WriteFrame(now);
}

std::string ClassicRecorder::PathOf(std::uint64_t frame) const {
  return std::to_string(state_.segment) + "/" + std::to_string(frame) + ".png";
}

void ClassicRecorder::WriteFrame(const recording::TraceTick& now) {
  // Lines only for objects that moved; a picture only if anything changed. Every object is asked,
  // also after the first change: each gets its own line.
  bool has_changed = std::exchange(state_.has_news, false);
  for (const auto i : IndexRange<model::ObjectIndex>(now.objects.size())) {
    if (!now.objects[i].is_present || state_.is_gone[i]) continue;
    has_changed = WriteMove(i, now.objects[i]) || has_changed;
  }
  for (model::ObjectIndex i : std::exchange(state_.falling, {})) {
    if (!now.objects[i].is_present || state_.is_gone[i]) continue;
    WriteMove(i, now.objects[i], /*is_last=*/true);
    WriteLine("delete," + model_->id(i));
    state_.is_gone[i] = true;
  }
  FrameWriter::Frame frame;
  std::string picture;
  if (has_changed && eye_ != nullptr) {
    picture = PathOf(state_.frame);
    frame.picture = directory_ / picture;
    const Image& drawn =
        eye_->Draw(model_->visual_model(), recording::ViewSampleAt(now, *model_, eye_->spec()));
    // Copied, as the eye draws the next one while this one is compressed.
    frame.image = {.width_px = drawn.width_px, .height_px = drawn.height_px, .color = drawn.color};
  }
  frame.line = std::to_string(state_.frame) + "," + std::to_string(now.tick) + "," + picture + "\n";
  frames_.Add(std::move(frame));
  ++state_.frame;
}

bool ClassicRecorder::WriteMove(model::ObjectIndex i, const recording::TracePose& pose,
                                bool is_last) {
  const RigidTransform X_WB = pose.pose_in_world();
  const Written now{
      .position = scene::ToFileUnits(X_WB.translation(), model_->scene().meters_per_unit),
      .angles_deg = FixedAxesAngles(X_WB.rotation()),
      .is_awake = pose.is_awake};
  const std::optional<Written>& last = state_.written[i];
  // An object that comes to rest gets one more line, so that its last line is where it stays,
  // although it moved less than the threshold since.
  const bool fell_asleep = last && last->is_awake && !now.is_awake;
  // Compared to the last line, not to the last tick: detects moves between two frames and slow
  // drift.
  const bool has_moved = last && ((now.position - last->position).squaredNorm() > kMovedSquared ||
                                  HasTurned(last->angles_deg, now.angles_deg));
  if (last && !fell_asleep && !has_moved && !is_last) return false;

  std::string line = "move," + model_->id(i);
  for (double number : now.position) line += "," + ClassicNumber(number);
  for (double number : now.angles_deg) line += "," + ClassicNumber(number);
  WriteLine(line);
  state_.written.Set(i, now);
  return true;
}

// Deletes pictures and segments after the savepoint, then truncates the open text and the index to
// their sizes at the savepoint.
void ClassicRecorder::Return(const Savepoint& savepoint) {
  // No picture may be written after its removal.
  frames_.Flush();
  for (std::uint64_t frame = savepoint.state.frame; frame < state_.frame; ++frame) {
    // Frames after the savepoint may have pictures in its own segment; later segments are removed
    // as a whole, below.
    std::filesystem::remove(recording::SegmentPictures(directory_, savepoint.state.segment) /
                            (std::to_string(frame) + ".png"));
  }
  for (int segment = state_.segment; segment > savepoint.state.segment; --segment) {
    recording::RemoveSegment(directory_, segment);
  }
  if (text_) {
    text_.emplace(recording::SegmentText(directory_, savepoint.state.segment),
                  recording::AppendFile::kExisting);
    text_->Cut(savepoint.text_size);
  }
  frames_.CutIndex(savepoint.index_size);
  state_ = savepoint.state;
}

}  // namespace smile::classic
