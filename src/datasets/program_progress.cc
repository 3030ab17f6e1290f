#include "datasets/program_progress.h"

#include <charconv>

namespace smile::datasets {

Json ProgressIn(std::string_view line, std::string_view begin) {
  constexpr std::string_view kOf = " of ";
  if (!line.starts_with(begin)) return Json::object();
  const char* const end = line.data() + line.size();
  int number = 0, total = 0;
  const auto [of, error] = std::from_chars(line.data() + begin.size(), end, number);
  if (error != std::errc() || !std::string_view(of, end).starts_with(kOf)) return Json::object();
  if (std::from_chars(of + kOf.size(), end, total).ec != std::errc()) return Json::object();
  return {{"done", number}, {"total", total}};
}

}  // namespace smile::datasets
