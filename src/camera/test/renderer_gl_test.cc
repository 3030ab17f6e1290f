#include "camera/renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <numbers>
#include <random>
#include <set>
#include <stdexcept>
#include <thread>

#include "camera/test/scene_fixture.h"

namespace smile::camera {
namespace {

const RenderOptions kAllChannels{.color = true, .depth = true, .ids = true};
const RenderOptions kPresented{.style = RenderStyle::kPresentation};

std::array<int, 3> ColorAt(const Image& image, int u, int v) {
  const std::uint8_t* pixel = &image.color[3 * (static_cast<std::size_t>(v) * image.width_px + u)];
  return {pixel[0], pixel[1], pixel[2]};
}

std::uint32_t IdAt(const Image& image, int u, int v) {
  return image.ids[static_cast<std::size_t>(v) * image.width_px + u];
}

/// The smallest rectangle around an object's pixels.
Eigen::AlignedBox2d PixelsOf(const Image& image, std::uint32_t id) {
  Eigen::AlignedBox2d box;
  for (int v = 0; v < image.height_px; ++v) {
    for (int u = 0; u < image.width_px; ++u) {
      if (IdAt(image, u, v) == id) {
        box.extend(Eigen::Vector2d(u, v));
        box.extend(Eigen::Vector2d(u + 1, v + 1));
      }
    }
  }
  return box;
}

std::array<int, 3> ColorAtPoint(const Image& image, const CameraView& view, const Vector3& p_WQ) {
  const auto pixel = ProjectToPixel(view.intrinsics, view.X_WC.inverse() * p_WQ);
  return ColorAt(image, static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
}

/// Making a renderer takes a tenth of a second: these tests share one.
class RendererTest : public testing::Test {
 protected:
  static void SetUpTestSuite() { renderer_ = std::make_unique<Renderer>(); }
  static void TearDownTestSuite() { renderer_.reset(); }

  static Image Render(const SmallScene& scene, const CameraView& view,
                      const RenderOptions& options = kAllChannels) {
    return renderer_->Render(scene.model, scene.state, view, options);
  }

 private:
  static inline std::unique_ptr<Renderer> renderer_;
};

TEST_F(RendererTest, ShowsTheTableThroughTheHoleOfARing) {
  SmallScene scene;
  const std::uint32_t table = scene.Add(scene::Block{{2, 1.2, 0.4}}, kWhite, Vector3(0, 0, -0.2));
  const scene::Part ring{
      .color = kRed,
      .shape = scene::Ring{.radius_outer = 0.1, .radius_inner = 0.06, .height = 0.02}};
  const std::uint32_t id = scene.AddPart(ring, Vector3(0, 0, 0.01));
  const CameraView view{CameraIntrinsics::FromVerticalFieldOfView(640, 480, std::numbers::pi / 6),
                        LookAt({0, -0.001, 1}, {0, 0, 0})};
  const Image image = Render(scene, view);
  for (int degrees = 0; degrees < 360; degrees += 3) {
    const double angle = degrees * std::numbers::pi / 180;
    const auto id_at = [&](double radius, double z) {
      const Vector3 p_WQ(radius * std::cos(angle), radius * std::sin(angle), z);
      const auto pixel = ProjectToPixel(view.intrinsics, view.X_WC.inverse() * p_WQ);
      return IdAt(image, static_cast<int>(pixel.x()), static_cast<int>(pixel.y()));
    };
    EXPECT_EQ(id_at(0.02, 0), table) << degrees;
    EXPECT_EQ(id_at(0.055, 0), table) << degrees;
    EXPECT_EQ(id_at(0.065, 0.02), id) << degrees;
    EXPECT_EQ(id_at(0.08, 0.02), id) << degrees;
    EXPECT_EQ(id_at(0.095, 0.02), id) << degrees;
    EXPECT_EQ(id_at(0.11, 0), table) << degrees;
  }
  EXPECT_EQ(ColorAt(image, 320, 240), ColorAtPoint(image, view, {0.2, 0, 0}))
      << "white as beside it";
}

TEST_F(RendererTest, CubeCoversThePixelsItProjectsTo) {
  SmallScene scene;
  const RigidTransform X_WF(RotationFromFixedAxes({20, 30, 40}), {0.1, 0.2, 0.3});
  const std::uint32_t id = scene.Add(scene::Block{kCubeSize}, kRed, X_WF);
  const CameraView view = HeadView(640, 480);
  Eigen::AlignedBox2d expected;
  for (int corner = 0; corner < 8; ++corner) {
    const Vector3 sides(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const Vector3 p_WQ = X_WF * Vector3(0.5 * kCubeSize.cwiseProduct(sides));
    expected.extend(ProjectToPixel(view.intrinsics, view.X_WC.inverse() * p_WQ));
  }
  const Eigen::AlignedBox2d seen = PixelsOf(Render(scene, view), id);
  EXPECT_LT((seen.min() - expected.min()).cwiseAbs().maxCoeff(), 1.0);
  EXPECT_LT((seen.max() - expected.max()).cwiseAbs().maxCoeff(), 1.0);
}

TEST_F(RendererTest, CubeSeenStraightFromAboveIsAFilledSquareOfItsColor) {
  SmallScene scene;
  scene.Add(scene::Block{kCubeSize}, kRed, Vector3(0, 0, 0));
  CameraView view = HeadView(200, 150);
  view.X_WC = LookAt({0, 0, 1.05}, {0, 0, 0});  // the top face is 1 m away
  const Image image = Render(scene, view);
  const double half_px = 0.05 * view.intrinsics.fx;
  for (int v = 0; v < 150; ++v) {
    for (int u = 0; u < 200; ++u) {
      const double outside_px = std::max(std::abs(u + 0.5 - 100), std::abs(v + 0.5 - 75)) - half_px;
      if (std::abs(outside_px) < 1) continue;
      const auto expected = outside_px < 0 ? std::array{255, 0, 0} : std::array{0, 0, 0};
      ASSERT_EQ(ColorAt(image, u, v), expected) << "at (" << u << ", " << v << ")";
    }
  }
}

TEST_F(RendererTest, DepthOfTheTableAgreesWithGeometry) {
  constexpr double kTolerance = 0.0005;  // [m]
  SmallScene scene;
  const std::uint32_t table = scene.Add(scene::Block{{2, 1.2, 0.4}}, kWhite, Vector3(0, 0, -0.2));
  for (const auto& p_WC :
       {Vector3(0, -0.71, 1.16), Vector3(1.5, -3, 0.8), Vector3(0.5, 0.2, 0.3)}) {
    CameraView view = HeadView(320, 240);
    view.X_WC = LookAt(p_WC, {0, 0, 0});
    const Image image = Render(scene, view);
    int num_checked = 0;
    for (int v = 0; v < 240; ++v) {
      for (int u = 0; u < 320; ++u) {
        const auto& c = view.intrinsics;
        const Vector3 ray_C((u + 0.5 - c.cx) / c.fx, (v + 0.5 - c.cy) / c.fy, 1);
        const Vector3 ray_W = view.X_WC.rotation() * ray_C;
        const double depth = -p_WC.z() / ray_W.z();
        const Vector3 p_WQ = p_WC + depth * ray_W;
        if (depth < 0 || std::abs(p_WQ.x()) > 0.99 || std::abs(p_WQ.y()) > 0.59) continue;
        ASSERT_EQ(IdAt(image, u, v), table);
        ASSERT_NEAR(image.depth[v * 320 + u], depth, kTolerance);
        ++num_checked;
      }
    }
    EXPECT_GT(num_checked, 1000);
  }
}

TEST_F(RendererTest, DepthIsZeroInTheBackground) {
  const Image image = Render(TableScene(), HeadView(200, 150));
  EXPECT_EQ(IdAt(image, 0, 0), 0u);
  for (std::size_t k = 0; k < image.ids.size(); ++k) {
    EXPECT_EQ(image.depth[k] == 0, image.ids[k] == 0);
  }
}

TEST_F(RendererTest, DepthAndIdsAreTheSameAndPureInBothStyles) {
  const Image eye = Render(TableScene(), HeadView(321, 241));
  RenderOptions options = kAllChannels;
  options.style = RenderStyle::kPresentation;
  const Image presented = Render(TableScene(), HeadView(321, 241), options);
  EXPECT_EQ(presented.ids, eye.ids);
  EXPECT_EQ(presented.depth, eye.depth);
  EXPECT_NE(presented.color, eye.color);
  EXPECT_EQ(std::set(eye.ids.begin(), eye.ids.end()), (std::set<std::uint32_t>{0, 1, 2, 3, 4}));
}

TEST_F(RendererTest, RowZeroIsTheTopAndColumnZeroTheLeft) {
  SmallScene scene;
  const auto high = scene.Add(scene::Sphere{0.1}, kRed, Vector3(0, 0, 0.3));
  const auto low = scene.Add(scene::Sphere{0.1}, kBlue, Vector3(0, 0, -0.3));
  const auto right = scene.Add(scene::Sphere{0.1}, kGreen, Vector3(0.3, 0, 0));
  CameraView view = HeadView(100, 100);
  view.X_WC = LookAt({0, -1, 0}, {0, 0, 0});
  const Image image = Render(scene, view);
  EXPECT_EQ(IdAt(image, 50, 24), high);
  EXPECT_EQ(IdAt(image, 50, 75), low);
  EXPECT_EQ(IdAt(image, 75, 50), right);
  const Image presented = Render(scene, view, kPresented);
  EXPECT_GT(ColorAt(presented, 50, 24)[0], ColorAt(presented, 50, 24)[2]);
}

TEST_F(RendererTest, TwoRenderersDrawTheSameBytes) {
  Renderer other;
  const SmallScene scene = TableScene();
  for (const RenderStyle style : {RenderStyle::kRobotEye, RenderStyle::kPresentation}) {
    RenderOptions options = kAllChannels;
    options.style = style;
    const Image first = Render(scene, HeadView(320, 240), options);
    EXPECT_TRUE(first == Render(scene, HeadView(320, 240), options));
    EXPECT_TRUE(first == other.Render(scene.model, scene.state, HeadView(320, 240), options));
  }
}

TEST_F(RendererTest, EarlierPicturesLeaveNoTrace) {
  const Image first = Render(TableScene(), HeadView(320, 240));
  SmallScene other;
  other.Add(scene::Cylinder{.sides = 5}, kGreen, Vector3(0, 0, 0));
  for (const int size : {10, 50, 100, 200, 320, 400, 500}) {
    Render(other, HeadView(size, 240), kPresented);
    Render(other, HeadView(size, 240), {.color = false, .ids = true});
  }
  EXPECT_TRUE(first == Render(TableScene(), HeadView(320, 240)));
}

TEST_F(RendererTest, ASeriesOfPicturesHasTheBytesOfSinglePictures) {
  // What stands still is not drawn again.
  std::mt19937 generator(7);
  const auto pick = [&generator](int number) { return static_cast<int>(generator() % number); };
  SmallScene scene = TableScene();
  for (int i = 0; i < 3; ++i) {
    scene.Add(scene::Block{kCubeSize}, kGreen, Vector3(-0.4 + 0.2 * i, 0.3, 0.05));
  }
  // Nothing, or some objects, also far up, where only their shadows are seen, and out of sight.
  const auto move = [&] {
    for (int moves = pick(3); moves > 0; --moves) {
      const int object = 1 + pick(static_cast<int>(scene.state.poses.size()) - 1);
      const Vector3 p_WF(-0.6 + 0.1 * pick(13), -0.4 + 0.1 * pick(9), 0.05 + 0.12 * pick(9));
      scene.state.poses[object] =
          RigidTransform(RotationFromFixedAxes({0, 0, 10.0 * pick(36)}), p_WF);
    }
  };
  const std::array views{HeadView(96, 64), HeadView(64, 48)};
  for (int step = 0; step < 60; ++step) {
    move();
    if (pick(10) == 0) scene.model.lighting.turn = pick(4);
    if (pick(10) == 0) scene.model.visuals[1].color = pick(2) == 0 ? kRed : kBlue;
    RenderOptions options = pick(2) == 0 ? kAllChannels : kPresented;
    if (pick(8) == 0) options.excluded_frames = {2};
    const CameraView& view = views[pick(2)];
    Renderer fresh;
    EXPECT_TRUE(Render(scene, view, options) ==
                fresh.Render(scene.model, scene.state, view, options))
        << step;
  }
}

TEST_F(RendererTest, MovedPrincipalPointMovesTheImage) {
  constexpr int kRight = 7, kDown = -5;
  const CameraView view = HeadView(320, 240);
  CameraView moved = view;
  moved.intrinsics.cx += kRight;
  moved.intrinsics.cy += kDown;
  const Image image = Render(TableScene(), view), moved_image = Render(TableScene(), moved);
  int num_different = 0;
  for (int v = 10; v < 230; ++v) {
    for (int u = 10; u < 310; ++u) {
      num_different += IdAt(image, u, v) != IdAt(moved_image, u + kRight, v + kDown);
    }
  }
  EXPECT_LE(num_different, 5);  // where an edge runs through a pixel's center
}

TEST_F(RendererTest, DifferentFocalLengthsStretchTheImage) {
  CameraView view = HeadView(200, 100);
  view.intrinsics.fx *= 2;
  SmallScene scene;
  const auto ball = scene.Add(scene::Sphere{0.05}, kRed, Vector3(0, 0.05, 0));
  const Eigen::Vector2d size_px = PixelsOf(Render(scene, view), ball).sizes();
  EXPECT_NEAR(size_px.x(), 2 * size_px.y(), 2);
}

TEST_F(RendererTest, AnySizeWorks) {
  for (const auto& [width, height] :
       {std::pair{1, 1}, {7, 3}, {641, 479}, {8192, 1}, {1, 8192}, {1023, 2}}) {
    for (const RenderStyle style : {RenderStyle::kRobotEye, RenderStyle::kPresentation}) {
      RenderOptions options = kAllChannels;
      options.style = style;
      const Image image = Render(TableScene(), HeadView(width, height), options);
      const auto num_pixels = static_cast<std::size_t>(width) * height;
      EXPECT_EQ(image.width_px, width);
      EXPECT_EQ(image.height_px, height);
      EXPECT_EQ(image.color.size(), 3 * num_pixels);
      EXPECT_EQ(image.depth.size(), num_pixels);
      EXPECT_EQ(image.ids.size(), num_pixels);
    }
  }
  EXPECT_EQ(Render(TableScene(), HeadView(1, 1)).ids.at(0), 1u) << "the camera looks at the table";
}

TEST_F(RendererTest, ChannelsThatWereNotRequestedAreEmpty) {
  const Image image = Render(TableScene(), HeadView(20, 20), {.color = false, .ids = true});
  EXPECT_TRUE(image.color.empty());
  EXPECT_TRUE(image.depth.empty());
  EXPECT_EQ(image.ids, Render(TableScene(), HeadView(20, 20)).ids);
}

TEST_F(RendererTest, EachOfManyIdsIsExact) {
  constexpr int kColumns = 20, kRows = 15, kPixels = 8;  // of a cell
  SmallScene scene;
  for (int k = 0; k < kColumns * kRows; ++k) {
    scene.Add(scene::Block{{0.9, 0.9, 0.9}}, kWhite, Vector3(k % kColumns, k / kColumns, 0));
  }
  // From far away, so that a cell is as large as any other in the picture.
  CameraView view{.intrinsics = {.width_px = kColumns * kPixels,
                                 .height_px = kRows * kPixels,
                                 .fx = 1000 * kPixels,
                                 .fy = 1000 * kPixels,
                                 .cx = kPixels / 2.0,
                                 .cy = kPixels / 2.0,
                                 .near = 900,
                                 .far = 1100},
                  .X_WC = RigidTransform(RotationFromFixedAxes({0, 0, 0}), {0, 0, -1000})};
  const auto expect_exact = [&](const Image& image) {
    for (int k = 0; k < kColumns * kRows; ++k) {
      EXPECT_EQ(
          IdAt(image, k % kColumns * kPixels + kPixels / 2, k / kColumns * kPixels + kPixels / 2),
          scene.model.visuals[k].object_id);
    }
  };
  for (const std::uint32_t max_id : {255u, 256u, 300u, 0xffffffffu}) {
    for (int k = 0; k < kColumns * kRows; ++k) {
      scene.model.visuals[k].object_id = std::min<std::uint32_t>(k + 1, max_id);
    }
    scene.model.visuals.back().object_id = max_id;
    expect_exact(Render(scene, view, kAllChannels));
    expect_exact(Render(scene, view, {.color = false, .ids = true}));
  }
}

TEST_F(RendererTest, LargeIdsChangeNeitherColorNorDepth) {
  SmallScene scene = TableScene();
  const Image image = Render(scene, HeadView(320, 240));
  for (scene::Visual& visual : scene.model.visuals) visual.object_id += 1000;
  const Image same = Render(scene, HeadView(320, 240));
  EXPECT_TRUE(same.color == image.color);
  EXPECT_TRUE(same.depth == image.depth);
  for (std::size_t k = 0; k < image.ids.size(); ++k) {
    EXPECT_EQ(same.ids[k], image.ids[k] == 0 ? 0 : image.ids[k] + 1000);
  }
}

TEST_F(RendererTest, AnImageMayHoldAnEarlierPicture) {
  const SmallScene scene = TableScene();
  Renderer renderer;
  Image image;
  for (const RenderOptions& options :
       {kAllChannels, RenderOptions{.depth = true}, RenderOptions{.color = false, .ids = true},
        kPresented, kAllChannels}) {
    for (const int width : {320, 200, 200}) {
      const CameraView view = HeadView(width, 150);
      renderer.Render(scene.model, scene.state, view, options, &image);
      EXPECT_TRUE(image == Render(scene, view, options));
    }
  }
}

TEST_F(RendererTest, ExcludedFramesAreNotSeen) {
  const SmallScene scene = TableScene();
  RenderOptions options = kAllChannels;
  options.excluded_frames = {2, 4};
  const Image image = Render(scene, HeadView(200, 150), options);
  EXPECT_EQ(std::set(image.ids.begin(), image.ids.end()), (std::set<std::uint32_t>{0, 1, 3}));
}

TEST_F(RendererTest, TheNearAndFarPlanesClip) {
  CameraView view = HeadView(20, 20);
  view.intrinsics.near = 1.0;
  view.intrinsics.far = 1.1;
  view.X_WC = LookAt({0, 0, 1}, {0, 0, 0});
  for (const auto& [height, is_seen] : {std::pair{-0.12, false}, {-0.08, true}, {0.02, false}}) {
    SmallScene scene;
    // Its top face alone could be seen.
    scene.Add(scene::Block{{5, 5, 1e-4}}, kRed, Vector3(0, 0, height));
    EXPECT_EQ(IdAt(Render(scene, view), 10, 10), is_seen ? 1u : 0u) << height;
  }
}

TEST_F(RendererTest, FacesOfACubeDifferInBrightnessAndKeepTheirHue) {
  constexpr int kLeastDifference = 20;
  for (const double yaw : {0.0, 90.0, 180.0, 270.0}) {
    SmallScene scene;
    scene.Add(scene::Block{kCubeSize}, Color{1, 0.5, 0.25}, Vector3::Zero());
    CameraView view = HeadView(200, 150);
    const Matrix3 turn = RotationFromFixedAxes({0, 0, yaw});
    view.X_WC = LookAt(turn * Vector3(0.3, -0.3, 0.3), {0, 0, 0});
    const Image image = Render(scene, view);
    const auto top = ColorAtPoint(image, view, {0, 0, 0.05});
    const auto right = ColorAtPoint(image, view, turn * Vector3(0.05, 0, 0));
    const auto front = ColorAtPoint(image, view, turn * Vector3(0, -0.05, 0));
    EXPECT_EQ(top, (std::array{255, 128, 64})) << "a face that looks up has the scene's color";
    EXPECT_LT(std::max(right[0], front[0]), top[0] - kLeastDifference);
    EXPECT_GT(std::abs(right[0] - front[0]), kLeastDifference);
    for (const auto& face : {right, front}) {
      EXPECT_GT(face[0], 100) << "no side is lost in the dark";
      EXPECT_NEAR(face[1] / double(face[0]), 0.5, 0.01);
      EXPECT_NEAR(face[2] / double(face[0]), 0.25, 0.01);
    }
  }
}

TEST_F(RendererTest, BackgroundIsBlackForTheRobotUnlessChosen) {
  const SmallScene nothing;
  EXPECT_EQ(ColorAt(Render(nothing, HeadView(3, 3)), 1, 1), (std::array{0, 0, 0}));
  for (const RenderStyle style : {RenderStyle::kRobotEye, RenderStyle::kPresentation}) {
    const RenderOptions options{.style = style, .background = Color{1, 0.5, 0}};
    const auto color = ColorAt(Render(nothing, HeadView(3, 3), options), 1, 1);
    EXPECT_EQ(color[0], 255);
    EXPECT_NEAR(color[1], 128, 1);
    EXPECT_EQ(color[2], 0);
  }
}

TEST_F(RendererTest, ALightMultipliesColorsAndTurnsTheBrightSide) {
  SmallScene scene;
  scene.Add(scene::Block{kCubeSize}, Color{1, 0.5, 0.5}, Vector3(0, 0, 0));
  CameraView above = HeadView(41, 41), front = above;
  above.X_WC = LookAt({0, 0, 0.6}, {0, 0, 0});
  front.X_WC = LookAt({0, -0.6, 0}, {0, 0, 0});
  const auto usual = ColorAt(Render(scene, above), 20, 20);
  const int bright_side = ColorAt(Render(scene, front), 20, 20)[0];
  scene.model.lighting = {.brightness = 0.5, .color = {1, 0.5, 1}, .background = Color{0, 0, 1}};
  const Image dim = Render(scene, above);
  EXPECT_EQ(usual, (std::array{255, 128, 128}));
  EXPECT_EQ(ColorAt(dim, 20, 20), (std::array{128, 32, 64}));
  EXPECT_EQ(ColorAt(dim, 0, 0), (std::array{0, 0, 255}));
  scene.model.lighting = {.turn = std::numbers::pi};
  EXPECT_EQ(ColorAt(Render(scene, above), 20, 20), usual);
  EXPECT_LT(ColorAt(Render(scene, front), 20, 20)[0], bright_side - 50);
}

TEST_F(RendererTest, ALampThatIsTurnedCastsShadowsToTheOtherSide) {
  SmallScene scene = TableScene();
  const CameraView view = HeadView(160, 120);
  const Vector3 behind = Vector3(-0.2, 0, 0) + 0.08 * Vector3(0.9, 1, 0);
  const int shaded = ColorAtPoint(Render(scene, view, kPresented), view, behind)[0];
  scene.model.lighting.turn = std::numbers::pi;
  EXPECT_GT(ColorAtPoint(Render(scene, view, kPresented), view, behind)[0], shaded + 30);
}

TEST_F(RendererTest, ATableMayHaveAPattern) {
  scene::TableSpec table{.color = kWhite,
                         .pattern = scene::TablePattern::kChecks,
                         .pattern_color = kGreen,
                         .pattern_span = 0.1};
  SmallScene scene;
  const auto draw = [&] {
    scene.model.visuals = scene::VisualsOf(table);
    for (scene::Visual& visual : scene.model.visuals) visual.object_id = 1;
    return Render(scene, HeadView(320, 240));
  };
  scene.model.object_names = {"", "table"};
  const CameraView view = HeadView(320, 240);
  // The first square, at the left and in front, has the color of the table.
  const Image checks = draw();
  const std::array white{255, 255, 255}, green{0, 255, 0};
  EXPECT_EQ(ColorAtPoint(checks, view, {-0.05, -0.05, 0}), white);
  EXPECT_EQ(ColorAtPoint(checks, view, {0.05, -0.05, 0}), green);
  EXPECT_EQ(ColorAtPoint(checks, view, {0.05, 0.05, 0}), white);
  // No rim of the paint shows between the squares, only the front of the table below them.
  std::set<std::array<int, 3>> colors;
  for (int y = 0; y < 240; ++y) {
    for (int x = 0; x < 320; ++x) {
      if (IdAt(checks, x, y) == 1) colors.insert(ColorAt(checks, x, y));
    }
  }
  EXPECT_EQ(colors, (std::set{white, green, std::array{201, 201, 201}}));
  table.pattern = scene::TablePattern::kStripes;
  const Image stripes = draw();
  EXPECT_EQ(ColorAtPoint(stripes, view, {-0.05, -0.05, 0}),
            ColorAtPoint(stripes, view, {-0.05, 0.25, 0}));
}

TEST_F(RendererTest, PresentationHasShadowsAndTheRobotsEyeHasNone) {
  SmallScene scene;
  scene.Add(scene::Block{{2, 1.2, 0.4}}, kWhite, Vector3(0, 0, -0.2));
  const auto cube = scene.Add(scene::Block{kCubeSize}, kRed, Vector3(0, 0, 0.3));
  const CameraView view = HeadView(320, 240);
  // The lamp shines from the left and from the front: the shadow falls to the right, behind.
  const Vector3 shaded = 0.3 * Vector3(0.45, 0.5, 0), lit(-0.3, 0, 0);
  const auto brightness = [&](const Image& image, const Vector3& p_WQ) {
    return ColorAtPoint(image, view, p_WQ)[1];
  };
  const Image presented = Render(scene, view, kPresented);
  EXPECT_LT(brightness(presented, shaded), brightness(presented, lit) - 30);
  EXPECT_GT(brightness(presented, shaded), 100) << "a shadow is not a hole";
  const Image eye = Render(scene, view);
  EXPECT_EQ(brightness(eye, shaded), brightness(eye, lit));
  RenderOptions without_cube = kPresented;
  without_cube.excluded_frames = {static_cast<int>(cube)};
  const Image alone = Render(scene, view, without_cube);
  EXPECT_NEAR(brightness(alone, shaded), brightness(alone, lit), 8);
}

TEST_F(RendererTest, GlowingPartsKeepTheirColorInAnyLight) {
  const Color orange{1, 0.5, 0.25};
  SmallScene scene;
  scene.Add(scene::Block{kCubeSize}, orange, Vector3(0, 0, 0));
  // Its dark side, in the shadow of a roof.
  scene.Add(scene::Block{{1, 1, 0.02}}, kWhite, Vector3(0, 0, 0.2));
  CameraView view = HeadView(41, 41);
  view.X_WC = LookAt({0, 0.6, 0}, {0, 0, 0});
  for (const RenderStyle style : {RenderStyle::kRobotEye, RenderStyle::kPresentation}) {
    scene.model.visuals[0].glows = false;
    EXPECT_LT(ColorAt(Render(scene, view, {.style = style}), 20, 20)[0], 170);
    scene.model.visuals[0].glows = true;
    const auto color = ColorAt(Render(scene, view, {.style = style}), 20, 20);
    EXPECT_EQ(color[0], 255);
    EXPECT_NEAR(color[1], 128, 1);
    EXPECT_EQ(color[2], 64);
  }
}

TEST_F(RendererTest, APartWithoutShadowChangesNoOther) {
  SmallScene scene = TableScene();
  const CameraView view = HeadView(160, 120);
  const Image before = Render(scene, view, kPresented);
  const auto marker = scene.Add(scene::Block{kCubeSize}, kRed, Vector3(-0.1, -0.2, 0.6));
  const auto num_other = [&](const Image& image) {
    const Image ids = Render(scene, view, {.ids = true});
    int count = 0;
    for (std::size_t i = 0; i < ids.ids.size(); ++i) {
      const bool is_same =
          std::equal(&image.color[3 * i], &image.color[3 * i] + 3, &before.color[3 * i]);
      // Smooth edges mix in what is beside them.
      const bool is_beside = ids.ids[i] == marker || (i > 0 && ids.ids[i - 1] == marker) ||
                             (i + 1 < ids.ids.size() && ids.ids[i + 1] == marker) ||
                             (i >= 160 && ids.ids[i - 160] == marker) ||
                             (i + 160 < ids.ids.size() && ids.ids[i + 160] == marker);
      if (!is_same && !is_beside) ++count;
    }
    return count;
  };
  EXPECT_GT(num_other(Render(scene, view, kPresented)), 100);
  scene.model.visuals.back().casts_shadow = false;
  EXPECT_EQ(num_other(Render(scene, view, kPresented)), 0);
}

TEST_F(RendererTest, RefusesWhatCannotBeDrawnAndDrawsOn) {
  SmallScene scene = TableScene();
  const auto refuses = [&](const CameraView& view, const RenderOptions& options = {}) {
    EXPECT_THROW(Render(scene, view, options), std::invalid_argument);
  };
  CameraView view = HeadView(20, 20);
  view.intrinsics.width_px = 0;
  refuses(view);
  view = HeadView(20, 20);
  view.intrinsics.height_px = 8193;
  refuses(view);
  view = HeadView(20, 20);
  view.intrinsics.fx = 0;
  refuses(view);
  view = HeadView(20, 20);
  view.intrinsics.cy = std::nan("");
  refuses(view);
  view = HeadView(20, 20);
  view.intrinsics.near = view.intrinsics.far;
  refuses(view);
  refuses(HeadView(20, 20), {.excluded_frames = {99}});
  scene.state.poses.pop_back();
  refuses(HeadView(20, 20));
  scene = TableScene();
  scene.model.visuals[0].frame = -1;
  refuses(HeadView(20, 20));
  EXPECT_EQ(IdAt(Render(TableScene(), HeadView(20, 20)), 10, 10), 1u);
}

TEST_F(RendererTest, EachThreadMayHaveItsOwn) {
  const SmallScene scene = TableScene();
  const Image here = Render(scene, HeadView(64, 48));
  for (int round = 0; round < 3; ++round) {
    Image there;
    std::thread([&] {
      there = Renderer().Render(scene.model, scene.state, HeadView(64, 48), kAllChannels);
    }).join();
    EXPECT_TRUE(there == here);
  }
  { Renderer short_lived; }
  EXPECT_TRUE(Render(scene, HeadView(64, 48)) == here);
}

TEST_F(RendererTest, SurvivesPosesThatAreNoNumbers) {
  SmallScene scene = TableScene();
  scene.state.poses[2] = RigidTransform(Vector3::Constant(std::nan("")));
  scene.state.poses[3] = RigidTransform(Vector3(0, 0, -1e300));
  const Image image = Render(scene, HeadView(64, 48), kPresented);
  EXPECT_EQ(image.color.size(), 3u * 64 * 48);
}

TEST(Renderer, NamesTheVariableThatRequestsAnUnknownPlatform) {
  setenv("SMILE_EGL_PLATFORM", "window", 1);
  try {
    Renderer renderer;
    ADD_FAILURE() << "was made";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "SMILE_EGL_PLATFORM: is \"window\", expected device or surfaceless");
  }
  unsetenv("SMILE_EGL_PLATFORM");
}

TEST_F(RendererTest, ShowsAMeshOfACubeAsABlock) {
  scene::CustomMesh cube;
  for (int i = 0; i < 8; ++i) {
    cube.surface.vertices.emplace_back(i & 1 ? 0.5f : -0.5f, i & 2 ? 0.5f : -0.5f,
                                       i & 4 ? 0.5f : -0.5f);
  }
  cube.surface.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                            {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  const auto shared = std::make_shared<const scene::CustomMesh>(cube);
  const auto picture = [&](const scene::VisualShape& shape) {
    SmallScene scene;
    scene.Add(shape, kRed, RigidTransform(RotationFromFixedAxes({10, 20, 30}), {0, 0, 0.1}));
    return Render(scene, HeadView(160, 120));
  };
  const Image block = picture(scene::Block{{0.2, 0.2, 0.2}});
  const Image mesh = picture(scene::DrawnMesh{shared, 0.2});
  EXPECT_EQ(mesh.color, block.color);
  EXPECT_EQ(mesh.ids, block.ids);
}

}  // namespace
}  // namespace smile::camera
