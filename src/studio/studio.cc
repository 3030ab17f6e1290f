#include "studio/studio.h"

#include <charconv>
#include <string_view>
#include <thread>
#include <utility>

#include "studio/internal_studio_loop.h"
#include "studio/pose_stream.h"

namespace smile::studio {

/// A session, as the loop sees it.
class SessionWorkplace : public Workplace {
 public:
  explicit SessionWorkplace(SessionOptions options) : session_(std::move(options)) {}

  const RequestTable& requests() const override { return session_.requests(); }
  void Tick() override { session_.Tick(); }
  News TakeNews() override { return session_.TakeNews(); }
  std::vector<Json> Everything() const override { return session_.Everything(); }
  double speed_factor() const override { return session_.speed_factor(); }
  void SetMeasuredSpeed(double factor) override { session_.SetMeasuredSpeed(factor); }
  Poses NextPoses() override { return poses_.Next(session_.view()); }

  const Session& session() const { return session_; }

 private:
  Session session_;
  PoseStream poses_;
};

namespace {

struct MeshName {
  std::uint32_t scene = 0;
  std::size_t mesh = 0;
};

/// `/meshes/3/0`.
std::optional<MeshName> ParseMeshPath(std::string_view path) {
  constexpr std::string_view kFolder = "/meshes/";
  if (!path.starts_with(kFolder)) return std::nullopt;
  const char* end = path.data() + path.size();
  MeshName name;
  const auto scene = std::from_chars(path.data() + kFolder.size(), end, name.scene);
  if (scene.ec != std::errc() || scene.ptr == end || *scene.ptr != '/') return std::nullopt;
  const auto mesh = std::from_chars(scene.ptr + 1, end, name.mesh);
  if (mesh.ec != std::errc() || mesh.ptr != end) return std::nullopt;
  return name;
}

}  // namespace

class Studio::Impl {
 public:
  explicit Impl(StudioOptions options)
      : workplace_(std::move(options.session)),
        get_(std::move(options.server.get)),
        server_(WithMeshes(std::move(options.server))),
        loop_(&workplace_, &server_) {}

  std::string link() const { return server_.link(); }

  void Run(const std::function<bool()>& is_over) {
    while (!is_over()) {
      loop_.Beat();
      std::this_thread::sleep_until(loop_.next_beat());
    }
  }

 private:
  ServerOptions WithMeshes(ServerOptions options) {
    options.get = [this](const std::string& path) -> std::optional<HttpAnswer> {
      if (const std::optional<MeshName> name = ParseMeshPath(path)) return GetMesh(*name);
      return get_ ? get_(path) : std::nullopt;
    };
    return options;
  }

  std::optional<HttpAnswer> GetMesh(MeshName name) const {
    const std::optional<std::string> bytes = workplace_.session().MeshBytes(name.scene, name.mesh);
    if (!bytes) return std::nullopt;
    return HttpAnswer{.type = "application/octet-stream", .body = *bytes};
  }

  SessionWorkplace workplace_;
  HttpHandler get_;
  Server server_;
  StudioLoop loop_;
};

Studio::Studio(StudioOptions options) : impl_(std::make_unique<Impl>(std::move(options))) {}
Studio::~Studio() = default;

std::string Studio::link() const { return impl_->link(); }
void Studio::Run(const std::function<bool()>& is_over) { impl_->Run(is_over); }

}  // namespace smile::studio
