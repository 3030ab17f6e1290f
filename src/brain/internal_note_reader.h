#pragma once

#include <span>
#include <string>
#include <vector>

#include "brain/internal_matrix_reader.h"
#include "sim/note.h"

namespace smile::brain {

/// Returns true for the arrays that ReadNotes() reads: `notes`, `noteTops` and `noteCameras`.
bool IsOfNotes(const NamedArray& array);

/// Reads the notes in a message; none if it has none.
///
/// @param cameras  besides the eye, those whose pictures the brain receives: notes may be about
/// one.
std::vector<sim::Note> ReadNotes(const Message& message, std::span<const std::string> cameras,
                                 MatrixReader& reader);

}  // namespace smile::brain
