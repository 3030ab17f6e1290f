#include "contacts/support.h"

#include <algorithm>
#include <cmath>

namespace smile::contacts {
namespace {

/// A contact has not moved while its two points are this close in its plane, and across it [m].
constexpr double kUnmovedAlong = 1e-5;
constexpr double kUnmovedAcross = 1e-4;
/// Contacts support a body if they span this part of its size: one that tips moves at some of them.
constexpr double kFirmSpan = 0.2;

/// Returns the height of the highest triangle of contacts over the line from the first of them to
/// the one farthest from it [m]; 0 for less than three.
double HeightOfTriangle(std::span<const Contact> contacts) {
  if (contacts.size() < 3) return 0;
  const auto from_first = [contacts](const Contact& contact) -> Vector3 {
    return contact.p_WB - contacts[0].p_WB;
  };
  Vector3 base = Vector3::Zero();
  for (const Contact& contact : contacts) {
    const Vector3 side = from_first(contact);
    if (side.squaredNorm() > base.squaredNorm()) base = side;
  }
  double highest = 0;
  for (const Contact& contact : contacts) {
    highest = std::max(highest, base.cross(from_first(contact)).squaredNorm());
  }
  return highest > 0 ? std::sqrt(highest / base.squaredNorm()) : 0;
}

}  // namespace

bool IsUnmoved(const Contact& contact) {
  const Vector3 along = contact.p_BA_W - contact.p_BA_W.dot(contact.normal) * contact.normal;
  return along.squaredNorm() < kUnmovedAlong * kUnmovedAlong;
}

bool StandsFirmly(std::span<const Contact> contacts, double size) {
  for (const Contact& contact : contacts) {
    if (std::abs(contact.distance) >= kUnmovedAcross || !IsUnmoved(contact)) return false;
  }
  return HeightOfTriangle(contacts) > kFirmSpan * size;
}

}  // namespace smile::contacts
