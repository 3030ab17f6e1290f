#include "studio/studio.h"

#include <thread>
#include <utility>

#include "base/files.h"
#include "layout/presets.h"
#include "library/brain_choices.h"
#include "library/content_routes.h"
#include "page/control_requests.h"
#include "page/mesh_route.h"
#include "sharing/sharing.h"
#include "studio/background_jobs.h"
#include "studio/internal_studio_loop.h"
#include "studio/library_requests.h"
#include "studio/pose_stream.h"
#include "texts/message_json.h"

// Puts the program together: session, library, background jobs, server, and the loop that drives
// them. The session itself knows no network, and the server no session; they meet in the table of
// requests and in StudioLoop.

namespace smile::studio {

/// Session adapter: drives a Session and its pose stream for the studio loop.
class SessionAdapter : public SessionInterface {
 public:
  explicit SessionAdapter(SessionOptions options) : session_(std::move(options)) {}

  const page::RequestTable& requests() const override { return session_.requests(); }
  bool Tick() override { return session_.Tick(); }
  SessionUpdates TakeUpdates() override { return session_.TakeUpdates(); }
  std::vector<Json> Everything() const override { return session_.Everything(); }
  double speed_factor() const override { return session_.speed_factor(); }
  void SetMeasuredSpeed(double factor) override { session_.SetMeasuredSpeed(factor); }
  page::Poses NextPoses() override { return poses_.Next(session_.view()); }

  /// See Session::MeshBytes().
  std::optional<std::string> MeshBytes(std::uint32_t scene, std::size_t mesh) const {
    return session_.MeshBytes(scene, mesh);
  }
  /// Returns the table, to which other parts may add requests.
  page::RequestTable* table() { return &session_.requests(); }

 private:
  Session session_;
  PoseStream poses_;
};

namespace {

SessionOptions WithJobs(SessionOptions options, BackgroundJobs* jobs) {
  options.jobs = jobs;
  return options;
}

SessionOptions WithSceneFolder(SessionOptions options) {
  if (options.scene_folder.empty()) options.scene_folder = DataFile("scenes");
  return options;
}

datasets::DatasetOptions DatasetOptionsOf(const StudioOptions& options) {
  datasets::DatasetOptions datasets = options.datasets;
  datasets.has_robot = options.session.robot.has_value();
  datasets.scene = options.session.scene;
  datasets.scene_folder = options.session.scene_folder;
  datasets.brains = library::BrainFolders(options.session.brains);
  return datasets;
}

library::ContentRoutesOptions ContentRoutesOptionsOf(const SessionOptions& session) {
  library::ContentRoutesOptions options{.scenes = session.scene_folder,
                                        .recordings = session.recordings};
  // The gallery lists presets beside scenes; the library's room does not know them.
  for (const layout::Preset& preset : layout::Presets()) {
    options.presets.push_back({{"name", preset.name}, {"title", texts::ToJson(preset.title)}});
  }
  return options;
}

/// Adds a reason for refusing to all requests of a table.
void Restrict(const page::Precondition& refuse, page::RequestTable* table) {
  if (!refuse) return;
  for (auto& [what, registered] : table->requests) {
    registered.refuse = [refuse, before = registered.refuse](const page::Request& request) {
      const auto refusal = refuse(request);
      return refusal || !before ? refusal : before(request);
    };
  }
}

}  // namespace

class Studio::Impl {
 public:
  explicit Impl(const StudioOptions& options)
      : library_(options.session.recordings),
        datasets_(DatasetOptionsOf(options), &library_),
        sharing_({.page = options.server.page / "shared",
                  .content = [this](const std::string& path) { return content_routes_.Get(path); }},
                 &library_),
        session_(WithJobs(options.session, &jobs_)),
        content_routes_(ContentRoutesOptionsOf(options.session)),
        server_(WithAnswers(options.server)),
        loop_(&session_, &server_) {
    AddLibraryRequests(&library_, &jobs_, session_.table());
    const auto in_background = [this](const page::Request& request, auto work) {
      jobs_.Begin(
          {.request = request, .work = [work](const recording::Progress&) { return work(); }});
    };
    datasets_.AddTo(session_.table(), in_background);
    sharing_.AddTo(session_.table(),
                   {.origin = server_.origin(), .is_local = server_.is_loopback()}, in_background);
    page::AddControlRequests(session_.table());
    Restrict(options.refuse, session_.table());
  }

  std::string link() const { return server_.link(); }

  void Run(const std::function<bool()>& is_over) {
    // A step that was late is followed by the next one at once; FrameTimer bounds how much is
    // caught up.
    while (!is_over()) {
      loop_.Step();
      std::this_thread::sleep_until(loop_.next_step());
    }
  }

 private:
  page::ServerOptions WithAnswers(page::ServerOptions options) {
    options.public_prefix = sharing::kPublicPrefix;
    // Called by the web server's workers. It uses only parts that any thread may read: the meshes,
    // shared recordings and the content routes, all constructed before the server.
    options.get = [this](const std::string& path) {
      if (path.starts_with(sharing::kPublicPrefix)) return sharing_.Get(path);
      const auto mesh = page::ParseMeshPath(path);
      if (!mesh) return content_routes_.Get(path);
      return page::MeshResponse(session_.MeshBytes(mesh->scene, mesh->mesh));
    };
    return options;
  }

  // Destroyed from the last to the first: the loop and the server's threads end before the session
  // that they serve, and jobs before what they work on.
  library::Library library_;
  datasets::DatasetRequests datasets_;
  sharing::Sharing sharing_;
  BackgroundJobs jobs_;
  SessionAdapter session_;
  library::ContentRoutes content_routes_;
  page::Server server_;
  StudioLoop loop_;
};

Studio::Studio(StudioOptions options) {
  options.session = WithSceneFolder(std::move(options.session));
  impl_ = std::make_unique<Impl>(options);
}
Studio::~Studio() = default;

std::string Studio::link() const { return impl_->link(); }
void Studio::Run(const std::function<bool()>& is_over) { impl_->Run(is_over); }

}  // namespace smile::studio
