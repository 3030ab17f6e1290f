#include "studio/requests.h"

#include <string_view>

#include "base/wording.h"

namespace smile::studio {
namespace {

Json Failure(const std::string& message) { return {{"ok", false}, {"error", message}}; }

Json Failure(const InputError& error) {
  Json failure = Failure(error.what());
  failure["diagnostics"] = Json::array();
  for (const Diagnostic& finding : error.diagnostics()) {
    failure["diagnostics"].push_back({{"file", finding.file},
                                      {"line", finding.line},
                                      {"element", finding.element},
                                      {"message", finding.message}});
  }
  return failure;
}

Json Unknown(const RequestTable& table, const std::string& what) {
  std::vector<std::string_view> known;
  for (const auto& [name, entry] : table.entries) known.push_back(name);
  return Failure("there is no request " + Quoted(what) + ", expected " + OneOf(known) +
                 DidYouMean(what, known));
}

Json CarryOut(const RequestTable& table, const Request& request, bool is_controller) {
  const auto entry = table.entries.find(request.what);
  if (entry == table.entries.end()) return Unknown(table, request.what);
  if (!entry->second.is_for_anyone && !is_controller) {
    return Failure("you are watching: take control first");
  }
  try {
    Json answer = {{"ok", true}};
    answer.update(entry->second.handle(request));
    return answer;
  } catch (const InputError& error) {
    return Failure(error);
  } catch (const std::exception& error) {
    return Failure(error.what());
  }
}

}  // namespace

Json Answer(const RequestTable& table, const Request& request, bool is_controller) {
  Json answer = {{"t", "reply"}, {"seq", request.seq}};
  answer.update(CarryOut(table, request, is_controller));
  return answer;
}

}  // namespace smile::studio
