#include "studio/internal_console_updates.h"

#include <cstddef>
#include <utility>

namespace smile::studio {
namespace {

/// Lines kept for clients that connect later.
constexpr std::size_t kMaxLines = 200;

}  // namespace

std::optional<Json> ConsoleUpdates::Add(const std::vector<ConsoleLine>& lines) {
  if (lines.empty()) return std::nullopt;
  Json lines_json = Json::array();
  for (const ConsoleLine& line : lines) {
    Json one = {{"text", line.text}};
    if (!line.file.empty()) one.update({{"file", line.file}, {"line", line.line}});
    lines_json.push_back(one);
    sent_.push_back(std::move(one));
  }
  // The message itself has all new lines: the limit is only on what later clients receive.
  while (sent_.size() > kMaxLines) sent_.pop_front();
  return Json{{"t", "console"}, {"lines", std::move(lines_json)}};
}

std::optional<Json> ConsoleUpdates::Everything() const {
  if (sent_.empty()) return std::nullopt;
  return Json{
      {"t", "console"}, {"all", true}, {"lines", Json(Json::array_t(sent_.begin(), sent_.end()))}};
}

}  // namespace smile::studio
