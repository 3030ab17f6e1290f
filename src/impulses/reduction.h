#pragma once

#include <span>
#include <vector>

#include "impulses/contact_solver.h"

namespace smile::impulses {

/// Chooses the contacts of two bodies that hold them as all would: where many lie in one plane, the
/// outermost ones and the deepest. A ring on a table has 128 contacts, of which it needs 8.
///
/// Those that bore something in the last step are preferred, so that the choice does not alternate
/// between contacts that are equally far out.
/// @returns ascending indices.
std::vector<int> ChooseContacts(std::span<const Contact> contacts);

}  // namespace smile::impulses
