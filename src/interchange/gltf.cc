#include "interchange/gltf.h"

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "interchange/internal_gltf_buffer.h"
#include "interchange/linear_color.h"
#include "mesh/primitives.h"

namespace smile::interchange {
namespace {

Json ToJson(const Vector3& v) { return {v.x() + 0.0, v.y() + 0.0, v.z() + 0.0}; }
Json ToJson(const Quaternion& q) { return {q.x() + 0.0, q.y() + 0.0, q.z() + 0.0, q.w() + 0.0}; }

/// Writer of a glTF document.
class GltfDocument {
 public:
  explicit GltfDocument(const ExportedScene& scene) : world_(scene.world), motion_(scene.motion) {
    ListLeftOut();
    // The whole stands in one node, which turns z up to y up.
    AddNode({{"name", "smile"},
             {"rotation",
              ToJson(Quaternion(Eigen::AngleAxisd(-std::numbers::pi / 2, Vector3::UnitX())))}});
    for (std::size_t frame = 0; frame < motion_.frames.size(); ++frame) AddFrame(frame);
    for (const ExportedCamera& camera : world_.cameras) AddCamera(camera);
    AddLight();
  }

  ExportedText Take() {
    Json document{
        {"asset",
         {{"version", "2.0"}, {"generator", "SMILE"}, {"extras", {{"left_out", left_out_}}}}},
        {"extensionsUsed", Json::array({"KHR_lights_punctual"})},
        {"scene", 0},
        {"scenes", Json::array({{{"nodes", Json::array({0})}}})},
        {"nodes", nodes_}};
    if (!world_.name.empty()) document["scenes"][0]["name"] = world_.name;
    if (!meshes_.empty()) document["meshes"] = meshes_;
    if (!materials_.empty()) document["materials"] = materials_;
    if (!cameras_.empty()) document["cameras"] = cameras_;
    if (!channels_.empty()) {
      document["animations"] = Json::array(
          {{{"name", "demonstration"}, {"channels", channels_}, {"samplers", samplers_}}});
    }
    document["extensions"] = {{"KHR_lights_punctual", {{"lights", Json::array({light_})}}}};
    if (buffer_.size() > 0) {
      document["buffers"] = Json::array({{{"byteLength", buffer_.size()}}});
      document["bufferViews"] = buffer_.views();
      document["accessors"] = buffer_.accessors();
    }
    return {.text = ToGlb(document, buffer_.Take()), .left_out = left_out_};
  }

 private:
  void ListLeftOut() {
    if (motion_.is_animated()) left_out_ = world_.left_out;
    left_out_.push_back("masses, friction, joints and controls: glTF has what is seen");
  }

  /// Adds a node below another one.
  int AddNode(Json node, int parent = -1) {
    nodes_.push_back(std::move(node));
    const int index = static_cast<int>(nodes_.size()) - 1;
    if (parent >= 0) nodes_[static_cast<std::size_t>(parent)]["children"].push_back(index);
    return index;
  }

  static Json PoseOf(std::string name, const RigidTransform& X) {
    return {{"name", std::move(name)},
            {"translation", ToJson(X.translation())},
            {"rotation", ToJson(X.quaternion())}};
  }

  void AddFrame(std::size_t index) {
    const MovingFrame& frame = motion_.frames[index];
    const int node = AddNode(PoseOf(frame.name, frame.X_WF.front()), 0);
    node_of_frame_.push_back(node);
    if (frame.moments.size() > 1) Animate(frame, node);
    for (const MovingVisuals& group : frame.visuals) AddVisuals(group, node);
  }

