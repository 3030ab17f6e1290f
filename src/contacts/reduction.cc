#include "contacts/reduction.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "contacts/internal_plane.h"

namespace smile::contacts {
namespace {

/// Directions in which a plane's outermost contacts are chosen.
constexpr int kNumDirections = 8;
/// Contacts lie in one plane if their normals differ by less than this [cosine of 5 degrees].
constexpr double kSameNormal = 0.996;
/// A contact that bore something may be this much farther in, as part of the plane's extent.
constexpr double kPreference = 0.1;

/// Returns the index of the contact that is farthest in a direction, among those of a plane.
int FarthestAlong(const Vector3& direction, std::span<const int> plane,
                  std::span<const Contact> contacts) {
  const auto place = [&direction, contacts](int i) { return direction.dot(contacts[i].p_WB); };
  const auto [nearest, farthest] = std::ranges::minmax_element(plane, {}, place);
  const double bonus = kPreference * (place(*farthest) - place(*nearest));
  return *std::ranges::max_element(plane, {}, [&place, contacts, bonus](int i) {
    return place(i) + (contacts[i].impulse > 0 ? bonus : 0);
  });
}

void ChooseInPlane(std::span<const int> plane, std::span<const Contact> contacts,
                   std::set<int>* chosen) {
  if (plane.size() <= kNumDirections) {
    chosen->insert(plane.begin(), plane.end());
    return;
  }
  const auto distance = [contacts](int i) { return contacts[i].distance; };
  chosen->insert(*std::ranges::min_element(plane, {}, distance));
  const auto [first, second] = AxesOfPlane(contacts[plane.front()].normal);
  for (int k = 0; k < kNumDirections; ++k) {
    const double angle = 2 * std::numbers::pi * k / kNumDirections;
    chosen->insert(
        FarthestAlong(std::cos(angle) * first + std::sin(angle) * second, plane, contacts));
  }
}

}  // namespace

std::vector<int> ChooseContacts(std::span<const Contact> contacts) {
  std::vector<int> left(contacts.size());
  std::iota(left.begin(), left.end(), 0);
  if (contacts.size() <= kNumDirections) return left;
  std::set<int> chosen;
  while (!left.empty()) {
    // Those in the plane of the first one that is left come to the front, in their order.
    const Vector3& normal = contacts[left.front()].normal;
    const auto end = std::stable_partition(left.begin(), left.end(), [&normal, contacts](int i) {
      return contacts[i].normal.dot(normal) > kSameNormal;
    });
    // At least the first one itself: its normal may have lost its length.
    const auto rest = std::max(end, left.begin() + 1);
    ChooseInPlane({left.begin(), rest}, contacts, &chosen);
    left.erase(left.begin(), rest);
  }
  return {chosen.begin(), chosen.end()};
}

}  // namespace smile::contacts
