// Reads recordings of the 2015 program, from anywhere: two passes over all texts. The first parses
// each line by itself (internal_classic_line.h) and collects what is malformed. The second follows
// the recording line by line and rejects the first contradiction, since everything after it would
// be reported wrongly. Pictures are listed and measured, but not decoded.

#include "classic/classic_reader.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <system_error>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/overloaded.h"
#include "base/wording.h"
#include "classic/internal_classic_line.h"
#include "image/png.h"
#include "recording/recording.h"
#include "sim/action_summary.h"

namespace smile::classic {
namespace {

/// Limit on reported lines; more do not help to find the cause.
constexpr std::size_t kMaxMalformed = 100;

/// Parses the lines of a text; malformed lines become findings.
ClassicFile ReadSegment(const ClassicText& source, const ClassicLimits& limits,
                        std::vector<Diagnostic>* findings) {
  ClassicFile segment{.file = source.file};
  const std::string_view text = source.text;
  int number = 0;
  for (std::size_t start = 0; start < text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    std::string_view line = text.substr(start, end - start);
    start = end + 1;
    ++number;
    // Recordings from Windows end lines with CR LF.
    if (line.ends_with('\r')) line.remove_suffix(1);
    try {
      if (line.size() > limits.max_line_bytes) {
        throw std::invalid_argument("is longer than " + std::to_string(limits.max_line_bytes) +
                                    " bytes");
      }
      segment.lines.push_back(ParseClassicLine(line, limits));
      segment.lines.back().number = number;
    } catch (const std::invalid_argument& error) {
      findings->push_back({source.file, number, "", error.what()});
      if (findings->size() == kMaxMalformed) throw InputError(std::move(*findings));
    }
  }
  return segment;
}

const ClassicAction* ActionIn(const ClassicLine& line) {
  return std::get_if<ClassicAction>(&line.what);
}

/// True for an action of a hand.
bool OpensSegment(const ClassicLine& line) {
  const ClassicAction* action = ActionIn(line);
  return action != nullptr && sim::BeginsAction({.kind = action->kind, .hand = action->hand});
}

/// True for an action of a hand, and for objects that were added or removed without a hand.
bool BeginsSegment(const ClassicLine& line) {
  return OpensSegment(line) || std::holds_alternative<ClassicCreate>(line.what) ||
         std::holds_alternative<ClassicDelete>(line.what);
}

bool IsDestroy(const ClassicLine& line) {
  const ClassicAction* action = ActionIn(line);
  return action != nullptr && action->kind == sim::EventKind::kDestroyed;
}

/// Moves a destroy action before its deletes: the original writes the deletes first, but an action
/// begins its segment.
void PutDestroyFirst(ClassicFile* segment) {
  auto& lines = segment->lines;
  // The first line that is not a delete, if the segment begins with deletes.
  const auto action = std::ranges::find_if_not(lines, [](const ClassicLine& line) {
    return std::holds_alternative<ClassicDelete>(line.what);
  });
  if (action != lines.end() && IsDestroy(*action)) std::rotate(lines.begin(), action, action + 1);
}

/// Simulates the symbolic state (present objects, holds, controls) line by line and rejects what is
/// impossible. Completes actions whose object only earlier or later lines specify.
class Consistency {
 public:
  explicit Consistency(const ClassicLimits& limits) : limits_(limits) {}

