#include "recording/notes.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <sstream>
#include <stdexcept>

#include "base/files.h"
#include "base/json.h"

namespace smile::recording {
namespace {

Json JsonOf(const sim::NotedTop& top) {
  Json json = {{"middle", {top.middle.x(), top.middle.y(), top.middle.z()}},
               {"sides", {top.length, top.width}},
               {"yaw", top.yaw}};
  if (top.is_round) json["round"] = true;
  return json;
}

Json JsonOf(const std::vector<sim::NotedTop>& tops) {
  Json json = Json::array();
  for (const sim::NotedTop& top : tops) json.push_back(JsonOf(top));
  return json;
}

// Both throw Json::exception if a value is missing or has another type.
sim::NotedTop TopOf(const Json& json) {
  const Json& middle = json.at("middle");
  const Json& sides = json.at("sides");
  return {.middle = Vector3(middle.at(0).get<double>(), middle.at(1).get<double>(),
                            middle.at(2).get<double>()),
          .length = sides.at(0).get<double>(),
          .width = sides.at(1).get<double>(),
          .yaw = json.at("yaw").get<double>(),
          .is_round = json.value("round", false)};
}

std::vector<sim::NotedTop> TopsOf(const Json& json, const char* name) {
  std::vector<sim::NotedTop> tops;
  for (const Json& top : json.value(name, Json::array())) tops.push_back(TopOf(top));
  return tops;
}

std::optional<RecordedNote> NoteIn(const std::string& line) {
  try {
    const Json json = ParseJson(line);
    RecordedNote note{.tick = json.at("tick").get<std::uint64_t>(),
                      .note = {.word = json.at("note").get<std::string>(),
                               .text = json.at("text").get<std::string>(),
                               .expected = TopsOf(json, "expected"),
                               .found = TopsOf(json, "found"),
                               .camera = json.value("camera", "")}};
    const auto& words = sim::kNoteWords;
    if (std::ranges::find(words, note.note.word) == words.end()) return std::nullopt;
    return note;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  } catch (const Json::exception&) {
    return std::nullopt;
  }
}

}  // namespace

std::string LineOf(const RecordedNote& note) {
  Json json = {{"tick", note.tick}, {"note", note.note.word}, {"text", note.note.text}};
  if (!note.note.expected.empty()) json["expected"] = JsonOf(note.note.expected);
  if (!note.note.found.empty()) json["found"] = JsonOf(note.note.found);
  if (!note.note.camera.empty()) json["camera"] = note.note.camera;
  return ToText(json);
}

std::vector<RecordedNote> NotesOf(const Recording& recording) {
  constexpr std::size_t kMaxBytes = 16'000'000;  // more than is written
  const std::filesystem::path file = recording.directory / kNotesFile;
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return {};
  std::vector<RecordedNote> notes;
  std::istringstream text(ReadFile(file, kMaxBytes));
  for (std::string line; std::getline(text, line);) {
    if (auto note = NoteIn(line)) notes.push_back(*std::move(note));
  }
  return notes;
}

}  // namespace smile::recording
