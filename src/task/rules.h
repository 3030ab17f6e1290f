#pragma once

#include <string>
#include <vector>

#include "task/episode.h"
#include "task/match.h"
#include "task/order.h"
#include "task/structure.h"
#include "texts/user_message.h"

namespace smile::task {

// Rules say how a task is to be done, not what is to be achieved. A demonstrator states them by
// `attend` (docs/results.md).

/// Violation of a rule. It cannot be mended: the run is no success any more.
struct RuleBreak {
  enum class Rule {
    kSupport,  ///< `object` was put on `other`, which is smaller
    kOrder,    ///< `object` was placed after `other`, although it was demonstrated before it
  };

  Rule rule = Rule::kSupport;
  std::string object, other;  ///< ids of the scene
  double seconds = 0;         ///< when, since the begin of the episode

  bool operator==(const RuleBreak&) const = default;
};

/// Returns the rules that a demonstrator stated with the property `support`, in scene order.
std::vector<SupportRule> SupportRulesOf(const Attention& attention, const Episode& demonstration);

/// Returns the violations in another episode: of supports, of each object that looks like the one
/// of the rule, then of the order of placements.
std::vector<RuleBreak> RuleBreaksOf(const Structure& structure, const Episode& outcome,
                                    const Match& match, const Order& order);

/// Returns a sentence for people: `Large was put on Small, which is smaller, at 12.3 s`.
texts::UserMessage WordsOf(const RuleBreak& rule_break);

}  // namespace smile::task
