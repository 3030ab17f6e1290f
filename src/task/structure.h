#pragma once

#include <string>
#include <vector>

#include "model/relations.h"
#include "task/appearance.h"
#include "task/effects.h"
#include "task/episode.h"

namespace smile::task {

using model::Relation;

/// What determines where a structure stands. A structure with a fixed object stands where this is,
/// whatever the anchor.
enum class Anchor {
  kNone,      ///< nothing: it may stand anywhere on the table
  kLandmark,  ///< an object that the demonstration did not move
  kTable,     ///< the table: it stands where it was demonstrated
};

/// Two objects of a structure whose surfaces are almost in contact.
struct Neighbors {
  std::string object, other;  ///< ids; `object` was placed later

  bool operator==(const Neighbors&) const = default;
};

/// An object that was put around another one, which stayed: a ring around a post.
struct Surrounding {
  std::string object, inner;  ///< ids

  bool operator==(const Surrounding&) const = default;
};

/// Rule that an object never stands on a smaller one, see RuleBreaksOf().
struct SupportRule {
  scene::ObjectSpec object;
  std::vector<scene::ObjectSpec> exceptions;  ///< smaller ones on which the demonstration put it
};

/// Result of a demonstration: the task is to achieve the same, anywhere on the table unless
/// something determines the place.
struct Structure {
  /// Objects that hands moved, their supports and containers down to the table, what they were put
  /// around, and objects that slide in them or are fastened to them; in scene order, with their
  /// final poses. Empty if the demonstration only pressed switches.
  std::vector<scene::ObjectSpec> objects;
  std::vector<Relation> relations;  ///< of these objects, at the end
  std::vector<Surrounding> around;  ///< of these objects, at the end
  std::vector<std::string> order;   ///< of their placements, see PlacementsOf()
  std::vector<Effect> effects;
  /// Other objects that effects refer to, in scene order; they have no place in the structure.
  std::vector<scene::ObjectSpec> others;
  /// Objects that fell from the table during the demonstration, in this order.
  std::vector<std::string> fallen;
  Attention attention;  ///< properties of objects that matter, as specified by the demonstrator
  Anchor anchor = Anchor::kNone;
  std::string landmark;  ///< the anchor, one of `objects`; empty for other anchors
  /// Loose objects of these that stood on the table, were not moved and carry others now, in scene
  /// order. Empty if there is an anchor.
  std::vector<std::string> foundations;
  std::vector<Neighbors> neighbors;  ///< pairs whose relative places matter
  /// Objects that touched the structure in the end without belonging to it.
  std::vector<scene::ObjectSpec> bystanders;
  std::vector<SupportRule> support_rules;

  /// True if some of its objects cannot be moved; then the structure can stand nowhere else.
  bool is_fixed() const;
  /// True if nothing determines its place: it may stand anywhere on the table.
  bool is_free() const { return anchor == Anchor::kNone && !is_fixed(); }
  bool Contains(const std::string& object) const;
  /// Returns the properties of an object that matter; empty if none were specified.
  std::vector<std::string> AttendedOf(const std::string& object) const;
};

/// Returns a structure in parts, each of which has one place: each fixed object, and then each
/// foundation, with all that it carries, and what was put around any of this. Foundations count
/// only if all objects belong to such a part, and none carries, surrounds or almost touches one of
/// another part; otherwise, what no fixed object carries belongs to the first part. A structure
/// with one of these or none is one part.
std::vector<Structure> PartsOf(const Structure& structure);

}  // namespace smile::task
