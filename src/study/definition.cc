// The file is read in the order in which it is written. Every reader reports the element; the line
// is added in one place, ReadDefinition().

#include "study/definition.h"

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <stdexcept>

#include "base/diagnostic.h"
#include "base/files.h"
#include "base/wording.h"
#include "page/snap_names.h"
#include "scene_xml/scene_reader.h"
#include "study/internal_json_lines.h"

namespace smile::study {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxDefinitionBytes = 1 << 20, kMaxConsentBytes = 64 << 10;
constexpr std::size_t kMaxConditions = 12, kMaxTasks = 24, kMaxPages = 20, kMaxGoals = 100;
constexpr std::size_t kMaxNameBytes = 40, kMaxTitleBytes = 200, kMaxTextBytes = 8 << 10;
constexpr double kMaxLimitSeconds = 3600;
constexpr std::uint64_t kFormat = 1;

/// Returns a name that may stand in file names and in tables.
std::string NameIn(const JsonNode& node) {
  std::string name = node.ShortString(kMaxNameBytes);
  const bool is_simple =
      !name.empty() &&
      name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_") == std::string::npos;
  if (!is_simple) {
    node.Fail("found " + Quoted(name) + ", expected small letters, digits, - and _");
  }
  return name;
}

std::string TextIn(const JsonNode& node, const std::string& name, std::size_t max_bytes) {
  return node.Has(name) ? node.Member(name).ShortString(max_bytes) : "";
}

/// Returns the path of an existing file.
std::string FileIn(const JsonNode& node, const fs::path& folder) {
  std::string path = node.ShortString(kMaxTitleBytes);
  if (!fs::is_regular_file(folder / path)) node.Fail("found " + Quoted(path) + ", expected a file");
  return path;
}

/// Returns the path of an existing file, which is below the folder of the definition.
std::string PublicFileIn(const JsonNode& node, const fs::path& folder) {
  std::string path = FileIn(node, folder);
  // Participants may see these files: nothing else on this machine must be among them.
  if (fs::path(path).is_absolute() || !IsWithin(folder / path, folder)) {
    node.Fail("found " + Quoted(path) + ", expected a file below the folder of the study");
  }
  return path;
}

std::string FilmIn(const JsonNode& node, const fs::path& folder) {
  std::string path = PublicFileIn(node, folder);
  if (!path.ends_with(".mp4")) node.Fail("found " + Quoted(path) + ", expected an .mp4 file");
  return path;
}

/// Fails if a name occurs for the second time.
void ExpectNew(const JsonNode& node, const std::string& name, std::set<std::string>* names) {
  if (!names->insert(name).second) node.Fail("found " + Quoted(name) + " twice");
}

Aids ReadAids(const JsonNode& node) {
  Aids aids;
  if (node.Has("snap")) {
    for (const JsonNode& item : node.Member("snap").ItemsUpTo(page::kSnapNames.size())) {
      const std::string snap = item.String();
      if (std::ranges::find(page::kSnapNames, snap) == page::kSnapNames.end()) {
        item.Fail("found " + Quoted(snap) + ", expected " + OneOf(page::kSnapNames));
      }
      aids.snap.push_back(snap);
    }
  }
  if (node.Has("ghost")) aids.has_ghost = node.Member("ghost").Flag();
  if (node.Has("rings")) aids.has_rings = node.Member("rings").Flag();
  return aids;
}

std::vector<Condition> ReadConditions(const JsonNode& node) {
  static constexpr std::array<std::string_view, 5> kMembers{"name", "title", "snap", "ghost",
                                                            "rings"};
  std::vector<Condition> conditions;
  std::set<std::string> names;
  for (const JsonNode& item : node.ItemsUpTo(kMaxConditions)) {
    item.ExpectMembers(kMembers);
    Condition condition{.name = NameIn(item.Member("name")), .aids = ReadAids(item)};
    condition.title = item.Has("title") ? TextIn(item, "title", kMaxTitleBytes) : condition.name;
    ExpectNew(item.Member("name"), condition.name, &names);
    conditions.push_back(std::move(condition));
  }
  if (conditions.empty()) node.Fail("is empty, expected at least one condition");
  return conditions;
}

Instruction ReadInstruction(const JsonNode& node, const fs::path& folder) {
  static constexpr std::array<std::string_view, 4> kMembers{"title", "text", "picture", "film"};
  node.ExpectMembers(kMembers);
  Instruction read{.title = node.Member("title").ShortString(kMaxTitleBytes),
                   .text = TextIn(node, "text", kMaxTextBytes)};
  if (node.Has("picture")) {
    read.picture = PublicFileIn(node.Member("picture"), folder);
    if (!read.picture.ends_with(".png")) node.Member("picture").Fail("expected a .png file");
  }
  if (node.Has("film")) read.film = FilmIn(node.Member("film"), folder);
  return read;
}

/// Returns a relation such as `{"object": "Blue", "on": "Red"}`; `table` is the table.
model::Relation ReadRelation(const JsonNode& node, const std::set<std::string>& objects) {
  static constexpr std::array<std::string_view, 3> kMembers{"object", "on", "in"};
  node.ExpectMembers(kMembers);
  const auto object_in = [&](const std::string& name) {
    const std::string id = node.Member(name).ShortString(kMaxTitleBytes);
    if (!objects.contains(id)) {
      const std::vector<std::string_view> known(objects.begin(), objects.end());
      node.Member(name).Fail("found " + Quoted(id) + ", expected an object of the scene" +
                             DidYouMean(id, known));
    }
    return id;
  };
  if (node.Has("on") == node.Has("in")) node.Fail("expected either \"on\" or \"in\"");
  model::Relation relation{.object = object_in("object")};
  relation.kind = node.Has("on") ? model::Relation::Kind::kOn : model::Relation::Kind::kIn;
  if (node.Has("on") && node.Member("on").value() == "table") return relation;
  relation.support = object_in(node.Has("on") ? "on" : "in");
  return relation;
}

std::set<std::string> ObjectsIn(const JsonNode& scene, const fs::path& file) {
  std::set<std::string> ids;
  try {
    for (const scene::ObjectSpec& object : scene_xml::LoadScene(file).objects) {
      ids.insert(object.id());
    }
  } catch (const InputError& error) {
    scene.Fail(error.what());
  }
  return ids;
}

/// Reads the films of a task: one for all conditions, or one for each by name.
std::map<std::string, std::string> ReadFilms(const JsonNode& node, const Definition& study) {
  if (node.IsString()) return {{"", FilmIn(node, study.folder)}};
  std::map<std::string, std::string> films;
  std::vector<std::string_view> names;
  for (const Condition& condition : study.conditions) names.push_back(condition.name);
  node.ExpectMembers(names);
  for (const auto& [condition, film] : node.Members()) {
    films[condition] = FilmIn(film, study.folder);
  }
  return films;
}

StudyTask ReadTask(const JsonNode& node, const Definition& study) {
  StudyTask task{.text = node.Member("text").ShortString(kMaxTextBytes)};
  task.title = node.Member("title").ShortString(kMaxTitleBytes);
  task.scene = FileIn(node.Member("scene"), study.folder);
  const std::set<std::string> objects = ObjectsIn(node.Member("scene"), study.folder / task.scene);
  for (const JsonNode& item : node.Member("goal").ItemsUpTo(kMaxGoals)) {
    task.goal.push_back(ReadRelation(item, objects));
  }
  if (task.goal.empty()) node.Member("goal").Fail("is empty, expected at least one relation");
  if (node.Has("film")) task.films = ReadFilms(node.Member("film"), study);
  if (node.Has("limit_seconds")) {
    task.limit_seconds = node.Member("limit_seconds").Number(5, kMaxLimitSeconds);
  }
  return task;
}

Practice ReadPractice(const JsonNode& node, const Definition& study) {
  static constexpr std::array<std::string_view, 7> kMembers{
      "title", "text", "film", "scene", "goal", "limit_seconds", "max_attempts"};
  node.ExpectMembers(kMembers);
  Practice practice{.task = ReadTask(node, study)};
  practice.task.name = "practice";
  if (node.Has("max_attempts")) {
    practice.max_attempts = static_cast<int>(node.Member("max_attempts").Whole(1, 20));
  }
  return practice;
}

std::vector<StudyTask> ReadTasks(const JsonNode& node, const Definition& study) {
  static constexpr std::array<std::string_view, 7> kMembers{
      "name", "title", "text", "film", "scene", "goal", "limit_seconds"};
  std::vector<StudyTask> tasks;
  std::set<std::string> names{"practice"};
  for (const JsonNode& item : node.ItemsUpTo(kMaxTasks)) {
    item.ExpectMembers(kMembers);
    tasks.push_back(ReadTask(item, study));
    tasks.back().name = NameIn(item.Member("name"));
    ExpectNew(item.Member("name"), tasks.back().name, &names);
  }
  if (tasks.empty()) node.Fail("is empty, expected at least one task");
  return tasks;
}

std::vector<Questionnaire> ReadQuestionnaires(const JsonNode& node, std::set<std::string>* names) {
  std::vector<Questionnaire> read;
  for (const JsonNode& item : node.ItemsUpTo(kMaxPages)) {
    read.push_back(ReadQuestionnaire(item));
    ExpectNew(item, read.back().name, names);
  }
  return read;
}

/// Reads how tasks and conditions meet.
bool ReadTasksPerCondition(const JsonNode& study, const Definition& read) {
  if (!study.Has("tasks_per_condition")) return false;
  static constexpr std::array<std::string_view, 2> kWords{"all", "one"};
  const JsonNode node = study.Member("tasks_per_condition");
  const std::string word = node.String();
  if (std::ranges::find(kWords, word) == kWords.end()) {
    node.Fail("found " + Quoted(word) + ", expected " + OneOf(kWords));
  }
  if (word == "one" && read.tasks.size() != read.conditions.size()) {
    node.Fail("there are " + std::to_string(read.tasks.size()) + " tasks and " +
              std::to_string(read.conditions.size()) + " conditions, expected equal numbers");
  }
  return word == "one";
}

std::string ReadCompletionUrl(const JsonNode& node) {
  std::string url = node.ShortString(kMaxTitleBytes);
  if (!url.starts_with("https://")) {
    node.Fail("found " + Quoted(url) + ", expected an address that begins with https://");
  }
  return url;
}

void ReadPages(const JsonNode& node, Definition* read) {
  if (node.Has("instructions")) {
    for (const JsonNode& item : node.Member("instructions").ItemsUpTo(kMaxPages)) {
      read->instructions.push_back(ReadInstruction(item, read->folder));
    }
  }
  std::set<std::string> names;
  if (node.Has("after_condition")) {
    read->after_condition = ReadQuestionnaires(node.Member("after_condition"), &names);
  }
  if (node.Has("at_end")) read->at_end = ReadQuestionnaires(node.Member("at_end"), &names);
  if (node.Has("break_seconds")) {
    read->break_seconds = node.Member("break_seconds").Number(0, kMaxLimitSeconds);
  }
  read->thanks = TextIn(node, "thanks", kMaxTextBytes);
  if (node.Has("completion_url")) {
    read->completion_url = ReadCompletionUrl(node.Member("completion_url"));
  }
}

/// Returns the tag of a language that the page has.
std::string LanguageIn(const JsonNode& node) {
  static constexpr std::array<std::string_view, SMILE_NUM_PAGE_LANGUAGES> kLanguages{
      SMILE_PAGE_LANGUAGES};
  const std::string language = node.ShortString(kMaxTitleBytes);
  if (std::ranges::find(kLanguages, language) == kLanguages.end()) {
    node.Fail("found " + Quoted(language) + ", expected " + OneOf(kLanguages));
  }
  return language;
}

void Read(const JsonNode& node, Definition* read) {
  static constexpr std::array<std::string_view, 15> kMembers{"format",        "name",
                                                             "title",         "language",
                                                             "consent",       "conditions",
                                                             "instructions",  "practice",
                                                             "tasks",         "tasks_per_condition",
                                                             "break_seconds", "after_condition",
                                                             "at_end",        "thanks",
                                                             "completion_url"};
  node.ExpectMembers(kMembers);
  node.Member("format").Whole(kFormat, kFormat);
  read->name = NameIn(node.Member("name"));
  read->title = node.Member("title").ShortString(kMaxTitleBytes);
  if (node.Has("language")) read->language = LanguageIn(node.Member("language"));
  const JsonNode consent = node.Member("consent");
  read->consent = ReadFile(read->folder / PublicFileIn(consent, read->folder), kMaxConsentBytes);
  if (read->consent.empty()) consent.Fail("the file is empty, expected the text of the consent");
  read->conditions = ReadConditions(node.Member("conditions"));
  if (node.Has("practice")) read->practice = ReadPractice(node.Member("practice"), *read);
  read->tasks = ReadTasks(node.Member("tasks"), *read);
  read->has_one_task_per_condition = ReadTasksPerCondition(node, *read);
  ReadPages(node, read);
}

}  // namespace

Definition ReadDefinition(const fs::path& path) {
  const std::string file = path.string();
  Definition read{.folder = path.parent_path().empty() ? fs::path(".") : path.parent_path(),
                  .text = ReadFile(path, kMaxDefinitionBytes)};
  Json json;
  try {
    json = ParseJson(read.text);
  } catch (const std::invalid_argument& error) {
    throw InputError(Diagnostic{.file = file, .message = error.what()});
  }
  try {
    Read(JsonNode(json, file, ""), &read);
  } catch (const InputError& error) {
    std::vector<Diagnostic> diagnostics = error.diagnostics();
    for (Diagnostic& diagnostic : diagnostics) {
      // Faults within other files have an address already.
      if (diagnostic.file == file) diagnostic.line = LineOf(read.text, diagnostic.element);
    }
    throw InputError(diagnostics);
  }
  return read;
}

}  // namespace smile::study
