#include "scene_xml/internal_xml_text.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <optional>

#include "base/wording.h"
#include "math/angles.h"
#include "scene_xml/internal_units.h"
#include "scene_xml/internal_values.h"

// Text of XML as one appends it. Nothing is checked against the language of scenes; the property
// tests read everything back and compare bits.

namespace smile::scene_xml {
namespace {

// Numbers of digits to try for angles: conversion leaves an error in the last digits of an angle
// that was round in the file.
constexpr int kAngleDigits[] = {9, 12, 13, 14, 15, 17};

std::string Rounded(double angle_deg, int num_digits) {
  char buffer[64];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, angle_deg + 0.0,
                                 std::chars_format::general, num_digits);
  return {buffer, end.ptr};
}

/// Returns the angles of R as text, if reading it returns exactly `R`; nullopt otherwise.
std::optional<std::string> AnglesText(const Matrix3& R) {
  const Vector3 angles_deg = FixedAxesAngles(R);
  for (int num_digits : kAngleDigits) {
    std::string text = "(";
    Vector3 read_back;
    for (int i = 0; i < 3; ++i) {
      const std::string angle = Rounded(angles_deg[i], num_digits);
      read_back[i] = *ParseNumber<double>(angle);
      text += (i ? "," : "") + angle;
    }
    // Compared as the reader will compute it, to the last bit: a rotation that angles only
    // approximate would make a replay differ.
    if (RotationFromFixedAxes(read_back) == R) return text + ")";
  }
  return std::nullopt;
}

/// Returns an angle in degrees whose conversion returns the same radians, if there is such a
/// number.
std::string AngleText(double angle) {
  const double angle_deg = RadiansToDegrees(angle);
  for (int num_digits : kAngleDigits) {
    std::string text = Rounded(angle_deg, num_digits);
    if (DegreesToRadians(*ParseNumber<double>(text)) == angle) return text;
  }
  // Rounding of the conversion can miss the number by a few units in the last place: tries its
  // neighbors.
  constexpr int kNeighbours = 8;
  double below = angle_deg, above = angle_deg;
  for (int i = 0; i < kNeighbours; ++i) {
    below = std::nextafter(below, -std::numeric_limits<double>::infinity());
    above = std::nextafter(above, std::numeric_limits<double>::infinity());
    if (DegreesToRadians(below) == angle) return NumberText(below);
    if (DegreesToRadians(above) == angle) return NumberText(above);
  }
  return NumberText(angle_deg);
}

/// Returns nine numbers in parentheses, row by row.
std::string MatrixText(const Matrix3& R) {
  std::string text;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      text += (text.empty() ? "(" : ",") + NumberText(R(row, column));
    }
  }
  return text + ")";
}

}  // namespace

XmlText::XmlText(double meters_per_unit, std::vector<MeshFile> mesh_files)
    : meters_per_unit_(meters_per_unit), mesh_files_(std::move(mesh_files)) {}

std::string XmlText::FileOf(const scene::Custom& custom) const {
  for (const MeshFile& file : mesh_files_) {
    // The same object in memory: MeshFilesOf() has listed each mesh once.
    if (file.mesh == custom.mesh) return std::string(kMeshFolder) + "/" + file.name;
  }
  return custom.file;
}

void XmlText::Length(std::string_view name, double meters) { Attribute(name, Units(meters)); }
void XmlText::Angle(std::string_view name, double angle) { Attribute(name, AngleText(angle)); }

void XmlText::Spans(const Vector3& size) {
  Length("xspan", size.x());
  Length("yspan", size.y());
  Length("zspan", size.z());
}

void XmlText::Point(std::string_view name, const Vector3& p) {
  Attribute(name, "(" + Units(p.x()) + "," + Units(p.y()) + "," + Units(p.z()) + ")");
}

void XmlText::Direction(std::string_view name, const Vector3& direction) {
  Attribute(name, "(" + NumberText(direction.x()) + "," + NumberText(direction.y()) + "," +
                      NumberText(direction.z()) + ")");
}

void XmlText::Pose(const RigidTransform& X_PE) {
  Point("location", X_PE.translation());
  if (const std::optional<std::string> angles = AnglesText(X_PE.rotation())) {
    Attribute("rotation", *angles);
  } else {
    // Longer and hard to read, but always exact.
    Attribute("rotationMatrix", MatrixText(X_PE.rotation()));
  }
}

std::string XmlText::Units(double meters) const { return UnitsText(meters, meters_per_unit_); }

}  // namespace smile::scene_xml
