#include "editing/edit_texts.h"

#include <charconv>
#include <stdexcept>

#include "base/wording.h"

namespace smile::editing {
namespace {

/// Parser of numbers and the signs between them, as in `3:0.5-2`.
class EditText {
 public:
  /// @param form  expected form of the text, for messages.
  EditText(const std::string& text, const char* form)
      : text_(text), form_(form), rest_(text_.data()) {}

  /// Parses a number at this place.
  /// @throws std::invalid_argument if another letter is there.
  template <class T>
  T Number() {
    T number{};
    const auto [end, error] = std::from_chars(rest_, this->end(), number);
    if (error != std::errc()) Fail();
    rest_ = end;
    return number;
  }
  /// Skips the sign if it is next.
  bool Take(char sign) {
    if (rest_ == end() || *rest_ != sign) return false;
    ++rest_;
    return true;
  }
  void Expect(char sign) {
    if (!Take(sign)) Fail();
  }
  void ExpectEnd() {
    if (rest_ != end()) Fail();
  }

 private:
  const char* end() const { return text_.data() + text_.size(); }
  [[noreturn]] void Fail() const {
    throw std::invalid_argument("found " + Quoted(text_) + ", expected " + form_);
  }

  const std::string& text_;
  const char* form_;
  const char* rest_;
};

Edit ParseDrop(const std::string& text) {
  EditText in(text, "the number of a segment, or a range like 2-4");
  Drop drop{.first = in.Number<int>()};
  drop.last = in.Take('-') ? in.Number<int>() : drop.first;
  in.ExpectEnd();
  return drop;
}

Edit ParseMove(const std::string& text) {
  EditText in(text, "the number of a segment and its place, like 5:2");
  Move move{.segment = in.Number<int>()};
  in.Expect(':');
  move.place = in.Number<int>();
  in.ExpectEnd();
  return move;
}

Edit ParseTrim(const std::string& text) {
  EditText in(text, "the number of a segment and the seconds to keep, like 3:0.5-2");
  Trim trim{.segment = in.Number<int>()};
  in.Expect(':');
  trim.from = in.Number<double>();
  in.Expect('-');
  trim.to = in.Number<double>();
  in.ExpectEnd();
  return trim;
}

Edit ParseMaxPause(const std::string& text) {
  EditText in(text, "seconds, like 0.5");
  const MaxPause longest{in.Number<double>()};
  in.ExpectEnd();
  return longest;
}

Edit ParseRetime(const std::string& text) {
  EditText in(text, "the number of a segment and its seconds, like 3:1.5");
  Retime retime{.segment = in.Number<int>()};
  in.Expect(':');
  retime.seconds = in.Number<double>();
  in.ExpectEnd();
  return retime;
}

Edit ParseSpeed(const std::string& text) {
  EditText in(text, "a factor, like 1.5");
  const Speed speed{in.Number<double>()};
  in.ExpectEnd();
  return speed;
}

Edit ParseShift(const std::string& text) {
  EditText in(text, "the number of a segment, or a range, and seconds, like 3:0.5 or 3-4:-0.5");
  Shift shift{.first = in.Number<int>()};
  shift.last = in.Take('-') ? in.Number<int>() : shift.first;
  in.Expect(':');
  shift.seconds = in.Number<double>();
  in.ExpectEnd();
  return shift;
}

Edit ParseStretch(const std::string& text) {
  EditText in(text, "the number of a segment, or a range, and a factor, like 3:1.5 or 3-4:0.5");
  Stretch stretch{.first = in.Number<int>()};
  stretch.last = in.Take('-') ? in.Number<int>() : stretch.first;
  in.Expect(':');
  stretch.factor = in.Number<double>();
  in.ExpectEnd();
  return stretch;
}

/// All options for edits, in the order of the help text.
constexpr EditOption kEditOptions[] = {
    {"--drop", "N[-M]", "remove segments N to M", &ParseDrop},
    {"--move", "N:K", "move segment N so that it becomes the K-th action", &ParseMove},
    {"--trim", "N:FROM-TO", "keep only this time range of segment N [s], and its action",
     &ParseTrim},
    {"--max-pause", "S", "shorten longer pauses to S seconds", &ParseMaxPause},
    {"--retime", "N:SECONDS", "change the duration of segment N to this time [s]", &ParseRetime},
    {"--speed", "F", "increase the speed of all segments by the factor F", &ParseSpeed},
    {"--shift", "N[-M]:SECONDS",
     "shift what the hand of segment N does in segments N to M; other hands stay", &ParseShift},
    {"--stretch", "N[-M]:FACTOR",
     "let what the hand of segment N does in segments N to M take FACTOR times as long",
     &ParseStretch},
};

}  // namespace

std::span<const EditOption> AllEditOptions() { return kEditOptions; }

}  // namespace smile::editing
