#include "studio/internal_console_news.h"

#include <cstddef>
#include <utility>

namespace smile::studio {
namespace {

/// So much of what was printed do those see who come later.
constexpr std::size_t kMaxLines = 200;

}  // namespace

std::optional<Json> ConsoleNews::Tell(const std::vector<ConsoleLine>& lines) {
  if (lines.empty()) return std::nullopt;
  Json told = Json::array();
  for (const ConsoleLine& line : lines) {
    Json one = {{"text", line.text}};
    if (!line.file.empty()) one.update({{"file", line.file}, {"line", line.line}});
    told.push_back(one);
    told_.push_back(std::move(one));
  }
  while (told_.size() > kMaxLines) told_.pop_front();
  return Json{{"t", "console"}, {"lines", std::move(told)}};
}

std::optional<Json> ConsoleNews::Everything() const {
  if (told_.empty()) return std::nullopt;
  return Json{
      {"t", "console"}, {"all", true}, {"lines", Json(Json::array_t(told_.begin(), told_.end()))}};
}

}  // namespace smile::studio
