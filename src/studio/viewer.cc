#include "studio/viewer.h"

#include <thread>
#include <utility>

#include "page/mesh_route.h"
#include "studio/internal_studio_loop.h"
#include "studio/internal_viewer_session.h"

namespace smile::studio {

class Viewer::Impl {
 public:
  Impl(page::ServerOptions options, std::shared_ptr<WatchedSimulation> simulation)
      : session_(std::move(simulation)),
        server_(WithAnswers(std::move(options))),
        loop_(&session_, &server_),
        thread_([this](const std::stop_token& stop) {
          while (!stop.stop_requested()) {
            loop_.Step();
            std::this_thread::sleep_until(loop_.next_step());
          }
        }) {}

  std::string link() const { return server_.link(); }
  ViewerSession& session() { return session_; }

 private:
  page::ServerOptions WithAnswers(page::ServerOptions options) {
    options.may_be_framed = true;
    // Called by the web server's workers.
    options.get = [this](const std::string& path) -> std::optional<web_server::HttpResponse> {
      if (path == "/scenes") {
        return web_server::HttpResponse{.type = "application/json",
                                        .body = R"({"scenes":[],"presets":[]})"};
      }
      const auto mesh = page::ParseMeshPath(path);
      return mesh ? page::MeshResponse(session_.MeshBytes(mesh->scene, mesh->mesh)) : std::nullopt;
    };
    return options;
  }

  // Destroyed from the last to the first: the threads end before what they use.
  ViewerSession session_;
  page::Server server_;
  StudioLoop loop_;
  std::jthread thread_;
};

Viewer::Viewer(page::ServerOptions options, std::shared_ptr<WatchedSimulation> simulation)
    : impl_(std::make_unique<Impl>(std::move(options), std::move(simulation))) {}
Viewer::~Viewer() = default;

std::string Viewer::link() const { return impl_->link(); }
void Viewer::Show(std::shared_ptr<WatchedSimulation> simulation) {
  impl_->session().Show(std::move(simulation));
}

}  // namespace smile::studio
