#include "picture/hand_deeds.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "base/diagnostic.h"
#include "recording/sight.h"
#include "recording/trace_reader.h"
#include "scene/parts.h"

namespace smile::picture {
namespace {

using demonstrator::HandName;

/// A hand stays so long before and after a moment's touch [ticks].
constexpr std::uint64_t kTouchTicks = 6;

struct NamedDeed {
  HandName hand = HandName::kAny;
  HandDeed deed;
};

/// The ids of a part and of all parts within it.
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

/// Collects deeds along the trace.
class DeedCollector {
 public:
  DeedCollector(const recording::Recording& recording, const Touch& touch)
      : recording_(recording), model_(*recording.model), touch_(touch) {}

  std::vector<NamedDeed> Collect() {
    recording::TraceReader trace(recording_);
    if (!trace.has_events()) {
      throw InputError({(recording_.directory / "trace.bin").string(), 0, "",
                        "is of an old format that does not tell what hands did"});
    }
    std::vector<sim::Event> events = trace.events_before_start();
    while (const auto moment = trace.Next()) {
      last_tick_ = moment->tick;
      events.insert(events.end(), moment->events.begin(), moment->events.end());
      for (const sim::Event& event : std::exchange(events, {})) Note(*moment, event);
    }
    for (std::optional<NamedDeed>& held : held_) End(&held);
    std::stable_sort(deeds_.begin(), deeds_.end(), [](const NamedDeed& a, const NamedDeed& b) {
      return a.deed.first < b.deed.first;
    });
    return std::move(deeds_);
  }

 private:
  void Note(const recording::TraceTick& moment, const sim::Event& event) {
    using enum sim::EventKind;
    if (!event.hand) return;
    std::optional<NamedDeed>& held = held_[static_cast<std::size_t>(*event.hand)];
    switch (event.kind) {
      case kGrasped:
        End(&held);
        held = DeedAt(moment, event, HandDeed::Kind::kHold, GraspedAt(moment, event));
        return;
      case kReleased:
      case kDestroyed:
        return End(&held);
      case kPointed:
        return AddTouch(moment, event, HandDeed::Kind::kTouch, PlaceOf(event, event.part));
      case kTriggered:
        return AddTouch(moment, event, HandDeed::Kind::kTouch, PlaceOf(event, event.control));
      case kFastened:
      case kLoosened:
        if (!event.guest || held) return;
        return AddTouch(moment, event, HandDeed::Kind::kTurn,
                        model_.guest(*event.guest).X_BG.translation());
      default:
        return;
    }
  }

  void End(std::optional<NamedDeed>* held) {
    if (!*held) return;
    (*held)->deed.last = last_tick_;
    deeds_.push_back(*std::exchange(*held, std::nullopt));
  }

  std::optional<NamedDeed> DeedAt(const recording::TraceTick& moment, const sim::Event& event,
                                  HandDeed::Kind kind, const Vector3& p_BQ) const {
    const auto object = model_.FindObject(event.object);
    if (!object || !event.hand) return std::nullopt;
    NamedDeed named{.hand = *event.hand,
                    .deed = {.kind = kind,
                             .first = moment.tick,
                             .last = moment.tick,
                             .object = *object,
                             .frame = model_.frame_of(*object),
                             .begin = recording::VisualStateAt(moment, model_)}};
    named.deed.p_BQ = touch_.PointWithin(named.deed.frame, named.deed.begin.looks, p_BQ);
    return named;
  }

  void AddTouch(const recording::TraceTick& moment, const sim::Event& event, HandDeed::Kind kind,
                const Vector3& p_BQ) {
    auto named = DeedAt(moment, event, kind, p_BQ);
    if (!named) return;
    named->deed.first -= std::min(named->deed.first, kTouchTicks);
    named->deed.last += kTouchTicks;
    deeds_.push_back(*std::move(named));
  }

