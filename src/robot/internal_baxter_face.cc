#include "robot/internal_baxter_face.h"

#include <cmath>
#include <numbers>

namespace smile::robot::internal {
namespace {

using Eigen::Vector2d;
using mesh::Outline;

constexpr Color kWhite{1, 1, 1}, kInk{0.16, 0.17, 0.20}, kIris{0.25, 0.45, 0.58};
constexpr double kLayer = 0.0004;  ///< between one layer of the drawing and the next [m]

/// Everything here is drawn with x away from the nose; the eye at -x is the mirror image. Lengths
/// in metres, in the frame of the eye: y up.
struct EyeDrawing {
  double upper_lid = 1, lower_lid = -1;  ///< where they cut the eye: 1 is its top, -1 its bottom
  double lid_slant = 0;                  ///< rise of the upper lid per metre away from the nose
  Vector2d gaze{0, 0};                   ///< middle of the pupil
  double pupil = 0.0098;                 ///< radius
  double brow_height = 0.050;            ///< of its middle
  double brow_slant = 0;                 ///< its rise per metre away from the nose
  double brow_arch = 0.004;              ///< by how much its middle is above its ends
};

struct FaceDrawing {
  Color background;
  EyeDrawing left, right;    ///< as who looks at the face has them
  bool are_smiling = false;  ///< both eyes are shut, and laugh
};

FaceDrawing DrawingOf(Mood mood) {
  const auto both = [](const Color& background, const EyeDrawing& eye) {
    return FaceDrawing{background, eye, eye};
  };
  switch (mood) {
    case Mood::kIdle:
      return both({0.93, 0.94, 0.96}, {.upper_lid = 0.22,
                                       .lower_lid = -0.92,
                                       .gaze = {0, -0.009},
                                       .brow_height = 0.0435,
                                       .brow_slant = -0.10});
    case Mood::kWatching:
      return both({1.00, 1.00, 0.98}, {.gaze = {-0.002, -0.008},
                                       .pupil = 0.0115,
                                       .brow_height = 0.0555,
                                       .brow_slant = -0.05,
                                       .brow_arch = 0.0075});
    case Mood::kWorking:
      return both({0.78, 0.92, 1.00}, {.upper_lid = 0.50,
                                       .lower_lid = -0.86,
                                       .lid_slant = 0.06,
                                       .gaze = {-0.003, -0.0115},
                                       .brow_height = 0.0455,
                                       .brow_slant = 0.09,
                                       .brow_arch = 0.0035});
    case Mood::kPuzzled:
      return {{1.00, 0.86, 0.50},
              {.upper_lid = 0.25,
               .lower_lid = -0.62,
               .lid_slant = 0.15,
               .gaze = {0.006, 0.000},
               .pupil = 0.0080,
               .brow_height = 0.0390,
               .brow_slant = 0.20,
               .brow_arch = 0.001},
              {.gaze = {-0.006, 0.003},
               .pupil = 0.0080,
               .brow_height = 0.0575,
               .brow_slant = -0.38,
               .brow_arch = 0.006}};
    case Mood::kDone:
      break;
  }
  FaceDrawing done = both({0.74, 0.98, 0.76}, {.brow_height = 0.0500, .brow_arch = 0.0085});
  done.are_smiling = true;
  return done;
}

constexpr double kEyeX = 0.054, kEyeY = -0.016;  ///< of the eyes' middle on the display
constexpr double kHalfWidth = 0.0375, kHalfHeight = 0.0330;

/// What of a convex outline lies to the left of the line through `a` and `b`.
Outline LeftOf(const Vector2d& a, const Vector2d& b, const Outline& outline) {
  const auto side = [&](const Vector2d& p) {
    return (b - a).x() * (p - a).y() - (b - a).y() * (p - a).x();
  };
  Outline kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d &p = outline[i], &q = outline[(i + 1) % outline.size()];
    const double at_p = side(p), at_q = side(q);
    if (at_p >= 0) kept.push_back(p);
    if ((at_p >= 0) != (at_q >= 0)) kept.emplace_back(p + (q - p) * (at_p / (at_p - at_q)));
  }
  return kept;
}

/// What two convex outlines have in common.
Outline Common(const Outline& a, Outline b) {
  for (std::size_t i = 0; i < a.size(); ++i) b = LeftOf(a[i], a[(i + 1) % a.size()], b);
  return b;
}

/// The opening between the lids, `rim` larger than the white of the eye all around.
Outline Opening(const EyeDrawing& eye, double rim) {
  Outline outline = mesh::CircleOutline(1, 40);
  for (Vector2d& p : outline) p = {p.x() * (kHalfWidth + rim), p.y() * (kHalfHeight + rim)};
  const double upper = eye.upper_lid * kHalfHeight + 1.6 * rim;  // lashes: the upper rim is bolder
  const double lower = eye.lower_lid * kHalfHeight - rim;
  outline = LeftOf({1, upper + eye.lid_slant}, {-1, upper - eye.lid_slant}, outline);
  return LeftOf({-1, lower}, {1, lower}, outline);
}

Outline Disc(const Vector2d& center, double radius) {
  Outline outline = mesh::CircleOutline(radius, 28);
  for (Vector2d& p : outline) p += center;
  return outline;
}

/// A bold line, curved upwards by `arch` in the middle, with round ends.
Outline Stroke(double length, double width, double slant, double arch) {
  constexpr int kParts = 12, kEnd = 6;
  std::vector<Vector2d> line;
  for (int k = 0; k <= kParts; ++k) {
    const double t = 2.0 * k / kParts - 1;
    line.emplace_back(t * length / 2, slant * t * length / 2 + arch * (1 - t * t));
  }
  Outline outline;
  const auto add_end = [&](const Vector2d& center, const Vector2d& along) {
    const double start = std::atan2(along.y(), along.x()) - std::numbers::pi / 2;
    for (int k = 0; k <= kEnd; ++k) {
      const double angle = start + std::numbers::pi * k / kEnd;
      outline.emplace_back(center + width / 2 * Vector2d(std::cos(angle), std::sin(angle)));
    }
  };
  const auto normal = [&](int k) {
    const Vector2d along = (line[k + 1] - line[k - 1]).normalized();
    return Vector2d(-along.y(), along.x());
  };
  for (int k = 1; k < kParts; ++k) outline.emplace_back(line[k] - width / 2 * normal(k));
  add_end(line.back(), line.back() - line[kParts - 1]);
  for (int k = kParts - 1; k > 0; --k) outline.emplace_back(line[k] + width / 2 * normal(k));
  add_end(line.front(), line.front() - line[1]);
  return outline;
}

/// Collects the pieces of one color each.
class Painting {
 public:
  explicit Painting(const RigidTransform& X_LD) : X_LD_(X_LD) {}

