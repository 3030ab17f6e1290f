#include "picture/hand_schedule.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "base/diagnostic.h"
#include "recording/trace_reader.h"
#include "recording/view_sample.h"
#include "scene/parts.h"

// Which of the two visible hands touches what, and when. The recording knows four logical hands
// (left, right, both, any); a person has two. Contacts are collected along the trace and then
// assigned: named hands first, `both` to both, `any` to the hand that is free.

namespace smile::picture {
namespace {

using demonstrator::HandName;

/// Time that a hand stays before and after a momentary touch [ticks].
constexpr std::uint64_t kTouchTicks = 6;

struct NamedInterval {
  HandName hand = HandName::kAny;
  ContactInterval interval;
};

/// Returns the ids of a part and of all parts in it.
std::set<std::string_view> IdsWithin(const scene::Part& whole, std::string_view id) {
  std::set<std::string_view> ids;
  scene::ForEachPart(whole, [&](const scene::Part& part) {
    if (part.id != id) return;
    scene::ForEachPart(part, [&](const scene::Part& inner) {
      if (!inner.id.empty()) ids.insert(inner.id);
    });
  });
  return ids;
}

/// Collects contact intervals along the trace.
class ContactCollector {
 public:
  ContactCollector(const recording::Recording& recording, const SurfaceProbe& probe)
      : recording_(recording), model_(*recording.model), probe_(probe) {}

  std::vector<NamedInterval> Collect() {
    recording::TraceReader trace(recording_);
    if (!trace.has_events()) {
      throw InputError({(recording_.directory / "trace.bin").string(), 0, "",
                        "has an old format without the actions of the hands"});
    }
    // Holds from before the start begin with the first tick.
    std::vector<sim::Event> events = trace.events_before_start();
    while (const auto moment = trace.Next()) {
      last_tick_ = moment->tick;
      events.insert(events.end(), moment->events.begin(), moment->events.end());
      for (const sim::Event& event : std::exchange(events, {})) Note(*moment, event);
    }
    // What is still held at the end is held until the last tick.
    for (std::optional<NamedInterval>& held : held_) End(&held);
    std::stable_sort(intervals_.begin(), intervals_.end(),
                     [](const NamedInterval& a, const NamedInterval& b) {
                       return a.interval.first < b.interval.first;
                     });
    return std::move(intervals_);
  }

 private:
  void Note(const recording::TraceTick& moment, const sim::Event& event) {
    using enum sim::EventKind;
    if (!event.hand) return;
    std::optional<NamedInterval>& held = held_[static_cast<std::size_t>(*event.hand)];
    switch (event.kind) {
      case kGrasped:
        End(&held);
        held = IntervalAt(moment, event, ContactInterval::Kind::kHold, GraspedAt(moment, event));
        return;
      case kReleased:
      case kDestroyed:
        return End(&held);
      case kPointed:
        return AddTouch(moment, event, ContactInterval::Kind::kTouch, PlaceOf(event, event.part));
      case kTriggered:
        return AddTouch(moment, event, ContactInterval::Kind::kTouch,
                        PlaceOf(event, event.control));
      case kFastened:
      case kLoosened:
        // A hand that holds the guest turns it without letting go; no separate contact.
        if (!event.guest || held) return;
        return AddTouch(moment, event, ContactInterval::Kind::kTurn,
                        model_.guest(*event.guest).X_BG.translation());
      default:
        return;
    }
  }

  /// Ends an interval at the present tick.
  void End(std::optional<NamedInterval>* held) {
    if (!*held) return;
    (*held)->interval.last = last_tick_;
    intervals_.push_back(*std::exchange(*held, std::nullopt));
  }

  std::optional<NamedInterval> IntervalAt(const recording::TraceTick& moment,
                                          const sim::Event& event, ContactInterval::Kind kind,
                                          const Vector3& p_BQ) const {
    const auto object = model_.FindObject(event.object);
    if (!object || !event.hand) return std::nullopt;
    NamedInterval named{.hand = *event.hand,
                        .interval = {.kind = kind,
                                     .first = moment.tick,
                                     .last = moment.tick,
                                     .object = *object,
                                     .frame = model_.frame_of(*object),
                                     .begin = recording::VisualStateAt(moment, model_)}};
    // The commanded point may lie outside the body, for example in the opening of a box.
    named.interval.p_BQ =
        probe_.PointWithin(named.interval.frame, named.interval.begin.variants, p_BQ);
    return named;
  }

