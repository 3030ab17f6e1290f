#include "studio/internal_scene_requests.h"

#include <memory>
#include <utility>

namespace smile::studio {
namespace {

Json DescribeFindings(const std::vector<Diagnostic>& findings) {
  Json described = Json::array();
  for (const Diagnostic& finding : findings) {
    described.push_back({{"file", finding.file},
                         {"line", finding.line},
                         {"element", finding.element},
                         {"message", finding.message}});
  }
  return described;
}

}  // namespace

Json SceneRequests::Load(const page::RequestFields& fields) {
  LoadScene(source_->SceneOf(fields));
  return Json::object();
}

Json SceneRequests::Reload(const page::RequestFields&) {
  // The scene of the model, and not its file, which may have changed or never existed.
  LoadScene(states_->world().simulation().start_model()->scene());
  return Json::object();
}

Json SceneRequests::Check(const page::RequestFields& fields) {
  return {{"diagnostics", DescribeFindings(source_->ReadText(fields).diagnostics)}};
}

void SceneRequests::LoadScene(scene::SceneSpec scene) {
  // A command like any other, so that loading can be undone.
  const sim::Load load{std::make_shared<const scene::SceneSpec>(std::move(scene))};
  if (const auto refusal = states_->Apply(load)) throw page::RequestError(*refusal);
}

}  // namespace smile::studio
