#include "record/classic_recorder.h"

#include <cmath>
#include <utility>

#include "base/files.h"
#include "math/angles.h"
#include "record/classic_text.h"
#include "record/png.h"
#include "scene/controls_of.h"
#include "scene/units.h"

namespace smile::record {
namespace {

// An object has moved when it went this far or turned this much since its last line.
constexpr double kMovedSquared = 0.001;  ///< [units squared]
constexpr double kTurned_deg = 0.5;

bool HasTurned(const Vector3& from_deg, const Vector3& to_deg) {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(std::remainder(to_deg[i] - from_deg[i], 360.0)) > kTurned_deg) return true;
  }
  return false;
}

}  // namespace

ClassicRecorder::ClassicRecorder(const std::filesystem::path& directory, double frames_per_second,
                                 sim::Eye* eye, const sim::Simulation& simulation)
    : directory_(directory),
      frames_per_second_(frames_per_second),
      eye_(eye),
      first_tick_(simulation.tick()),
      index_(directory / "frames.csv"),
      written_(simulation.tabletop().objects().size()) {
  index_.Append("frame,tick,image\n");
  OpenSegment();
  WriteStart(simulation);
  Watch(simulation);
}

void ClassicRecorder::WriteStart(const sim::Simulation& simulation) {
  const world::Tabletop& tabletop = simulation.tabletop();
  for (const world::Object& object : tabletop.objects()) {
    if (!tabletop.IsPresent(object)) continue;
    std::string line = "create," + object.id();
    for (const scene::Description& description : object.spec->descriptions) {
      line += "," + description.name + "," + ClassicValue(description.value);
    }
    WriteLine(line);
  }
  for (std::size_t i = 0; i < tabletop.controls().all().size(); ++i) {
    const world::Control& control = tabletop.controls().all()[i];
    if (!tabletop.IsPresent(control)) continue;
    WriteLine("initializeControl," + control.id() + "," + scene::KindOf(*control.part) + "," +
              tabletop.objects()[control.object].id() + "," +
              RecordedState(control, tabletop.controls().states()[i]));
  }
}

void ClassicRecorder::OpenSegment() {
  ++segment_;
  const std::string name = std::to_string(segment_);
  MakeDirectories(directory_ / name);
  text_.emplace(directory_ / (name + ".txt"));
}

void ClassicRecorder::WriteLine(const std::string& fields) {
  text_->Append(std::to_string(frame_) + "," + fields + "\n");
}

void ClassicRecorder::Begin(const std::string& action, const sim::Event& event,
                            const std::string& fields) {
  OpenSegment();
  WriteLine(action + "," + std::string(ClassicHandName(*event.hand)) +
            (fields.empty() ? "" : "," + fields));
}

void ClassicRecorder::Note(const sim::Event& event, const sim::Simulation& simulation) {
  using enum sim::EventKind;
  if (event.kind == kControlChanged) {
    WriteLine("changeControlState," + event.control + "," + event.state);
    has_news_ = true;
    return;
  }
  if (!event.hand) return;
  switch (event.kind) {
    case kGrasped:
      return Begin("grasp", event, event.object);
    case kReleased:
      return Begin("release", event);
    case kDestroyed:
      Begin("destroy", event);
      WriteLine("delete," + event.object);
      has_news_ = true;
      return;
    case kPointed:
      return Begin("pointTo", event, event.part + "," + event.object);
    case kTriggered:
      return Begin("trigger", event, event.control);
    case kFastened:
    case kLoosened: {
      const world::Tabletop& tabletop = simulation.tabletop();
      const world::Host& host = tabletop.bonds().hosts()[static_cast<std::size_t>(event.host)];
      const world::Guest& guest = tabletop.bonds().guests()[static_cast<std::size_t>(event.guest)];
      return Begin(event.kind == kFastened ? "fasten" : "loosen", event,
                   host.point->id + "," + tabletop.objects()[host.object].id() + "," +
                       guest.point->id + "," + event.object + "," +
                       std::to_string(event.tightness));
    }
    default:
      return;
  }
}

void ClassicRecorder::Watch(const sim::Simulation& simulation) {
  // Frame k is due at the first tick that is at least k / frames_per_second after the start.
  const auto elapsed = static_cast<double>(simulation.tick() - first_tick_);
  const double due = static_cast<double>(frame_) * sim::kTicksPerSecond / frames_per_second_;
  if (elapsed + 1e-9 >= due) WriteFrame(simulation);
}

void ClassicRecorder::WriteFrame(const sim::Simulation& simulation) {
  bool has_changed = std::exchange(has_news_, false);
  for (std::size_t i = 0; i < written_.size(); ++i) {
    if (!simulation.tabletop().IsPresent(simulation.tabletop().objects()[i])) continue;
    has_changed = WriteMove(simulation, i) || has_changed;
  }
  std::string image;
  if (has_changed && eye_ != nullptr) {
    image = std::to_string(segment_) + "/" + std::to_string(frame_) + ".png";
    WritePng(directory_ / image, eye_->Look(simulation));
  }
  index_.Append(std::to_string(frame_) + "," + std::to_string(simulation.tick()) + "," + image +
                "\n");
  ++frame_;
}

bool ClassicRecorder::WriteMove(const sim::Simulation& simulation, std::size_t i) {
  const world::Object& object = simulation.tabletop().objects()[i];
  const physics::Body& body = simulation.physics().body(object.body);
  const RigidTransform X_WB = body.pose_in_world();
  const Written now{
      .position = scene::ToFileUnits(X_WB.translation(), simulation.scene().meters_per_unit),
      .angles_deg = FixedAxesAngles(X_WB.rotation()),
      .is_awake = body.is_awake()};
  std::optional<Written>& last = written_[i];
  const bool fell_asleep = last && last->is_awake && !now.is_awake;
  // Also when it moved between two frames and sleeps again.
  const bool has_moved = last && ((now.position - last->position).squaredNorm() > kMovedSquared ||
                                  HasTurned(last->angles_deg, now.angles_deg));
  if (last && !fell_asleep && !has_moved) return false;

  std::string line = "move," + object.id();
  for (double number : now.position) line += "," + ClassicNumber(number);
  for (double number : now.angles_deg) line += "," + ClassicNumber(number);
  WriteLine(line);
  last = now;
  return true;
}

}  // namespace smile::record
