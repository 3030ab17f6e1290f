// Edits as JSON, from files and from the page. Fields are read by name and remembered; what was not
// read is an error, so a misspelled optional field cannot be ignored silently.

#include "editing/edit_json.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/wording.h"
#include "texts/message_json.h"

namespace smile::editing {
namespace {

/// Fields of an edit: numbers only, and unknown ones are refused.
class EditFields {
 public:
  explicit EditFields(const Json& json) : json_(json) {}

  /// Returns a finite number.
  /// @throws std::invalid_argument if it is missing or something else.
  double Number(const char* key) {
    const Json& value = Find(key);
    if (!value.is_number() || !std::isfinite(value.get<double>())) Expected(key, "a number");
    return value.get<double>();
  }
  /// Returns a number without a fraction, within the range of int.
  /// @throws std::invalid_argument if it is missing or something else.
  int Integer(const char* key) {
    // JSON has one type of number: 2.0 is a whole number, too.
    const double number = Number(key);
    constexpr int kMost = std::numeric_limits<int>::max();
    if (number != std::floor(number) || std::abs(number) > kMost) Expected(key, "a whole number");
    return static_cast<int>(number);
  }
  bool Has(const char* key) const { return json_.contains(key); }

  /// Refuses all fields that have not been asked for.
  void RequireNoMore() const {
    for (const auto& [key, value] : json_.items()) {
      if (std::ranges::find(known_, key) != known_.end()) continue;
      throw std::invalid_argument("there is no field " + Quoted(key) + ", expected " +
                                  OneOf(known_) + DidYouMean(key, known_));
    }
  }

 private:
  const Json& Find(const char* key) {
    known_.emplace_back(key);
    if (!json_.contains(key)) {
      throw std::invalid_argument("\"" + std::string(key) + "\" is missing");
    }
    return json_[key];
  }
  [[noreturn]] void Expected(const char* key, const char* what) const {
    const Json& found = json_[key];
    const std::string text = found.is_number() ? ToText(found) : found.type_name();
    throw std::invalid_argument("\"" + std::string(key) + "\" is " + text + ", expected " + what);
  }

  const Json& json_;
  std::vector<std::string_view> known_{"do"};
};

Edit ReadDrop(EditFields* in) {
  Drop drop{.first = in->Integer("first")};
  // A single segment may be written without its end.
  drop.last = in->Has("last") ? in->Integer("last") : drop.first;
  return drop;
}

Edit ReadMove(EditFields* in) {
  return Move{.segment = in->Integer("segment"), .place = in->Integer("place")};
}

Edit ReadTrim(EditFields* in) {
  return Trim{
      .segment = in->Integer("segment"), .from = in->Number("from"), .to = in->Number("to")};
}

Edit ReadMaxPause(EditFields* in) { return MaxPause{.seconds = in->Number("seconds")}; }

Edit ReadRetime(EditFields* in) {
  return Retime{.segment = in->Integer("segment"), .seconds = in->Number("seconds")};
}

Edit ReadSpeed(EditFields* in) { return Speed{.factor = in->Number("factor")}; }

Edit ReadShift(EditFields* in) {
  Shift shift{.first = in->Integer("first"), .seconds = in->Number("seconds")};
  shift.last = in->Has("last") ? in->Integer("last") : shift.first;
  return shift;
}

Edit ReadStretch(EditFields* in) {
  Stretch stretch{.first = in->Integer("first"), .factor = in->Number("factor")};
  stretch.last = in->Has("last") ? in->Integer("last") : stretch.first;
  return stretch;
}

// One table holds names and readers, so the list in the message cannot differ from what is
// understood.
struct EditKind {
  std::string_view name;
  Edit (*read)(EditFields*);
};
/// All edits, by the value of `do`.
constexpr std::array<EditKind, 8> kEditKinds{{{"drop", &ReadDrop},
                                              {"move", &ReadMove},
                                              {"trim", &ReadTrim},
                                              {"max_pause", &ReadMaxPause},
                                              {"retime", &ReadRetime},
                                              {"speed", &ReadSpeed},
                                              {"shift", &ReadShift},
                                              {"stretch", &ReadStretch}}};

Edit ParseEdit(const Json& json) {
  if (!json.is_object() || !json.contains("do") || !json["do"].is_string()) {
    throw std::invalid_argument(R"(is not an edit, expected one like {"do":"drop","first":1})");
  }
  const std::string& name = json["do"].get_ref<const std::string&>();
  const auto* kind = std::ranges::find(kEditKinds, name, &EditKind::name);
  if (kind == kEditKinds.end()) {
    std::vector<std::string_view> known;
    for (const EditKind& each : kEditKinds) known.push_back(each.name);
    throw std::invalid_argument("there is no edit " + Quoted(name) + ", expected " + OneOf(known) +
                                DidYouMean(name, known));
  }
  EditFields fields(json);
  Edit edit = kind->read(&fields);
  fields.RequireNoMore();
  return edit;
}

/// Calls a function and adds the index of the edit to its error message.
template <class Part>
auto Of(std::size_t index, const Part& part) {
  try {
    return part();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument("edits[" + std::to_string(index) + "]: " + error.what());
  }
}

Json ToJson(const std::vector<ChangedState>& changes) {
  Json json = Json::array();
  for (const ChangedState& change : changes) {
    json.push_back({{"id", change.id}, {"before", change.before}, {"after", change.after}});
  }
  return json;
}

}  // namespace

std::vector<Edit> ParseEdits(const Json& json) {
  if (!json.is_array() || json.size() > kMaxEdits) {
    throw std::invalid_argument("\"edits\" is not a list of at most " + std::to_string(kMaxEdits));
  }
  std::vector<Edit> edits;
  for (std::size_t i = 0; i < json.size(); ++i) {
    edits.push_back(Of(i, [&] { return ParseEdit(json[i]); }));
  }
  return edits;
}

recording::Demonstration EditedByAll(recording::Demonstration demonstration,
                                     const std::vector<Edit>& edits) {
  // In order, as each edit sees the effect of those before it.
  for (std::size_t i = 0; i < edits.size(); ++i) {
    demonstration = Of(i, [&] { return Edited(std::move(demonstration), edits[i]); });
  }
  return demonstration;
}

Json ToJson(const EditReport& report) {
  Json skipped = Json::array(), displaced = Json::array();
  for (const SkippedCommand& command : report.skipped) {
    skipped.push_back({{"line", command.line}, {"reason", command.reason}});
    if (command.is_of_overlay) skipped.back()["overlay"] = true;
  }
  for (const Displaced& object : report.displaced) {
    displaced.push_back({{"id", object.id},
                         {"distance_mm", object.gap.millimeters()},
                         {"rotation_deg", object.gap.degrees()}});
  }
  return {{"ends_the_same", report.ends_the_same()},
          {"seconds_before", sim::SecondsOf(report.ticks_before)},
          {"seconds_after", sim::SecondsOf(report.ticks_after)},
          {"left_out", skipped},
          {"conflicts", recording::ToJson(report.conflicts)},
          {"displaced", displaced},
          {"gone", report.gone},
          {"there_again", report.there_again},
          {"controls", ToJson(report.controls)},
          {"host_points", ToJson(report.host_points)},
          {"joints", report.joints}};
}

Json ToPageJson(const EditReport& report) {
  Json json = ToJson(report);
  for (std::size_t i = 0; i < report.skipped.size(); ++i) {
    json["left_out"][i]["reason"] = texts::ToJson(report.skipped[i].reason);
  }
  return json;
}

}  // namespace smile::editing