  /// @throws InputError at the first contradiction.
  void Check(ClassicFile* segment, bool is_first) {
    segment_ = segment;
    PutDestroyFirst(segment);
    if (!is_first && (segment->lines.empty() || !BeginsSegment(segment->lines[0]))) {
      // A segment after the first one exists only because of what its first line reports.
      Fail(segment->lines.empty() ? 0 : segment->lines[0].number,
           "found no action, expected grasp, release, destroy, trigger, pointTo, fasten, loosen, "
           "create or delete in the first line of a segment");
    }
    // Frames never decrease, over all segments; an action may stand only in the first line, except
    // for holds in segment 0.
    for (std::size_t i = 0; i < segment->lines.size(); ++i) {
      line_ = &segment->lines[i];
      if (line_->frame < frame_) {
        Fail("found frame " + std::to_string(line_->frame) + " after frame " +
             std::to_string(frame_));
      }
      frame_ = line_->frame;
      if (OpensSegment(*line_) && !(is_first ? IsHold(*line_) : i == 0)) {
        Fail("found another action, expected one per segment, in its first line");
      }
      if (IsDestroy(*line_)) FindDestroyed(i);
      std::visit([this](auto& what) { Follow(&what); }, line_->what);
    }
  }

 private:
  [[noreturn]] void Fail(int number, const std::string& message) const {
    throw InputError({segment_->file, number, "", message});
  }
  [[noreturn]] void Fail(const std::string& message) const { Fail(line_->number, message); }

  /// True for an object that a hand holds when the recording begins. Segment 0 describes the start;
  /// a grasp in it, at frame 0, happened before the recording.
  static bool IsHold(const ClassicLine& line) {
    return line.frame == 0 && ActionIn(line)->kind == sim::EventKind::kGrasped;
  }

  void RequirePresent(const std::string& object) const {
    if (!present_.contains(object))
      Fail(Quoted(object) + " does not exist, expected a create line before");
  }

  /// Sets the object of a destroy action, which only the following delete specifies.
  void FindDestroyed(std::size_t i) {
    // PutDestroyFirst() has put the action directly before its deletes.
    const auto* gone = i + 1 < segment_->lines.size()
                           ? std::get_if<ClassicDelete>(&segment_->lines[i + 1].what)
                           : nullptr;
    if (gone == nullptr) Fail("found no delete after destroy, expected one that names the object");
    std::get<ClassicAction>(line_->what).object = gone->object;
  }

  void Follow(const ClassicCreate* create) {
    if (!present_.insert(create->object).second) {
      Fail(Quoted(create->object) + " is created, but already exists");
    }
    // An object may be created again after its deletion, hence two sets: what exists now, and what
    // the limit counts.
    created_.insert(create->object);
    if (created_.size() > limits_.max_objects) {
      Fail("contains more than " + std::to_string(limits_.max_objects) + " objects");
    }
  }
  void Follow(const ClassicDelete* gone) {
    RequirePresent(gone->object);
    present_.erase(gone->object);
    // The controls of a deleted object are gone as well.
    std::erase_if(object_of_,
                  [gone](const auto& control) { return control.second == gone->object; });
  }
  void Follow(const ClassicMove* move) { RequirePresent(move->object); }
  void Follow(const ClassicControl* control) {
    RequirePresent(control->object);
    object_of_[control->control] = control->object;
  }
  void Follow(ClassicControlChange* change) { change->object = ObjectOf(change->control); }
  // A change names its control only; the object comes from the control's initialization.
  const std::string& ObjectOf(const std::string& control) const {
    const auto found = object_of_.find(control);
    if (found != object_of_.end()) return found->second;
    Fail(Quoted(control) + " is not a control, expected its initialization before");
  }
  void Follow(ClassicEffect* effect) {
    if (!effect->control.empty()) effect->object = ObjectOf(effect->control);
    if (!effect->by.empty()) RequirePresent(effect->by);
  }
  void Follow(ClassicAction* action) {
    using enum sim::EventKind;
    if (action->kind == kReleased || action->kind == kDestroyed) {
      // A release does not name its object: it is the one that this hand grasped last. A release
      // without an earlier grasp is accepted; it names no object (docs/importing.md).
      const auto held = held_.find(action->hand);
      if (held != held_.end()) {
        if (action->object.empty()) action->object = held->second;
        held_.erase(held);
      }
      return;
    }
    if (action->kind == kTriggered) action->object = ObjectOf(action->control);
    RequirePresent(action->object);
    if (action->kind == kGrasped) held_[action->hand] = action->object;
    if (!action->host_object.empty()) RequirePresent(action->host_object);
  }