  void AddVisuals(const MovingVisuals& group, int frame_node) {
    int parent = frame_node;
    if (group.shown.size() > 1) {
      const double scale = group.shown.front().second ? 1 : 0;
      parent = AddNode({{"scale", ToJson(Vector3(scale, scale, scale))}}, frame_node);
      AnimateVisibility(group, parent);
    }
    for (const scene::Visual& visual : group.visuals) {
      const int mesh = MeshOf(visual);
      if (mesh < 0) continue;
      Json node = PoseOf(visual.part_id, visual.X_FV);
      if (visual.part_id.empty()) node.erase("name");
      node["scale"] = ToJson(mesh::ScaleOf(visual.shape));
      node["mesh"] = mesh;
      AddNode(std::move(node), parent);
    }
  }

  // --- motion

  int TimesOf(const std::vector<std::uint32_t>& moments) {
    const auto [found, is_new] = times_.try_emplace(moments);
    if (is_new) {
      std::vector<float> seconds;
      for (const std::uint32_t moment : moments) {
        seconds.push_back(static_cast<float>(motion_.seconds[moment]));
      }
      found->second = buffer_.AddFloats(seconds, 1, /*has_range=*/true);
    }
    return found->second;
  }

  void AddChannel(int node, const char* path, const char* interpolation, int times, int values) {
    samplers_.push_back({{"input", times}, {"interpolation", interpolation}, {"output", values}});
    channels_.push_back({{"sampler", static_cast<int>(samplers_.size()) - 1},
                         {"target", {{"node", node}, {"path", path}}}});
  }

  void Animate(const MovingFrame& frame, int node) {
    std::vector<float> positions, rotations;
    for (const RigidTransform& X_WF : frame.X_WF) {
      for (const double x : X_WF.translation()) positions.push_back(static_cast<float>(x));
    }
    for (const Quaternion& q : frame.Rotations()) {
      for (const double x : {q.x(), q.y(), q.z(), q.w()}) {
        rotations.push_back(static_cast<float>(x));
      }
    }
    const int times = TimesOf(frame.moments);
    AddChannel(node, "translation", "LINEAR", times, buffer_.AddFloats(positions, 3, false));
    AddChannel(node, "rotation", "LINEAR", times, buffer_.AddFloats(rotations, 4, false));
  }

  void AnimateVisibility(const MovingVisuals& group, int node) {
    std::vector<std::uint32_t> moments;
    std::vector<float> scales;
    for (const auto& [moment, is_shown] : group.shown) {
      moments.push_back(moment);
      scales.insert(scales.end(), 3, is_shown ? 1.0F : 0.0F);
    }
    AddChannel(node, "scale", "STEP", TimesOf(moments), buffer_.AddFloats(scales, 3, false));
  }

  // --- meshes

  /// Returns the mesh of a visual's shape, before it is scaled, in its color; -1 without triangles.
  int MeshOf(const scene::Visual& visual) {
    const int surface = SurfaceOf(mesh::UnitMeshOf(visual.shape));
    if (surface < 0) return -1;
    const int material = MaterialOf(visual);
    const auto [found, is_new] = mesh_of_.try_emplace({surface, material}, meshes_.size());
    if (is_new) {
      Json primitive = primitives_[static_cast<std::size_t>(surface)];
      primitive["material"] = material;
      meshes_.push_back({{"primitives", Json::array({std::move(primitive)})}});
    }
    return static_cast<int>(found->second);
  }

  int SurfaceOf(const mesh::UnitMesh& unit_mesh) {
    const auto [found, is_new] = surfaces_.try_emplace(unit_mesh, -1);
    if (is_new) {
      const mesh::TriangleMesh triangles = MakeMesh(unit_mesh);
      if (!triangles.triangles.empty()) found->second = AddPrimitive(triangles);
    }
    return found->second;
  }

