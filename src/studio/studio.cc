#include "studio/studio.h"

#include <thread>
#include <utility>

#include "base/files.h"
#include "layout/presets.h"
#include "library/brain_choices.h"
#include "library/content_routes.h"
#include "page/control_requests.h"
#include "studio/background_jobs.h"
#include "studio/internal_mesh_route.h"
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
        session_(WithJobs(options.session, &jobs_)),
        content_routes_(ContentRoutesOptionsOf(options.session)),
        server_(WithAnswers(options.server)),
        loop_(&session_, &server_) {
    AddLibraryRequests(&library_, &jobs_, session_.table());
    datasets_.AddTo(session_.table(), [this](const page::Request& request, auto work) {
      jobs_.Begin(
          {.request = request, .work = [work](const recording::Progress&) { return work(); }});
    });
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
    // Called by the web server's workers. It uses only parts that any thread may read: the meshes
    // and the content routes, both constructed before the server.
    options.get = [this](const std::string& path) {
      const auto mesh = ParseMeshPath(path);
      if (!mesh) return content_routes_.Get(path);
      return MeshResponse(session_.MeshBytes(mesh->scene, mesh->mesh));
    };
    return options;
  }

  // Destroyed from the last to the first: the loop and the server's threads end before the session
  // that they serve, and jobs before the library that they read.
  library::Library library_;
  datasets::DatasetRequests datasets_;
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