  const ClassicLimits& limits_;
  ClassicFile* segment_ = nullptr;
  ClassicLine* line_ = nullptr;
  std::uint64_t frame_ = 0;
  std::set<std::string> present_, created_;
  std::map<std::string, std::string> object_of_;  ///< of each control
  std::map<demonstrator::HandName, std::string> held_;
};

/// Returns 12 for `12.txt`; nullopt for other names, such as `012.txt`, which the original does not
/// write.
std::optional<std::uint64_t> NumberOf(const std::filesystem::path& path,
                                      std::string_view extension) {
  const std::string name = path.filename().string();
  if (!name.ends_with(extension)) return std::nullopt;
  const std::string digits = name.substr(0, name.size() - extension.size());
  std::uint64_t number = 0;
  const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (result.ec != std::errc() || std::to_string(number) != digits) return std::nullopt;
  return number;
}

[[noreturn]] void Refuse(const std::filesystem::path& path, const std::string& message) {
  throw InputError({path.string(), 0, "", message});
}

/// Refuses links: a copy of the recording would contain files from elsewhere, which its sender may
/// not want to share.
void RequireNoLink(const std::filesystem::directory_entry& entry) {
  std::error_code error;
  if (entry.is_symlink(error)) Refuse(entry.path(), "is a link, expected the file itself");
}

std::filesystem::directory_iterator FilesIn(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::directory_iterator files(directory, error);
  if (error) throw std::runtime_error(directory.string() + ": " + error.message());
  return files;
}

/// Reads 0.txt, 1.txt, … without gaps, all together within the limit of bytes.
std::vector<ClassicText> ReadTexts(const std::filesystem::path& directory,
                                   const ClassicLimits& limits) {
  // A set, since a directory lists 10.txt before 2.txt or in any other order.
  std::set<std::uint64_t> numbers;
  for (const auto& entry : FilesIn(directory)) {
    const auto number = NumberOf(entry.path(), ".txt");
    if (!number) continue;
    RequireNoLink(entry);
    numbers.insert(*number);
    if (numbers.size() > limits.max_segments) {
      Refuse(directory, "has more than " + std::to_string(limits.max_segments) + " segments");
    }
  }
  std::vector<ClassicText> texts;
  std::size_t bytes_left = limits.max_bytes;
  for (std::uint64_t number : numbers) {
    if (number != texts.size()) {
      Refuse(directory, "has " + std::to_string(number) + ".txt, but no " +
                            std::to_string(texts.size()) + ".txt");
    }
    const auto path = directory / (std::to_string(number) + ".txt");
    // ReadFile() fails beyond the bytes that are left, so all texts together stay within the limit.
    texts.push_back({path.string(), ReadFile(path, bytes_left)});
    bytes_left -= texts.back().text.size();
  }
  if (texts.empty()) {
    Refuse(directory,
           "has no 0.txt, expected a classic recording: 0.txt, 1.txt, … and a folder of pictures "
           "for each");
  }
  return texts;
}

/// Lists the numbered pictures of each segment's folder, sorted by segment and frame.
void FindPictures(const std::filesystem::path& directory, const ClassicLimits& limits,
                  ClassicRecording* recording) {
  std::error_code error;
  for (std::size_t segment = 0; segment < recording->segments.size(); ++segment) {
    const std::filesystem::directory_entry folder(directory / std::to_string(segment), error);
    // Pictures are optional, and so are their folders.
    if (!folder.exists(error)) continue;
    RequireNoLink(folder);
    if (!folder.is_directory(error))
      Refuse(folder.path(), "is not a folder, expected a folder of pictures");
    for (const auto& entry : FilesIn(folder.path())) {
      const auto frame = NumberOf(entry.path(), ".png");
      if (!frame) continue;
      RequireNoLink(entry);
      if (*frame > limits.max_frame || !entry.is_regular_file(error) ||
          entry.file_size(error) > limits.max_picture_bytes) {
        Refuse(entry.path(), "is not a picture of a frame, expected a file of at most " +
                                 std::to_string(limits.max_picture_bytes) +
                                 " bytes and a frame of at most " +
                                 std::to_string(limits.max_frame));
      }
      recording->pictures.push_back({segment, *frame});
    }
  }
  std::sort(recording->pictures.begin(), recording->pictures.end());
}

/// Checks that all pictures have the same size, from their headers only.
void MeasurePictures(const std::filesystem::path& directory, ClassicRecording* recording) {
  for (const ClassicPicture& picture : recording->pictures) {
    const auto path =
        directory / std::to_string(picture.segment) / (std::to_string(picture.frame) + ".png");
    // Films and the eye of the imported recording have one size.
    const std::optional<PngSize> size = ReadPngSize(path);
    if (!size) Refuse(path, "is not a readable PNG of at most 8192 pixels per side");
    const bool is_first = recording->picture_width_px == 0;
    if (!is_first && (size->width_px != recording->picture_width_px ||
                      size->height_px != recording->picture_height_px)) {
      Refuse(path, "is " + std::to_string(size->width_px) + "x" + std::to_string(size->height_px) +
                       " pixels, expected " + std::to_string(recording->picture_width_px) + "x" +
                       std::to_string(recording->picture_height_px) + " as the first picture");
    }
    recording->picture_width_px = size->width_px;
    recording->picture_height_px = size->height_px;
  }
}

}  // namespace

std::uint64_t ClassicRecording::last_frame() const {
  std::uint64_t last = 0;
  for (const ClassicFile& segment : segments) {
    if (!segment.lines.empty()) last = std::max(last, segment.lines.back().frame);
  }
  // Frames never decrease, so the last line of a segment has its greatest frame; pictures may
  // follow it.
  for (const ClassicPicture& picture : pictures) last = std::max(last, picture.frame);
  return last;
}

std::vector<std::string> ClassicRecording::Objects() const {
  std::vector<std::string> objects;
  std::set<std::string> known;
  for (const ClassicFile& segment : segments) {
    for (const ClassicLine& line : segment.lines) {
      const auto* create = std::get_if<ClassicCreate>(&line.what);
      if (create != nullptr && known.insert(create->object).second) {
        objects.push_back(create->object);
      }
    }
  }
  return objects;
}

ClassicRecording ReadClassicTexts(std::span<const ClassicText> texts, const ClassicLimits& limits) {
  ClassicRecording recording;
  std::vector<Diagnostic> findings;
  for (const ClassicText& text : texts) {
    recording.segments.push_back(ReadSegment(text, limits, &findings));
  }
  // Consistency makes sense only if every line is well-formed.
  if (!findings.empty()) throw InputError(std::move(findings));
  Consistency consistency(limits);
  for (ClassicFile& segment : recording.segments) {
    consistency.Check(&segment, &segment == &recording.segments.front());
  }
  return recording;
}

ClassicRecording ReadClassic(const std::filesystem::path& directory, const ClassicLimits& limits) {
  std::error_code error;
  if (!std::filesystem::is_directory(directory, error)) {
    Refuse(directory, "is not a directory, expected the directory of a classic recording");
  }
  // Recordings of this program contain the same texts; an import would lose commands and physics.
  if (recording::IsRecording(directory)) {
    Refuse(directory, "has a demo.json: it is already a recording and does not need an import");
  }
  ClassicRecording recording = ReadClassicTexts(ReadTexts(directory, limits), limits);
  FindPictures(directory, limits, &recording);
  MeasurePictures(directory, &recording);
  return recording;
}

}  // namespace smile::classic
