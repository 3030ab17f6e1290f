// Parser of single lines: fields separated by commas, `frame,event,…`. The lines come from outside,
// and their texts end up in XML files, pages and terminals: characters, lengths and numbers are
// checked here, once.

#include "classic/internal_classic_line.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "base/wording.h"
#include "classic/classic_text.h"

namespace smile::classic {
namespace {

using sim::EventKind;

constexpr std::size_t kMaxIdBytes = 100;
/// Far beyond the table: in the original, objects that fell off it continue to fall.
constexpr double kMaxPosition = 1e9;  ///< [units]
// Angles need not be normalized; this limit rejects nonsense.
constexpr double kMaxAngle_deg = 1e6;
constexpr std::uint64_t kMaxTightness = 1'000'000;
constexpr std::size_t kMaxAttended = 256, kMaxDescriptions = 256;

[[noreturn]] void Malformed(const std::string& what) { throw std::invalid_argument(what); }

/// First character of a text in well-formed UTF-8, with its number of bytes; 0 bytes if it is
/// malformed.
struct Letter {
  std::uint32_t code = 0;
  std::size_t num_bytes = 0;
};

Letter FirstLetter(std::string_view text) {
  const auto first = static_cast<unsigned char>(text[0]);
  if (first < 0x80) return {first, 1};
  // The first byte determines the length; 0xC0, 0xC1 and those above 0xF4 never occur (RFC 3629).
  const std::size_t num_bytes = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < num_bytes) return {};
  // The first byte of n bytes begins with n ones and a zero; what remains are bits of the code.
  std::uint32_t code = first & (0x7Fu >> num_bytes);
  for (std::size_t i = 1; i < num_bytes; ++i) {
    const auto next = static_cast<unsigned char>(text[i]);
    if ((next & 0xC0) != 0x80) return {};
    code = code << 6 | (next & 0x3Fu);
  }
  // Overlong forms, surrogates and codes beyond Unicode are malformed.
  constexpr std::array<std::uint32_t, 5> kLeast = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xD800 && code < 0xE000;
  if (code < kLeast[num_bytes] || code > 0x10FFFF || is_surrogate) return {};
  return {code, num_bytes};
}

/// Checks that a text is UTF-8 without control characters and noncharacters: descriptions are
/// written into a scene file, and XML does not allow these.
void RequireText(std::string_view text) {
  while (!text.empty()) {
    const Letter letter = FirstLetter(text);
    const bool is_plain = letter.num_bytes > 0 && letter.code >= 0x20 && letter.code != 0x7F &&
                          letter.code != 0xFFFE && letter.code != 0xFFFF;
    if (!is_plain) Malformed("found an invalid byte, expected UTF-8");
    text.remove_prefix(letter.num_bytes);
  }
}

/// Splits a line at its commas; a comma after a backslash is part of its field.
std::vector<std::string> SplitFields(std::string_view line) {
  // The inverse of ClassicValue(): only commas are escaped, a backslash before anything else is
  // itself.
  std::vector<std::string> fields(1);
  for (char letter : line) {
    if (letter != ',') {
      fields.back() += letter;
    } else if (fields.back().ends_with('\\')) {
      fields.back().back() = ',';
    } else {
      fields.emplace_back();
    }
  }
  return fields;
}

/// Fields of a line, taken one after the other. Each member throws std::invalid_argument if its
/// field is missing or invalid.
class Fields {
 public:
  explicit Fields(std::string_view line) : fields_(SplitFields(line)) {}

