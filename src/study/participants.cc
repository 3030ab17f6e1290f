#include "study/participants.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <utility>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/json_node.h"
#include "web_server/digest.h"
#include "web_server/secret.h"

namespace smile::study {
namespace {

namespace fs = std::filesystem;

constexpr const char* kStudyFile = "study.json";
constexpr const char* kTokenFile = "token";
constexpr std::size_t kMaxSmallFile = 64 << 10;

}  // namespace

std::string ParticipantId(int number) {
  std::array<char, 16> text{};
  std::snprintf(text.data(), text.size(), "P%02d", number);
  return text.data();
}

StudyData StudyData::OpenOrMake(const fs::path& folder, const fs::path& definition_file,
                                const Definition& study) {
  const fs::path file = folder / kStudyFile;
  if (!fs::exists(file)) {
    MakeDirectories(folder);
    const Json made{{"definition", fs::absolute(definition_file).lexically_normal().string()},
                    {"sha256", web_server::Sha256(study.text)},
                    {"issued", 0}};
    WriteFile(file, ToText(made, 2) + "\n");
  }
  StudyData data(folder);
  if (data.study_.text != study.text) {
    throw InputError(Diagnostic{.file = file.string(),
                                .element = "definition",
                                .message = "belongs to " + data.definition_file_.string() +
                                           ", expected " + definition_file.string()});
  }
  return data;
}

StudyData::StudyData(fs::path folder) : folder_(std::move(folder)) {
  const std::string file = (folder_ / kStudyFile).string();
  Json json;
  try {
    json = ParseJson(ReadFile(file, kMaxSmallFile));
  } catch (const std::invalid_argument& error) {
    throw InputError(Diagnostic{.file = file, .message = error.what()});
  }
  const JsonNode node(json, file, "");
  definition_file_ = node.Member("definition").String();
  num_issued_ = static_cast<int>(node.Member("issued").Whole(0, kMaxParticipants));
  study_ = ReadDefinition(definition_file_);
  // Participants of one study have the same study.
  if (node.Member("sha256").String() != web_server::Sha256(study_.text)) {
    node.Member("sha256").Fail(definition_file_.string() +
                               " was changed since its first participant; expected it unchanged, "
                               "or another folder for the data of the changed study");
  }
  ReadParticipants();
}

void StudyData::ReadParticipants() {
  participants_.clear();
  for (int number = 1; number <= num_issued_; ++number) {
    const fs::path folder = folder_ / ParticipantId(number);
    // The number of one who withdrew is not given to another one.
    if (!fs::is_directory(folder)) continue;
    participants_.push_back({.number = number,
                             .id = ParticipantId(number),
                             .token = ReadFile(folder / kTokenFile, kMaxSmallFile),
                             .folder = folder});
  }
}

void StudyData::WriteIssued() const {
  const Json json{{"definition", definition_file_.string()},
                  {"sha256", web_server::Sha256(study_.text)},
                  {"issued", num_issued_}};
  WriteFile(folder_ / kStudyFile, ToText(json, 2) + "\n");
}

void StudyData::Add(int count) {
  if (count < 0 || count > kMaxParticipants - num_issued_) {
    throw std::invalid_argument("found " + std::to_string(count) +
                                " more participants, expected 0 to " +
                                std::to_string(kMaxParticipants - num_issued_));
  }
  for (int k = 0; k < count; ++k) {
    const fs::path folder = folder_ / ParticipantId(num_issued_ + 1);
    MakeDirectories(folder);
    WriteFile(folder / "events.jsonl", "");
    WriteFile(folder / kTokenFile, web_server::RandomSecret());
    ++num_issued_;
    // Last, so that a number that was issued has all its files.
    WriteIssued();
  }
  ReadParticipants();
}

const Participant* StudyData::FindByToken(std::string_view token) const {
  const auto found = std::ranges::find(participants_, token, &Participant::token);
  return found == participants_.end() ? nullptr : &*found;
}

const Participant* StudyData::FindById(std::string_view id) const {
  const auto found = std::ranges::find(participants_, id, &Participant::id);
  return found == participants_.end() ? nullptr : &*found;
}

}  // namespace smile::study
