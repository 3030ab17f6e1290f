#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "study/participants.h"

namespace smile::study {

/// Proof of a deletion: a search of all that is left of the data.
struct DeletionProof {
  std::size_t num_deleted = 0;       ///< files
  std::size_t num_searched = 0;      ///< files that are left, all of which were searched
  std::vector<std::string> remains;  ///< paths in which the token, or in texts the id, still occurs
};

/// Deletes everything of a participant who withdraws, and the tables and the report, which contain
/// that participant too; then searches the whole folder for the pseudonym and the token.
/// @throws InputError if there is no such participant; std::runtime_error with the path of a file
///         that cannot be deleted, or if a server is using the data.
DeletionProof DeleteParticipant(const StudyData& data, const std::string& id);

}  // namespace smile::study