  std::size_t remaining() const { return fields_.size() - next_; }
  /// Returns the next field, which stays; there must be one.
  const std::string& Next() const { return fields_[next_]; }
  const std::string& Take(std::string_view what) {
    if (remaining() == 0) Malformed("ends too early, expected " + std::string(what));
    return fields_[next_++];
  }
  std::string TakeId(std::string_view what) {
    const std::string& id = Take(what);
    const auto is_ok = [](char letter) { return letter > ' ' && letter < 0x7F && letter != ','; };
    if (!id.empty() && id.size() <= kMaxIdBytes && std::ranges::all_of(id, is_ok)) return id;
    Malformed("found " + Quoted(id) + ", expected " + std::string(what) +
              ": 1 to 100 characters without blanks");
  }
  double TakeNumber(std::string_view what, double limit) {
    return ParseClassicNumber(Take(what), what, limit);
  }
  std::uint64_t TakeCount(std::string_view what, std::uint64_t limit) {
    const std::string& text = Take(what);
    std::uint64_t count = 0;
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, count);
    if (result.ec == std::errc() && result.ptr == end && count <= limit) return count;
    Malformed("found " + Quoted(text) + ", expected " + std::string(what) + ": 0 to " +
              std::to_string(limit));
  }
  demonstrator::HandName TakeHand() {
    const std::string& name = Take("a hand");
    for (demonstrator::HandName hand : demonstrator::kHandNames) {
      if (name == ClassicHandName(hand)) return hand;
    }
    Malformed("found " + Quoted(name) + ", expected LeftHand, RightHand, BothHands or AnyHand");
  }
  void RequireEnd() const {
    if (remaining() == 0) return;
    Malformed("found " + Quoted(fields_[next_]) + ", expected the end of the line");
  }

 private:
  std::vector<std::string> fields_;
  std::size_t next_ = 0;
};

ClassicCreate TakeCreate(Fields* fields) {
  ClassicCreate create{.object = fields->TakeId("an object")};
  while (fields->remaining() > 0) {
    const std::string name = fields->Take("a description");
    if (create.descriptions.size() == kMaxDescriptions) {
      Malformed("the object has more than " + std::to_string(kMaxDescriptions) + " descriptions");
    }
    create.descriptions.push_back({name, fields->Take("the value of " + Quoted(name))});
  }
  return create;
}

ClassicMove TakeMove(Fields* fields) {
  ClassicMove move{.object = fields->TakeId("an object")};
  constexpr std::array kPositions = {"a position x", "a position y", "a position z"};
  constexpr std::array kAngles = {"an angle about x", "an angle about y", "an angle about z"};
  for (int i = 0; i < 3; ++i) move.position[i] = fields->TakeNumber(kPositions[i], kMaxPosition);
  for (int i = 0; i < 3; ++i) move.angles_deg[i] = fields->TakeNumber(kAngles[i], kMaxAngle_deg);
  return move;
}

/// Takes what a tool did, and to what.
void TakeUse(Fields* fields, std::string* verb, std::string* part) {
  *verb = fields->Take("what the tool did");
  if (*verb != "cut" && *verb != "fasten" && *verb != "loosen") {
    Malformed("found " + Quoted(*verb) + ", expected cut, fasten or loosen");
  }
  *part = fields->Take("what the tool worked on");
}

/// Splits `left_gripper` into its arm; nullopt for other texts.
std::optional<std::string> ArmIn(const std::string& text) {
  if (text.size() <= kGripperSuffix.size() || !text.ends_with(kGripperSuffix)) return std::nullopt;
  return text.substr(0, text.size() - kGripperSuffix.size());
}

ClassicEffect TakePress(Fields* fields) {
  ClassicEffect press{.kind = EventKind::kPressed, .control = fields->TakeId("a control")};
  if (fields->remaining() == 0) return press;
  const std::string by = fields->TakeId("what pressed it");
  if (const auto arm = ArmIn(by)) {
    press.arm = *arm;
  } else {
    press.by = by;
  }
  return press;
}

/// A use by a gripper or by a turning hand; nullopt if it is the action of a hand.
std::optional<ClassicEffect> TakeUseWithoutCommand(Fields* fields) {
  const std::string user = fields->remaining() > 0 ? fields->Next() : "";
  const auto arm = ArmIn(user);
  if (!arm && user != kTurningHand) return std::nullopt;
  ClassicEffect use{.kind = EventKind::kUsed, .arm = arm.value_or("")};
  fields->TakeId("a gripper");
  use.by = fields->TakeId("a tool");
  TakeUse(fields, &use.verb, &use.part);
  return use;
}

