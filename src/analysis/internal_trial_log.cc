#include "analysis/internal_trial_log.h"

#include <stdexcept>
#include <utility>

#include "base/files.h"
#include "texts/message_json.h"

namespace smile::analysis {
namespace {

constexpr std::size_t kMaxBytes = 256 << 20;

std::string LineOf(const std::string& trial, const Harm& harm) {
  return ToText(Json{{"trial", trial}, {"harm", harm ? texts::ToJson(*harm) : Json(nullptr)}}) +
         "\n";
}

/// Removes the first line of a text and returns it without its end; nullopt if it has no end.
std::optional<std::string_view> TakeLine(std::string_view* text) {
  const std::size_t end = text->find('\n');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view line = text->substr(0, end);
  text->remove_prefix(end + 1);
  return line;
}

}  // namespace

TrialLog::TrialLog(const std::filesystem::path& file, const Json& about,
                   const std::function<void(std::string_view)>& say)
    : file_(file) {
  const std::string head = ToText(about) + "\n";
  std::string text = head;
  if (std::filesystem::exists(file)) {
    const std::string found = ReadFile(file, kMaxBytes);
    if (!found.starts_with(head)) {
      say(file.string() + " is about another demonstration, goal or program: starts over");
    } else if (!Read(std::string_view(found).substr(head.size()))) {
      say(file.string() + " is damaged: starts over");
      known_.clear();
    } else {
      say(file.string() + ": continues after " + std::to_string(known_.size()) + " simulations");
    }
    for (const auto& [trial, harm] : known_) text += LineOf(trial, harm);
  }
  WriteFile(file, text);
  stream_.open(file, std::ios::app);
}

bool TrialLog::Read(std::string_view lines) {
  while (const auto line = TakeLine(&lines)) {
    try {
      const Json json = ParseJson(*line);
      const Json& harm = json.at("harm");
      known_[json.at("trial").get<std::string>()] =
          harm.is_null() ? Harm() : Harm(texts::MessageOf(harm));
    } catch (const std::logic_error&) {
      return false;
    } catch (const Json::exception&) {
      return false;
    }
  }
  return true;
}

std::optional<Harm> TrialLog::Find(const std::string& trial) const {
  const auto found = known_.find(trial);
  if (found == known_.end()) return std::nullopt;
  // Known to do no harm is not the same as not known.
  return std::optional<Harm>(std::in_place, found->second);
}

void TrialLog::Add(const std::string& trial, const Harm& harm) {
  if (!known_.emplace(trial, harm).second || file_.empty()) return;
  stream_ << LineOf(trial, harm) << std::flush;
  if (!stream_) throw std::runtime_error(file_.string() + ": cannot be written");
}

void TrialLog::Remove() {
  if (file_.empty()) return;
  stream_.close();
  std::filesystem::remove(file_);
}

}  // namespace smile::analysis
