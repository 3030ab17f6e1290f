#include "report/internal_activity.h"

#include <algorithm>
#include <map>

#include "recording/time_range.h"
#include "recording/trace_reader.h"
#include "report/internal_plots.h"
#include "report/wording.h"

// Who held what, and when: the timelines of demonstration and imitation have the same form, whether
// hands or grippers act.

namespace smile::report {
namespace {

/// Returns the hand or gripper of an event; empty if it has none.
std::string ActorOf(const sim::Event& event) {
  if (!event.arm.empty()) return event.arm + " gripper";
  if (event.hand) return std::string(ToString(*event.hand)) + " hand";
  return {};
}

/// Returns true for events after which a hand or gripper holds an object.
bool IsTake(sim::EventKind kind) {
  return kind == sim::EventKind::kGrasped || kind == sim::EventKind::kGripperHolds;
}
/// Returns true for events after which an object is no longer held.
bool IsRelease(sim::EventKind kind) {
  return kind == sim::EventKind::kReleased || kind == sim::EventKind::kGripperReleased ||
         kind == sim::EventKind::kDestroyed;
}

}  // namespace

std::vector<Carry> CarriesOf(const recording::Recording& recording) {
  std::vector<Carry> carries;
  std::map<std::pair<std::string, std::string>, double> held;  // by whom and what, since when
  recording::TraceReader trace(recording);
  double now = 0;
  while (const auto moment = trace.Next()) {
    now = SecondsInto(recording, moment->tick);
    for (const sim::Event& event : moment->events) {
      const auto key = std::pair(ActorOf(event), event.object);
      if (IsTake(event.kind)) held[key] = now;
      // A recording may begin while an object is held: its release has no beginning and is left
      // out.
      if (!IsRelease(event.kind) || !held.contains(key)) continue;
      carries.push_back({event.object, key.first, held.at(key), now});
      held.erase(key);
    }
  }
  // What is still held at the end is held until the last tick.
  for (const auto& [key, begin] : held) carries.push_back({key.second, key.first, begin, now});
  return carries;
}

Markup TimelineOf(const std::vector<Carry>& carries, double seconds, const std::string& words) {
  // One row per object and one color per actor, each in the order of appearance.
  constexpr double kRow = 22, kLabels = 100, kBar = 13;
  std::vector<std::string> objects, actors;
  for (const Carry& carry : carries) {
    if (std::ranges::find(objects, carry.object) == objects.end()) objects.push_back(carry.object);
    if (std::ranges::find(actors, carry.who) == actors.end()) actors.push_back(carry.who);
  }
  const auto place = [](const std::vector<std::string>& list, const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(list, name) - list.begin());
  };
  // At least one row, so that an empty timeline still has an axis.
  const double bottom = kRow * static_cast<double>(std::max<std::size_t>(objects.size(), 1)) + 6;
  const Axis axis(0, seconds, kLabels, kPlotWidth - 8);
  Markup drawing = axis.Draw(0, bottom, "seconds");
  for (std::size_t i = 0; i < objects.size(); ++i) {
    drawing += SvgText(kLabels - 6, kRow * static_cast<double>(i) + 15, "value end",
                       objects[i].substr(0, 16));
  }
  for (const Carry& carry : carries) {
    const double y = kRow * static_cast<double>(place(objects, carry.object)) + 5;
    Markup bar = Element("title", {},
                         carry.object + ": " + carry.who + ", " + Fixed(carry.begin, 1) + " to " +
                             Fixed(carry.end, 1) + " s");
    // Short grasps stay visible.
    bar += SvgRect(axis.x(carry.begin), y, std::max(1.5, axis.x(carry.end) - axis.x(carry.begin)),
                   kBar, "fill " + SeriesClass(place(actors, carry.who)));
    drawing += Element("g", {}, bar);
  }
  Markup timeline = Drawing(kPlotWidth, bottom + 32, words, drawing);
  Markup legend;
  for (std::size_t k = 0; k < actors.size(); ++k) {
    legend += Element("span", {{"class", "chip " + SeriesClass(k)}}, Markup());
    legend += Text(actors[k] + "   ");
  }
  timeline += Element("p", {{"class", "note legend"}}, legend);
  return timeline;
}

}  // namespace smile::report
