// Notes of a brain about its work: a text with one note on each line, and arrays that say more
// about them. A note is for people, but what it names must be there: the wrong number of a note or
// a misspelled camera is an error, like any other.

#include "brain/internal_note_reader.h"

#include <algorithm>
#include <sstream>

#include "base/wording.h"
#include "brain/brain_messages.h"

namespace smile::brain {
namespace {

/// Reads `word: sentence`.
sim::Note ReadNote(const NamedArray& array, const std::string& line, MatrixReader& reader) {
  const std::string printable = PrintableText(line, kMaxErrorLetters);
  const std::size_t colon = printable.find(':');
  sim::Note note{.word = printable.substr(0, colon)};
  if (colon == std::string::npos ||
      std::ranges::find(sim::kNoteWords, note.word) == sim::kNoteWords.end()) {
    reader.Fail(array.name + " contains " + Quoted(printable.substr(0, 100)) + ", expected " +
                OneOf(sim::kNoteWords) + ", a colon and a sentence");
    return note;
  }
  const std::size_t begin = printable.find_first_not_of(' ', colon + 1);
  if (begin != std::string::npos) note.text = printable.substr(begin);
  return note;
}

/// Reads notes, one on each line.
std::vector<sim::Note> ReadLines(const NamedArray& array, MatrixReader& reader) {
  constexpr std::size_t kMaxNotes = 1'000;
  std::vector<sim::Note> notes;
  const std::optional<std::string> text = array.Text();
  if (!text) {
    reader.Fail(array.name + " is no text, expected one note on each line");
    return notes;
  }
  std::istringstream stream(*text);
  for (std::string line; std::getline(stream, line) && reader.ok();) {
    notes.push_back(ReadNote(array, line, reader));
    if (notes.size() > kMaxNotes) {
      reader.Fail(array.name + " has more than " + std::to_string(kMaxNotes) + " lines");
    }
  }
  return notes;
}

/// Adds the tops of `noteTops`, one in each row, to the notes to which they belong.
void AddTops(const NamedArray& array, std::vector<sim::Note>* notes, MatrixReader& reader) {
  constexpr int kNumColumns = 9;
  if (array.data.empty()) return;  // `[]`
  const Eigen::MatrixXd rows = reader.Read(array, -1, kNumColumns);
  if (!reader.ok()) return;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const double number = rows(i, 0);
    if (!(number >= 1 && number <= static_cast<double>(notes->size()))) {
      reader.Fail(array.name + "(" + std::to_string(i + 1) + ",1) is " + NumberText(number) +
                  ", expected the number of a note, 1 to " + std::to_string(notes->size()));
      return;
    }
    sim::Note& note = (*notes)[static_cast<std::size_t>(number) - 1];
    (rows(i, 1) != 0 ? note.found : note.expected)
        .push_back({.middle = Vector3(rows(i, 2), rows(i, 3), rows(i, 4)),
                    .length = rows(i, 5),
                    .width = rows(i, 6),
                    .yaw = rows(i, 7),
                    .is_round = rows(i, 8) != 0});
  }
}

/// Adds the cameras of `noteCameras` to the notes, one on each line; an empty line is the eye.
void AddCameras(const NamedArray& array, std::span<const std::string> cameras,
                std::vector<sim::Note>* notes, MatrixReader& reader) {
  const std::optional<std::string> text = array.Text();
  if (!text) {
    reader.Fail(array.name + " is no text, expected the name of a camera on each line");
    return;
  }
  const std::vector<std::string_view> known(cameras.begin(), cameras.end());
  std::istringstream stream(*text);
  std::size_t k = 0;
  for (std::string line; std::getline(stream, line); ++k) {
    if (k == notes->size()) {
      reader.Fail(array.name + " has more lines than notes, expected at most " +
                  std::to_string(notes->size()));
      return;
    }
    if (!line.empty() && std::ranges::find(known, line) == known.end()) {
      reader.Fail(array.name + " contains " + Quoted(PrintableText(line, 100)) + ", expected " +
                  (known.empty() ? "nothing: init requested no cameras"
                                 : OneOf(known) + ", or nothing for the eye"));
      return;
    }
    (*notes)[k].camera = line;
  }
}

}  // namespace

bool IsOfNotes(const NamedArray& array) {
  return array.name == "notes" || array.name == "noteTops" || array.name == "noteCameras";
}

std::vector<sim::Note> ReadNotes(const Message& message, std::span<const std::string> cameras,
                                 MatrixReader& reader) {
  const NamedArray* lines = message.Find("notes");
  const NamedArray* note_tops = message.Find("noteTops");
  const NamedArray* note_cameras = message.Find("noteCameras");
  if (lines == nullptr) {
    for (const NamedArray* array : {note_tops, note_cameras}) {
      if (array != nullptr) reader.Fail(array->name + " is given without notes");
    }
    return {};
  }
  std::vector<sim::Note> notes = ReadLines(*lines, reader);
  if (note_tops != nullptr && reader.ok()) AddTops(*note_tops, &notes, reader);
  if (note_cameras != nullptr && reader.ok()) AddCameras(*note_cameras, cameras, &notes, reader);
  return notes;
}

}  // namespace smile::brain