  void AddTouch(const recording::TraceTick& moment, const sim::Event& event,
                ContactInterval::Kind kind, const Vector3& p_BQ) {
    auto named = IntervalAt(moment, event, kind, p_BQ);
    if (!named) return;
    named->interval.first -= std::min(named->interval.first, kTouchTicks);
    named->interval.last += kTouchTicks;
    intervals_.push_back(*std::move(named));
  }

  /// Returns the point at which a hand took hold, in the object's frame, from the log; the object's
  /// origin if the log has none.
  Vector3 GraspedAt(const recording::TraceTick& moment, const sim::Event& event) const {
    const auto object = model_.FindObject(event.object);
    if (!object) return Vector3::Zero();
    // For a hold from before the start, the log may have the tick of the grasp, but the object's
    // pose at that tick is unknown.
    const auto& commands = recording_.commands;
    auto logged =
        std::ranges::lower_bound(commands, moment.tick, {}, &recording::LoggedCommand::tick);
    // Several commands may have this tick; the grasp of this hand and object is the one.
    for (; logged != commands.end() && logged->tick == moment.tick; ++logged) {
      const auto* grasp = std::get_if<sim::Grasp>(&logged->command);
      const bool is_it =
          grasp != nullptr && grasp->hand == event.hand && grasp->object == event.object;
      if (is_it && grasp->p_WQ) {
        return moment.objects[*object].pose_in_world().inverse() * *grasp->p_WQ;
      }
    }
    return Vector3::Zero();
  }

  /// Returns the mean position of the visible pieces of a part or control, in its object's frame.
  Vector3 PlaceOf(const sim::Event& event, std::string_view id) const {
    const auto object = model_.FindObject(event.object);
    if (!object || id == event.object) return Vector3::Zero();
    const std::set<std::string_view> meant = IdsWithin(model_.object(*object).whole, id);
    Vector3 sum = Vector3::Zero();
    int count = 0;
    for (const scene::Visual& visual : model_.visual_model().visuals) {
      const bool is_meant = visual.frame == static_cast<int>(model_.frame_of(*object)) &&
                            meant.contains(visual.part_id);
      if (!is_meant) continue;
      sum += visual.X_FV.translation();
      ++count;
    }
    return count > 0 ? Vector3(sum / count) : Vector3::Zero();
  }