  int AddPrimitive(const mesh::TriangleMesh& mesh) {
    std::vector<float> corners, normals;
    std::vector<std::uint32_t> indices;
    for (const auto& corner : mesh.positions) {
      corners.insert(corners.end(), corner.begin(), corner.end());
    }
    for (const auto& normal : mesh.normals) {
      normals.insert(normals.end(), normal.begin(), normal.end());
    }
    for (const auto& triangle : mesh.triangles) {
      indices.insert(indices.end(), triangle.begin(), triangle.end());
    }
    const int position = buffer_.AddFloats(corners, 3, /*has_range=*/true, kVertices);
    const int normal = buffer_.AddFloats(normals, 3, /*has_range=*/false, kVertices);
    primitives_.push_back({{"attributes", {{"POSITION", position}, {"NORMAL", normal}}},
                           {"indices", buffer_.AddIndices(indices)}});
    return static_cast<int>(primitives_.size()) - 1;
  }

  int MaterialOf(const scene::Visual& visual) {
    const auto [red, green, blue] = LinearOf(visual.color);
    const auto [found, is_new] =
        material_of_.try_emplace({red, green, blue, visual.glows}, materials_.size());
    if (is_new) {
      Json material{{"pbrMetallicRoughness",
                     {{"baseColorFactor", {red, green, blue, 1}},
                      {"metallicFactor", 0},
                      {"roughnessFactor", 0.8}}},
                    {"doubleSided", true}};
      if (visual.glows) material["emissiveFactor"] = {red, green, blue};
      materials_.push_back(std::move(material));
    }
    return static_cast<int>(found->second);
  }

  // --- cameras and light

  void AddCamera(const ExportedCamera& camera) {
    const CameraIntrinsics& optics = camera.intrinsics;
    cameras_.push_back({{"name", camera.name},
                        {"type", "perspective"},
                        {"perspective",
                         {{"aspectRatio", static_cast<double>(optics.width_px) / optics.height_px},
                          {"yfov", 2 * std::atan(optics.height_px / (2 * optics.fy))},
                          {"znear", optics.near},
                          {"zfar", optics.far}}}});
    // Cameras of glTF have y up and look along -z.
    const RigidTransform X_CG(Matrix3(Vector3(1, -1, -1).asDiagonal()), Vector3::Zero());
    Json node = PoseOf(camera.name, camera.X_FC * X_CG);
    node["camera"] = static_cast<int>(cameras_.size()) - 1;
    AddNode(std::move(node), ParentOf(camera));
  }

  int ParentOf(const ExportedCamera& camera) const {
    if (camera.link == -2) return 0;
    const ExportedRobot& robot = *world_.robot;
    const ExportedLink& link =
        camera.link < 0 ? robot.base : robot.links[static_cast<std::size_t>(camera.link)];
    return node_of_frame_[static_cast<std::size_t>(link.frame)];
  }

  void AddLight() {
    const auto [red, green, blue] = LinearOf(world_.lighting.color);
    light_ = {{"type", "directional"},
              {"color", {red, green, blue}},
              {"intensity", kIlluminance * world_.lighting.brightness}};
    // It shines along -z of its node.
    const Quaternion q = Quaternion::FromTwoVectors(-Vector3::UnitZ(),
                                                    LightDirectionOf(world_.lighting).normalized());
    AddNode({{"name", "light"},
             {"rotation", ToJson(q)},
             {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}},
            0);
  }

  const ExportedWorld& world_;
  const ExportedMotion& motion_;
  Json nodes_ = Json::array(), meshes_ = Json::array(), materials_ = Json::array(),
       cameras_ = Json::array(), channels_ = Json::array(), samplers_ = Json::array(),
       primitives_ = Json::array(), light_;
  GltfBuffer buffer_;
  std::vector<int> node_of_frame_;
  std::map<mesh::UnitMesh, int> surfaces_;  ///< of the primitive; -1: none
  std::map<std::pair<int, int>, std::size_t> mesh_of_;
  std::map<std::tuple<double, double, double, bool>, std::size_t> material_of_;
  std::map<std::vector<std::uint32_t>, int> times_;
  std::vector<std::string> left_out_;
};

}  // namespace

ExportedText ToGltf(const ExportedScene& scene) { return GltfDocument(scene).Take(); }

}  // namespace smile::interchange