  void Add(std::vector<scene::SurfaceMesh>* paint, const Outline& outline, int layer,
           double side) const {
    if (outline.size() < 3) return;  // hidden by a lid
    scene::SurfaceMesh piece = mesh::FlatPiece(outline, kLayer * layer);
    for (Eigen::Vector3f& p : piece.vertices) {
      p.x() = static_cast<float>(side) * (p.x() + static_cast<float>(kEyeX));
      p.y() += static_cast<float>(kEyeY);
    }
    if (side < 0) {
      for (auto& triangle : piece.triangles) std::swap(triangle[1], triangle[2]);
    }
    paint->push_back(mesh::Placed(X_LD_, std::move(piece)));
  }

  void AddEye(const EyeDrawing& eye, double side) {
    const Outline white = Opening(eye, 0);
    Add(&ink_, Opening(eye, 0.0032), 1, side);
    Add(&white_, white, 2, side);
    Add(&iris_, Common(white, Disc(eye.gaze, 0.0195)), 3, side);
    Add(&ink_, Common(white, Disc(eye.gaze, eye.pupil)), 4, side);
    // Light comes from above: the same side in both eyes.
    const Vector2d glint(eye.gaze.x() - side * 0.0068, eye.gaze.y() + 0.0075);
    Add(&white_, Common(white, Disc(glint, 0.0042)), 5, side);
  }

  void AddSmile(double side) {
    Outline arc = Stroke(0.062, 0.0085, 0, 0.026);
    for (Vector2d& p : arc) p.y() -= 0.010;
    Add(&ink_, arc, 1, side);
  }

  void AddBrow(const EyeDrawing& eye, double side) {
    Outline brow = Stroke(0.060, 0.0088, eye.brow_slant, eye.brow_arch);
    for (Vector2d& p : brow) p.y() += eye.brow_height;
    Add(&ink_, brow, 1, side);
  }

  LinkLook Take(const Color& background) {
    const Outline display = mesh::RoundedOutline(
        {{-0.112, -0.074}, {0.112, -0.074}, {0.112, 0.074}, {-0.112, 0.074}}, 0.008, 4);
    LinkLook look{PieceOf(background, {mesh::Placed(X_LD_, mesh::FlatPiece(display, 0))}),
                  PieceOf(kInk, ink_)};
    if (!white_.empty()) look.push_back(PieceOf(kWhite, white_));
    if (!iris_.empty()) look.push_back(PieceOf(kIris, iris_));
    return look;
  }

 private:
  RigidTransform X_LD_;
  std::vector<scene::SurfaceMesh> ink_, white_, iris_;
};

}  // namespace

LinkLook FaceLook(Mood mood, const RigidTransform& X_LD) {
  const FaceDrawing face = DrawingOf(mood);
  Painting painting(X_LD);
  for (const double side : {-1.0, 1.0}) {
    const EyeDrawing& eye = side < 0 ? face.left : face.right;
    if (face.are_smiling) {
      painting.AddSmile(side);
    } else {
      painting.AddEye(eye, side);
    }
    painting.AddBrow(eye, side);
  }
  LinkLook look = painting.Take(face.background);
  for (LookPiece& piece : look) piece.mood = mood;
  return look;
}

}  // namespace smile::robot::internal
