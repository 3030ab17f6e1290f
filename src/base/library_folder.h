#pragma once

#include <filesystem>

namespace smile {

/// Returns the folder of the shared library that contains this code, for example of a module that
/// Python has loaded; of the program, if it is linked into that. Absolute; empty if it is unknown.
std::filesystem::path LibraryFolder();

}  // namespace smile
