#include "contacts/reduction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "contacts/support.h"

namespace smile::contacts {
namespace {

/// Contacts on a circle around an axis.
std::vector<Contact> Circle(int count, const Vector3& normal, const Vector3& x, double radius) {
  std::vector<Contact> contacts;
  for (int i = 0; i < count; ++i) {
    const double angle = 2 * std::numbers::pi * i / count;
    contacts.push_back({.p_WB = radius * (std::cos(angle) * x + std::sin(angle) * normal.cross(x)),
                        .normal = normal});
  }
  return contacts;
}

TEST(ChooseContactsTest, ARingStandsOnEightAndTheDeepest) {
  std::vector<Contact> contacts = Circle(128, Vector3::UnitZ(), Vector3::UnitX(), 0.1);
  contacts[5].distance = -0.001;
  const std::vector<int> chosen = ChooseContacts(contacts);
  EXPECT_LE(chosen.size(), 9u);
  EXPECT_TRUE(std::ranges::is_sorted(chosen));
  EXPECT_TRUE(std::ranges::binary_search(chosen, 5));
  // No direction in which the ring could tip farther than over an octagon.
  for (int k = 0; k < 64; ++k) {
    const double angle = k * std::numbers::pi / 32;
    const Vector3 direction(std::cos(angle), std::sin(angle), 0);
    double farthest = 0;
    for (const int i : chosen) farthest = std::max(farthest, direction.dot(contacts[i].p_WB));
    EXPECT_GT(farthest, 0.1 * std::cos(std::numbers::pi / 7)) << k;
  }
}

TEST(ChooseContactsTest, EachPlaneIsHeldForItself) {
  std::vector<Contact> contacts = Circle(64, Vector3::UnitZ(), Vector3::UnitX(), 0.1);
  const std::vector<Contact> wall = Circle(3, Vector3::UnitX(), Vector3::UnitY(), 0.01);
  contacts.insert(contacts.begin() + 20, wall.begin(), wall.end());
  const std::vector<int> chosen = ChooseContacts(contacts);
  for (const int i : {20, 21, 22}) EXPECT_TRUE(std::ranges::binary_search(chosen, i)) << i;
  EXPECT_LE(chosen.size(), 12u);
}

TEST(ChooseContactsTest, TheChoiceStaysWithWhatBears) {
  std::vector<Contact> contacts = Circle(64, Vector3::UnitZ(), Vector3::UnitX(), 0.1);
  const std::vector<int> first = ChooseContacts(contacts);
  for (const int i : first) contacts[i].impulse = 1;
  // Another one is farther out by a little, as rounding may have it.
  for (std::size_t i = 1; i < contacts.size(); i += 2) contacts[i].p_WB *= 1.001;
  EXPECT_EQ(ChooseContacts(contacts), first);
}

TEST(StandsFirmlyTest, OnContactsThatSpanItAndHaveNotMoved) {
  std::vector<Contact> contacts = Circle(3, Vector3::UnitZ(), Vector3::UnitX(), 0.05);
  EXPECT_TRUE(StandsFirmly(contacts, 0.1));
  EXPECT_FALSE(StandsFirmly(contacts, 1)) << "they are the tip of something large";
  EXPECT_FALSE(StandsFirmly(std::span(contacts).first(2), 0.01)) << "an edge";

  contacts[1].p_BA_W = {2e-5, 0, 0};
  EXPECT_FALSE(IsUnmoved(contacts[1]));
  EXPECT_FALSE(StandsFirmly(contacts, 0.1)) << "one has slid";
  contacts[1].p_BA_W = {0, 0, 2e-4};
  contacts[1].distance = 2e-4;
  EXPECT_TRUE(IsUnmoved(contacts[1]));
  EXPECT_FALSE(StandsFirmly(contacts, 0.1)) << "one has lifted";
}

}  // namespace
}  // namespace smile::contacts
