#pragma once

#include <optional>
#include <string>

#include "base/json.h"
#include "record/support.h"

namespace smile::record {

enum class DeedKind {
  kTake,
  kPut,      ///< let go of where it lay already
  kDrop,     ///< let go of above something
  kRelease,  ///< let go of beyond the table
  kDestroy,
  kPoint,
  kTrigger,
  kFasten,
  kLoosen
};
/// `take`, `put`, `drop`, `release`, `destroy`, `point`, `trigger`, `fasten`, `loosen`.
std::string_view ToString(DeedKind kind);

/// What a hand did that begins a segment.
struct Deed {
  DeedKind kind = DeedKind::kTake;
  demonstrator::HandName hand = demonstrator::HandName::kLeft;
  std::string what;             ///< id of the object, or part pointed at, or control
  std::optional<Support> onto;  ///< of what was put or dropped

  bool operator==(const Deed&) const = default;
};

/// @param support  of what a hand let go of.
/// @returns nullopt for events that begin no segment.
std::optional<Deed> DeedOf(const sim::Event& event, const std::optional<Support>& support);

/// `left hand takes b03`, `both hands put b03 on b01`, `right hand drops b03 into crate`.
std::string WordsOf(const Deed& deed);

/// `{"do":"take","hand":"left","what":"b03","words":"left hand takes b03"}`; of what was put or
/// dropped also `"on"` or `"into"` and the id of what is beneath, empty for the table. null of
/// none.
Json ToJson(const std::optional<Deed>& deed);

}  // namespace smile::record
