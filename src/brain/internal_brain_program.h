#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "brain/brain_process.h"
#include "brain/internal_rendezvous.h"
#include "process/child_process.h"

namespace smile::brain {

/// Where a brain lies and how it is started.
struct BrainProgram {
  std::filesystem::path folder;             ///< absolute
  std::filesystem::path working_directory;  ///< the folder's parent
  std::string folder_name;                  ///< within the working directory, ending in `/`
  std::filesystem::path main_file;          ///< absolute: agentBehavior.m, or the file itself
  Rendezvous::Kind rendezvous = Rendezvous::Kind::kSocket;
  process::ChildCommand command;             ///< without the address, which is not known yet
  std::vector<std::string> debug_arguments;  ///< instead of the command's, under a debugger
  std::string debug_hint;                    ///< what to type there
};

/// @throws InputError when there is no such brain, or none that can be run.
/// @throws std::runtime_error when what runs it (Octave, our client) is not installed.
BrainProgram FindBrainProgram(const std::filesystem::path& brain, BrainTransport transport);

/// What a person types to start this program under a debugger: one line for a shell, between lines
/// that say so.
std::string HowToAttach(const BrainProgram& program, const process::ChildCommand& command);

}  // namespace smile::brain
