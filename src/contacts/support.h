#pragma once

#include <span>

#include "contacts/contact_solver.h"

namespace smile::contacts {

/// Returns true if the bodies have not moved along the plane of a contact since they touched.
bool IsUnmoved(const Contact& contact);

/// Returns true if one body stands firmly on the other: their contacts are where they were when the
/// bodies touched, and hold a body of this size [m] against tipping.
bool StandsFirmly(std::span<const Contact> contacts, double size);

}  // namespace smile::contacts