  const recording::Recording& recording_;
  const model::Model& model_;
  const SurfaceProbe& probe_;
  std::uint64_t last_tick_ = 0;
  std::array<std::optional<NamedInterval>, demonstrator::kHandNames.size()> held_;
  std::vector<NamedInterval> intervals_;
};

/// Returns the first tick of an interval at which a hand has another contact; nullopt if it is
/// free.
std::optional<std::uint64_t> BusyFrom(const std::vector<ContactInterval>& others,
                                      const ContactInterval& interval) {
  std::optional<std::uint64_t> busy;
  for (const ContactInterval& other : others) {
    if (other.first > interval.last || other.last < interval.first) continue;
    const std::uint64_t from = std::max(other.first, interval.first);
    busy = std::min(busy.value_or(from), from);
  }
  return busy;
}

std::vector<ContactInterval>& Of(HandSide side, HandSchedule* schedule) {
  return schedule->of[static_cast<std::size_t>(side)];
}

/// Assigns an interval of the hand `any` to the hand that is free longer, on a tie to the one on
/// the object's side; the rest is assigned again when that hand is busy.
void AssignToOneHand(ContactInterval interval, HandSchedule* schedule) {
  const Vector3 p_WQ = interval.begin.poses[interval.frame] * interval.p_BQ;
  const HandSide near = p_WQ.x() > 0 ? HandSide::kLeft : HandSide::kRight;
  const HandSide far = near == HandSide::kLeft ? HandSide::kRight : HandSide::kLeft;
  for (;;) {
    const auto near_busy = BusyFrom(Of(near, schedule), interval),
               far_busy = BusyFrom(Of(far, schedule), interval);
    const auto until = [&interval](const std::optional<std::uint64_t>& busy) {
      return busy.value_or(interval.last + 1);
    };
    const bool is_near = until(near_busy) >= until(far_busy);
    ContactInterval part = interval;
    part.last = until(is_near ? near_busy : far_busy);
    const bool is_done = part.last > interval.last;
    if (is_done) part.last = interval.last;
    // An empty part is skipped; both hands are busy at once only during a momentary touch.
    if (part.last > part.first || is_done) Of(is_near ? near : far, schedule).push_back(part);
    if (is_done) return;
    interval.first = std::max(part.last, interval.first + 1);
    if (interval.first > interval.last) return;
  }
}

/// Assigns an interval of both hands, which hold the object at its two ends along the world's x
/// axis.
void AssignToBoth(const ContactInterval& interval, const SurfaceProbe& probe,
                  HandSchedule* schedule) {
  // Distance of each hand from the end of the object, towards its middle [m].
  constexpr double kInside = 0.02;
  const RigidTransform& X_WB = interval.begin.poses[interval.frame];
  const Vector3 x_B = X_WB.rotation().transpose() * Vector3::UnitX();
  const Span span = probe.Around(interval.frame, interval.begin.variants, interval.p_BQ, x_B);
  for (const HandSide side : kHandSides) {
    ContactInterval half = interval;
    const double at = side == HandSide::kLeft ? std::max(0.0, span.to - kInside)
                                              : std::min(0.0, span.from + kInside);
    half.p_BQ += at * x_B;
    Of(side, schedule).push_back(half);
  }
}

/// Removes overlaps: an interval ends at the latest when the next one begins.
void RemoveOverlaps(std::vector<ContactInterval>* intervals) {
  std::stable_sort(
      intervals->begin(), intervals->end(),
      [](const ContactInterval& a, const ContactInterval& b) { return a.first < b.first; });
  for (std::size_t i = 0; i + 1 < intervals->size(); ++i) {
    (*intervals)[i].last = std::min((*intervals)[i].last, (*intervals)[i + 1].first);
  }
}

/// Returns the side of the hand called `left`: the one for which its objects lie more to its own
/// side.
HandSide CalledLeft(const std::vector<NamedInterval>& all) {
  // Left and right are names in commands, and users put either on either side. The table is seen
  // from the demonstrator's place, where +x is left.
  // What lies in the middle says nothing, wherever rounding has put it.
  constexpr double kMiddle = 0.001;  // [m]
  double balance = 0;
  for (const auto& [hand, interval] : all) {
    const double x = interval.begin.poses[interval.frame].translation().x();
    if (hand == HandName::kLeft) balance += x;
    if (hand == HandName::kRight) balance -= x;
  }
  return balance >= -kMiddle ? HandSide::kLeft : HandSide::kRight;
}

}  // namespace

HandSchedule HandScheduleOf(const recording::Recording& recording, const SurfaceProbe& probe) {
  const std::vector<NamedInterval> all = ContactCollector(recording, probe).Collect();
  const HandSide left = CalledLeft(all),
                 right = left == HandSide::kLeft ? HandSide::kRight : HandSide::kLeft;
  HandSchedule schedule;
  // Named hands first, since `any` takes the one that is free.
  for (const auto& [hand, interval] : all) {
    if (hand == HandName::kLeft) Of(left, &schedule).push_back(interval);
    if (hand == HandName::kRight) Of(right, &schedule).push_back(interval);
    if (hand == HandName::kBoth) AssignToBoth(interval, probe, &schedule);
  }
  for (const auto& [hand, interval] : all) {
    if (hand == HandName::kAny) AssignToOneHand(interval, &schedule);
  }
  for (const HandSide side : kHandSides) RemoveOverlaps(&Of(side, &schedule));
  return schedule;
}

}  // namespace smile::picture
