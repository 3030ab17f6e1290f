#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace smile::scene_xml {

/// Both ends belong to the range.
template <class Number>
struct Range {
  Number least, most;
};

// Ranges of the attributes of the scene language, in the unit of the file. The reader checks with
// these definitions, and the schemas of values in scenes/schema are generated from them
// (tests/schema).

// Far beyond any table, but small enough that no sum or square of them overflows.
inline constexpr Range<long double> kSpanUnits{0.001L, 1e6L};
inline constexpr Range<long double> kLocationUnits{-1e6L, 1e6L};
inline constexpr Range<double> kMetersPerUnitRange{1e-12, 1000};
// Beyond, a double holds too few digits of an angle to make a clean rotation of it.
inline constexpr Range<double> kAngleDegrees{-1e6, 1e6};
inline constexpr Range<double> kMassKilograms{0, 1e6};
inline constexpr Range<double> kLinkMassKilograms{1e-6, 1e6};
inline constexpr Range<double> kFriction{0, 10};
/// Restitution, damping, softness.
inline constexpr Range<double> kProportion{0, 1};
// Beyond, a button would stand on its edge.
inline constexpr Range<double> kButtonDegrees{0, 90};
/// Beyond, hardly anything on a table could press.
inline constexpr Range<double> kPressNewtons{0.01, 10000};
inline constexpr Range<double> kPressDegrees{1, 89};
inline constexpr Range<double> kTurnDegrees{5, 3600};
inline constexpr Range<double> kToolDegrees{0.1, 90};
inline constexpr Range<double> kFieldOfViewDegrees{1, 170};
/// Of an offset, which is small.
inline constexpr Range<double> kViewScale{0.5, 2};
/// Beyond, nearly all would be white.
inline constexpr Range<double> kBrightness{0, 4};
/// Values of `pattern`, in the order of scene::TablePattern.
inline constexpr std::array<std::string_view, 3> kTablePatterns{"plain", "stripes", "checks"};

inline constexpr int kMaxStates = 256;  ///< of one control
inline constexpr int kMaxLights = 256;  ///< of one control
inline constexpr int kMaxStages = 256;  ///< of tightness, of one host point
inline constexpr int kMaxLinks = 1000;  ///< of one chain
inline constexpr Range<int> kNumStates{1, kMaxStates};
inline constexpr Range<int> kStates{0, kMaxStates - 1};
/// -1 means no change; a state of the control, which may have fewer.
inline constexpr Range<int> kNextStates{-1, kMaxStates - 1};
inline constexpr Range<int> kNumLights{1, kMaxLights};
/// A light of the control, which may have fewer.
inline constexpr Range<int> kLights{0, kMaxLights - 1};
/// 0 means not fastened.
inline constexpr Range<int> kTightness{0, kMaxStages};
/// 0 means as many as fit.
inline constexpr Range<int> kNumLinks{0, kMaxLinks};
inline constexpr Range<int> kCylinderSides{3, 4096};
inline constexpr Range<int> kPolygonSides{3, 1024};

inline constexpr int kMaxToolPlaces = 16;  ///< of one guest point
/// Values of `cut`.
inline constexpr std::array<std::string_view, 2> kNoYes{"no", "yes"};
/// Values of `by`.
inline constexpr std::array<std::string_view, 2> kHandTool{"hand", "tool"};

inline constexpr std::size_t kMaxIdBytes = 100;  ///< ids appear in every log line and label
inline constexpr std::size_t kMaxRenameDigits = 10;
inline constexpr std::size_t kMaxBondTypeBytes = 100;

}  // namespace smile::scene_xml
