#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/json.h"
#include "texts/user_message.h"

namespace smile::analysis {

/// Why a trial fails to achieve the goal; nullopt if it achieves it.
using Harm = std::optional<texts::UserMessage>;

/// Results of trials in a file, so that an interrupted analysis continues: a line of JSON that says
/// what they are about, then one line per trial, in the order in which they ended.
class TrialLog {
 public:
  /// Keeps nothing.
  TrialLog() = default;
  /// Continues a file, or starts it if it is missing, damaged, or about something else, and says
  /// so. A last line that was cut is dropped.
  /// @param about  everything that results depend on.
  /// @param say    receives a message for people.
  /// @throws std::runtime_error if it cannot be read or written.
  TrialLog(const std::filesystem::path& file, const Json& about,
           const std::function<void(std::string_view)>& say);

  /// Returns the result of a trial; nullopt if it is not known.
  std::optional<Harm> Find(const std::string& trial) const;
  /// @throws std::runtime_error if it cannot be written.
  void Add(const std::string& trial, const Harm& harm);
  /// Removes the file: all trials are done, and the result is written elsewhere.
  void Remove();

 private:
  /// Reads the lines of trials.
  /// @returns false if one is damaged.
  bool Read(std::string_view lines);

  std::filesystem::path file_;
  std::ofstream stream_;
  std::map<std::string, Harm> known_;
};

}  // namespace smile::analysis
