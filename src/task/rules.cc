#include "task/rules.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/wording.h"
#include "scene/bounds.h"
#include "scene/solid.h"

namespace smile::task {
namespace {

bool HasProperty(const Attention& attention, const std::string& object,
                 const std::string& property) {
  const auto properties = attention.find(object);
  return properties != attention.end() &&
         std::ranges::find(properties->second, property) != properties->second.end();
}

/// An object that stood on another one or lay in it.
struct Stand {
  std::string object, support;  ///< ids
  std::uint64_t tick = 0;       ///< since when
};

/// Returns the tick of the last release of an object among the first `count` contacts; the begin if
/// it was not released.
std::uint64_t LastRelease(const Episode& episode, const std::string& object, std::size_t count) {
  std::uint64_t tick = episode.begin.tick;
  for (std::size_t i = 0; i < count; ++i) {
    const ContactEvent& contact = episode.contacts[i];
    const bool is_release = contact.event.kind == sim::EventKind::kReleased ||
                            contact.event.kind == sim::EventKind::kGripperReleased;
    if (is_release && contact.event.object == object) tick = contact.tick;
  }
  return tick;
}

/// Returns on what objects stood after they were released: when they were taken again, or at the
/// end.
std::vector<Stand> StandsOf(const Episode& episode) {
  std::vector<Stand> stands;
  for (std::size_t i = 0; i < episode.contacts.size(); ++i) {
    const ContactEvent& contact = episode.contacts[i];
    const std::uint64_t since = LastRelease(episode, contact.event.object, i);
    if (since == episode.begin.tick) continue;
    for (const std::string& support : contact.supports) {
      stands.push_back({contact.event.object, support, since});
    }
  }
  const std::set<std::string> held = HeldInTheEnd(episode);
  for (const Relation& relation :
       model::RelationsOf(episode.scene, ObjectsAt(episode.scene, episode.end))) {
    const std::uint64_t since = LastRelease(episode, relation.object, episode.contacts.size());
    if (relation.support.empty() || since == episode.begin.tick || held.contains(relation.object)) {
      continue;
    }
    stands.push_back({relation.object, relation.support, since});
  }
  return stands;
}

const scene::ObjectSpec& SpecIn(const scene::SceneSpec& scene, const std::string& id) {
  return *std::ranges::find(scene.objects, id, &scene::ObjectSpec::id);
}

/// Returns the area of an object as seen from above, as it was made [m^2].
double AreaOf(const scene::ObjectSpec& object) {
  const Vector3 size = scene::BoundsOf(scene::SolidsOf(object.whole), RigidTransform()).size();
  return size.x() * size.y();
}

bool IsSmaller(const scene::ObjectSpec& object, const scene::ObjectSpec& other) {
  constexpr double kEqual = 0.99;  // sizes come from decimal numbers in a file
  return AreaOf(object) < kEqual * AreaOf(other);
}

/// True if a rule forbids an object to stand on a support.
bool IsForbidden(const SupportRule& rule, const std::vector<std::string>& properties,
                 const scene::ObjectSpec& object, const scene::ObjectSpec& support) {
  if (!IsSmaller(support, object) ||
      !AreAlike(AppearanceOf(rule.object), AppearanceOf(object), properties)) {
    return false;
  }
  const Appearance appearance = AppearanceOf(support);
  return std::ranges::none_of(rule.exceptions, [&](const scene::ObjectSpec& exception) {
    return AreAlike(AppearanceOf(exception), appearance);
  });
}

double SecondsInto(const Episode& episode, std::uint64_t tick) {
  return sim::SecondsOf(tick - episode.begin.tick);
}

void AppendSupportBreaks(const Structure& structure, const Episode& outcome,
                         std::vector<RuleBreak>* breaks) {
  if (structure.support_rules.empty()) return;
  for (const Stand& stand : StandsOf(outcome)) {
    const bool is_forbidden =
        std::ranges::any_of(structure.support_rules, [&](const SupportRule& rule) {
          return IsForbidden(rule, structure.AttendedOf(rule.object.id()),
                             SpecIn(outcome.scene, stand.object),
                             SpecIn(outcome.scene, stand.support));
        });
    if (!is_forbidden) continue;
    const RuleBreak found{.rule = RuleBreak::Rule::kSupport,
                          .object = stand.object,
                          .other = stand.support,
                          .seconds = SecondsInto(outcome, stand.tick)};
    if (std::ranges::find(*breaks, found) == breaks->end()) breaks->push_back(found);
  }
}

void AppendOrderBreaks(const Structure& structure, const Episode& outcome, const Match& match,
                       const Order& order, std::vector<RuleBreak>* breaks) {
  const auto when = [&](const std::string& id) { return std::ranges::find(order.done, id); };
  for (std::size_t later = 0; later < order.demonstrated.size(); ++later) {
    for (std::size_t earlier = 0; earlier < later; ++earlier) {
      const std::string& first = order.demonstrated[earlier];
      const std::string& second = order.demonstrated[later];
      const bool matters = HasProperty(structure.attention, first, "order") ||
                           HasProperty(structure.attention, second, "order");
      // Only what was done can have been done in the wrong order.
      if (!matters || when(first) == order.done.end() || when(first) <= when(second)) continue;
      const std::string& object = match.at(first);
      breaks->push_back(
          {.rule = RuleBreak::Rule::kOrder,
           .object = object,
           .other = match.at(second),
           .seconds = SecondsInto(outcome, LastRelease(outcome, object, outcome.contacts.size()))});
    }
  }
}

}  // namespace

std::vector<SupportRule> SupportRulesOf(const Attention& attention, const Episode& demonstration) {
  std::vector<SupportRule> rules;
  const std::vector<Stand> stands =
      attention.empty() ? std::vector<Stand>() : StandsOf(demonstration);
  for (const scene::ObjectSpec& object : demonstration.scene.objects) {
    if (!HasProperty(attention, object.id(), "support")) continue;
    SupportRule rule{.object = object, .exceptions = {}};
    for (const Stand& stand : stands) {
      if (stand.object != object.id()) continue;
      const scene::ObjectSpec& support = SpecIn(demonstration.scene, stand.support);
      const bool is_known = std::ranges::find(rule.exceptions, support) != rule.exceptions.end();
      if (IsSmaller(support, object) && !is_known) rule.exceptions.push_back(support);
    }
    rules.push_back(std::move(rule));
  }
  return rules;
}

std::vector<RuleBreak> RuleBreaksOf(const Structure& structure, const Episode& outcome,
                                    const Match& match, const Order& order) {
  std::vector<RuleBreak> breaks;
  AppendSupportBreaks(structure, outcome, &breaks);
  AppendOrderBreaks(structure, outcome, match, order, &breaks);
  return breaks;
}

texts::UserMessage WordsOf(const RuleBreak& rule_break) {
  const texts::UserMessage object(rule_break.object), other(rule_break.other);
  const double seconds = std::round(10 * rule_break.seconds) / 10;
  return rule_break.rule == RuleBreak::Rule::kOrder
             ? texts::Say("failures.wrongOrder",
                          {{"object", object}, {"other", other}, {"seconds", seconds}})
             : texts::Say("failures.smallerSupport",
                          {{"object", object}, {"other", other}, {"seconds", seconds}});
}

}  // namespace smile::task
