#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "study/definition.h"

namespace smile::study {

/// A participant: a pseudonym, and the secret of a link.
struct Participant {
  int number = 0;  ///< from 1 on; determines the order of conditions
  std::string id;  ///< `P01`
  std::string token;
  std::filesystem::path folder;

  std::filesystem::path events_file() const { return folder / "events.jsonl"; }
};

/// Returns `P01`.
std::string ParticipantId(int number);

/// Data of a study, in a folder: `study.json` names the definition, `P01`, `P02`, … belong to one
/// participant each. Nothing in it says who that is.
class StudyData {
 public:
  /// Opens a folder, which is made if it does not exist.
  /// @param study  as read from `definition_file`.
  /// @throws InputError if the folder belongs to another study, or to this one before it was
  /// changed.
  static StudyData OpenOrMake(const std::filesystem::path& folder,
                              const std::filesystem::path& definition_file,
                              const Definition& study);
  /// Opens an existing folder.
  /// @throws InputError if it is none, or if the definition was changed since.
  explicit StudyData(std::filesystem::path folder);

  const Definition& study() const { return study_; }
  const std::filesystem::path& folder() const { return folder_; }
  /// In the order of their numbers.
  const std::vector<Participant>& participants() const { return participants_; }
  /// Returns the number of participants that were ever added.
  int num_issued() const { return num_issued_; }

  /// Adds participants, with the next numbers and new secrets.
  /// @throws std::invalid_argument beyond kMaxParticipants.
  void Add(int count);
  /// Returns the participant with a token or an id; nullptr if there is none.
  const Participant* FindByToken(std::string_view token) const;
  const Participant* FindById(std::string_view id) const;

  static constexpr int kMaxParticipants = 999;

 private:
  void ReadParticipants();
  void WriteIssued() const;

  std::filesystem::path folder_, definition_file_;
  Definition study_;
  std::vector<Participant> participants_;
  int num_issued_ = 0;
};

/// Name of the folder of tables and report in the data of a study.
inline constexpr const char* kReportFolder = "report";

}  // namespace smile::study
