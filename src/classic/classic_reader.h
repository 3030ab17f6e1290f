#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "math/rigid_transform.h"
#include "scene/scene_spec.h"
#include "sim/event.h"

namespace smile::classic {

// A classic recording as plain values, as it is written: lengths in units, angles in degrees. What
// the lines mean: docs/recording-format.md, "The classic view".

struct ClassicCreate {
  std::string object;
  std::vector<scene::Description> descriptions;  ///< as written; none for objects of the menus
};

struct ClassicDelete {
  std::string object;
};

struct ClassicMove {
  std::string object;
  Vector3 position = Vector3::Zero();    ///< [units]
  Vector3 angles_deg = Vector3::Zero();  ///< see RotationFromFixedAxes()
};

struct ClassicControl {
  std::string control, kind, object, state;
};

struct ClassicControlChange {
  std::string control, state;
  std::string object;  ///< that has the control
};

struct ClassicAction {
  sim::EventKind kind = sim::EventKind::kGrasped;
  demonstrator::HandName hand = demonstrator::HandName::kAny;
  /// Object of the action. For a release, the one that the hand grasped last, empty if the
  /// recording does not contain it; for a bond, the guest's; for a trigger, the one that has the
  /// control.
  std::string object;
  std::string part, control;
  std::string verb;  ///< of a tool, which is the object
  std::string host, host_object, guest;
  int tightness = 0;
  std::vector<std::string> properties;
};

/// A press by contact, or the use of a tool without a command of a hand. It begins no segment.
struct ClassicEffect {
  sim::EventKind kind = sim::EventKind::kPressed;  ///< or kUsed
  std::string arm;                                 ///< whose gripper did it; empty: no arm
  std::string by;                                  ///< object that pressed, or tool; may be empty
  std::string control;                             ///< that was pressed
  std::string verb, part;                          ///< what the tool did, and in words to what
  std::string object;                              ///< that has the control
};

struct ClassicLine {
  int number = 0;           ///< in its file; 1 is the first
  std::uint64_t frame = 0;  ///< for an action: the following one
  std::variant<ClassicCreate, ClassicDelete, ClassicMove, ClassicControl, ClassicControlChange,
               ClassicAction, ClassicEffect>
      what;
};

/// The lines of a segment.
struct ClassicFile {
  std::string file;  ///< as messages name it
  std::vector<ClassicLine> lines;
};

struct ClassicPicture {
  std::size_t segment = 0;
  std::uint64_t frame = 0;

  auto operator<=>(const ClassicPicture&) const = default;
};

/// Valid classic recording: objects that move, are grasped or deleted have been created, and frames
/// never decrease.
struct ClassicRecording {
  std::vector<ClassicFile> segments;     ///< by their numbers
  std::vector<ClassicPicture> pictures;  ///< sorted; all of one size
  int picture_width_px = 0, picture_height_px = 0;

  std::uint64_t last_frame() const;
  /// Returns the ids, in the order in which they were first created.
  std::vector<std::string> Objects() const;
};

/// Limits on the cost of a classic recording; each limit, if exceeded, is an error.
struct ClassicLimits {
  std::size_t max_bytes = 64u << 20;  ///< of all texts together
  std::size_t max_line_bytes = 64u << 10;
  std::size_t max_segments = 100'000;
  std::uint64_t max_frame = 100'000;  ///< seven hours
  std::size_t max_objects = 2'000;
  std::uintmax_t max_picture_bytes = 64u << 20;  ///< of each
};

/// Reads a classic recording: `0.txt`, `1.txt`, … with a folder of pictures for each. Links are
/// refused; other files are ignored.
/// @throws InputError with all lines that are malformed; if none is, with the first that
///         contradicts those before it.
/// @throws std::runtime_error with path and reason if a file cannot be read.
ClassicRecording ReadClassic(const std::filesystem::path& directory,
                             const ClassicLimits& limits = {});

struct ClassicText {
  std::string file;  ///< as messages name it
  std::string text;
};

/// Parses the texts of the segments, without pictures.
ClassicRecording ReadClassicTexts(std::span<const ClassicText> texts,
                                  const ClassicLimits& limits = {});

}  // namespace smile::classic