ClassicAction TakeAction(EventKind kind, Fields* fields) {
  ClassicAction action{.kind = kind, .hand = fields->TakeHand()};
  switch (kind) {
    case EventKind::kGrasped:
      action.object = fields->TakeId("an object");
      break;
    case EventKind::kPointed:
      action.part = fields->TakeId("a part");
      action.object = fields->TakeId("the object of the part");
      break;
    case EventKind::kTriggered:
      action.control = fields->TakeId("a control");
      break;
    case EventKind::kFastened:
    case EventKind::kLoosened:
      action.host = fields->TakeId("a host point");
      action.host_object = fields->TakeId("the object of the host point");
      action.guest = fields->TakeId("a guest point");
      action.object = fields->TakeId("the object of the guest point");
      action.tightness = static_cast<int>(fields->TakeCount("a tightness", kMaxTightness));
      break;
    case EventKind::kUsed:
      action.object = fields->TakeId("a tool");
      TakeUse(fields, &action.verb, &action.part);
      break;
    case EventKind::kAttended:
      action.object = fields->TakeId("an object");
      // More properties than the limit remain in the line, and RequireEnd() rejects them.
      while (fields->remaining() > 0 && action.properties.size() < kMaxAttended) {
        action.properties.push_back(fields->Take("a property"));
      }
      break;
    default:
      break;
  }
  return action;
}

decltype(ClassicLine::what) TakeWhat(const std::string& event, Fields* fields) {
  if (event == "create") return TakeCreate(fields);
  if (event == "delete") return ClassicDelete{.object = fields->TakeId("an object")};
  if (event == "move") return TakeMove(fields);
  if (event == "initializeControl") {
    ClassicControl control{.control = fields->TakeId("a control")};
    control.kind = fields->Take("the kind of the control");
    control.object = fields->TakeId("the object of the control");
    control.state = fields->Take("a state");
    return control;
  }
  if (event == "changeControlState") {
    ClassicControlChange change{.control = fields->TakeId("a control")};
    change.state = fields->Take("a state");
    return change;
  }
  if (event == kPressWord) return TakePress(fields);
  // Collected for the message about an unknown event.
  std::vector<std::string_view> known{
      "create", "delete", "move", "initializeControl", "changeControlState", kPressWord};
  for (const ClassicWord& action : kClassicWords) {
    if (event == action.word && action.kind == EventKind::kUsed) {
      if (auto use = TakeUseWithoutCommand(fields)) return *std::move(use);
    }
    if (event == action.word) return TakeAction(action.kind, fields);
    known.push_back(action.word);
  }
  Malformed("found " + Quoted(event) + ", expected " + OneOf(known) + DidYouMean(event, known));
}

}  // namespace

double ParseClassicNumber(std::string_view text, std::string_view what, double limit) {
  double number = 0;
  const char* end = text.data() + text.size();
  const auto result = std::from_chars(text.data(), end, number);
  // The comparison fails for NaN. Numbers too small for a double are refused, too: from_chars()
  // reports them as out of range.
  if (result.ec == std::errc() && result.ptr == end && std::abs(number) <= limit) return number;
  Malformed("found " + Quoted(text) + ", expected " + std::string(what) + ": a number within +-" +
            NumberText(limit));
}

ClassicLine ParseClassicLine(std::string_view text, const ClassicLimits& limits) {
  RequireText(text);
  Fields fields(text);
  ClassicLine line{.frame = fields.TakeCount("a frame", limits.max_frame)};
  line.what = TakeWhat(fields.Take("an event"), &fields);
  fields.RequireEnd();
  return line;
}

}  // namespace smile::classic