  /// The log knows at which point a hand took hold; where it does not say, or there is none, it is
  /// the object's origin.
  Vector3 GraspedAt(const recording::TraceTick& moment, const sim::Event& event) const {
    const auto object = model_.FindObject(event.object);
    if (!object) return Vector3::Zero();
    // A recording that begins while a hand holds something may know when it took hold, but not
    // where the object was then.
    const auto& commands = recording_.commands;
    auto logged =
        std::ranges::lower_bound(commands, moment.tick, {}, &recording::LoggedCommand::tick);
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

  /// The middle of what is to be seen of a part or control of an object, in its body.
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
  const Touch& touch_;
  std::uint64_t last_tick_ = 0;
  std::array<std::optional<NamedDeed>, demonstrator::kHandNames.size()> held_;
  std::vector<NamedDeed> deeds_;
};

/// The first moment of a deed at which a hand does something else.
std::optional<std::uint64_t> BusyFrom(const std::vector<HandDeed>& others, const HandDeed& deed) {
  std::optional<std::uint64_t> busy;
  for (const HandDeed& other : others) {
    if (other.first > deed.last || other.last < deed.first) continue;
    const std::uint64_t from = std::max(other.first, deed.first);
    busy = std::min(busy.value_or(from), from);
  }
  return busy;
}

std::vector<HandDeed>& Of(Side side, HandDeeds* deeds) {
  return deeds->of[static_cast<std::size_t>(side)];
}

/// Gives what `any` hand did to one of the two; where that one is needed, to one after the other.
void GiveToAHand(HandDeed deed, HandDeeds* deeds) {
  const Vector3 p_WQ = deed.begin.poses[deed.frame] * deed.p_BQ;
  const Side near = p_WQ.x() > 0 ? Side::kLeft : Side::kRight;
  const Side far = near == Side::kLeft ? Side::kRight : Side::kLeft;
  for (;;) {
    const auto near_busy = BusyFrom(Of(near, deeds), deed),
               far_busy = BusyFrom(Of(far, deeds), deed);
    const auto until = [&deed](const std::optional<std::uint64_t>& busy) {
      return busy.value_or(deed.last + 1);
    };
    const bool is_near = until(near_busy) >= until(far_busy);
    HandDeed part = deed;
    part.last = until(is_near ? near_busy : far_busy);
    const bool is_done = part.last > deed.last;
    if (is_done) part.last = deed.last;
    // Both are needed at once only where one of them touches something for a moment.
    if (part.last > part.first || is_done) Of(is_near ? near : far, deeds).push_back(part);
    if (is_done) return;
    deed.first = std::max(part.last, deed.first + 1);
    if (deed.first > deed.last) return;
  }
}

/// With both hands a thing is taken at its two sides.
void GiveToBoth(const HandDeed& deed, const Touch& touch, HandDeeds* deeds) {
  constexpr double kInside = 0.02;
  const RigidTransform& X_WB = deed.begin.poses[deed.frame];
  const Vector3 x_B = X_WB.rotation().transpose() * Vector3::UnitX();
  const Span span = touch.Around(deed.frame, deed.begin.looks, deed.p_BQ, x_B);
  for (const Side side : kSides) {
    HandDeed half = deed;
    const double at =
        side == Side::kLeft ? std::max(0.0, span.to - kInside) : std::min(0.0, span.from + kInside);
    half.p_BQ += at * x_B;
    Of(side, deeds).push_back(half);
  }
}

/// A hand that is to do two things at once leaves the one for the other.
void MakeOneAfterAnother(std::vector<HandDeed>* deeds) {
  std::stable_sort(deeds->begin(), deeds->end(),
                   [](const HandDeed& a, const HandDeed& b) { return a.first < b.first; });
  for (std::size_t i = 0; i + 1 < deeds->size(); ++i) {
    (*deeds)[i].last = std::min((*deeds)[i].last, (*deeds)[i + 1].first);
  }
}

/// Which hand is called `left`.
Side CalledLeft(const std::vector<NamedDeed>& all) {
  double balance = 0;
  for (const auto& [hand, deed] : all) {
    const double x = deed.begin.poses[deed.frame].translation().x();
    if (hand == HandName::kLeft) balance += x;
    if (hand == HandName::kRight) balance -= x;
  }
  return balance >= 0 ? Side::kLeft : Side::kRight;
}

}  // namespace

HandDeeds DeedsIn(const recording::Recording& recording, const Touch& touch) {
  const std::vector<NamedDeed> all = DeedCollector(recording, touch).Collect();
  const Side left = CalledLeft(all), right = left == Side::kLeft ? Side::kRight : Side::kLeft;
  HandDeeds deeds;
  for (const auto& [hand, deed] : all) {
    if (hand == HandName::kLeft) Of(left, &deeds).push_back(deed);
    if (hand == HandName::kRight) Of(right, &deeds).push_back(deed);
    if (hand == HandName::kBoth) GiveToBoth(deed, touch, &deeds);
  }
  for (const auto& [hand, deed] : all) {
    if (hand == HandName::kAny) GiveToAHand(deed, &deeds);
  }
  for (const Side side : kSides) MakeOneAfterAnother(&Of(side, &deeds));
  return deeds;
}

}  // namespace smile::picture
