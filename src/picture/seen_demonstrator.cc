#include "picture/seen_demonstrator.h"

#include <utility>

// A copy of the recording's visual model with the demonstrator's arms appended. Frames and object
// ids of the model itself do not change, so ids in pictures mean the same with and without arms.

namespace smile::picture {
namespace {

constexpr Color kSkin{.red = 0.87, .green = 0.66, .blue = 0.53};
constexpr Color kSleeve{.red = 0.30, .green = 0.38, .blue = 0.50};
constexpr Color kGhost{.red = 0.45, .green = 0.66, .blue = 0.98};

}  // namespace

SeenDemonstrator::SeenDemonstrator(const recording::Recording& recording,
                                   DemonstratorAppearance appearance)
    : appearance_(appearance),
      table_edge_(recording.scene().table.y_span / 2),
      track_(recording),
      visual_model_(recording.model->visual_model()) {
  for (const HandSide side : kHandSides) AddHand(side);
}

void SeenDemonstrator::AddHand(HandSide side) {
  object_ids_[static_cast<std::size_t>(side)] =
      static_cast<std::uint32_t>(visual_model_.object_names.size());
  visual_model_.object_names.push_back(side == HandSide::kLeft ? "demonstrator's left hand"
                                                               : "demonstrator's right hand");
  std::vector<ArmPiece> pieces = PiecesOf(side);
  // A ghost has hands only, which are the first pieces.
  pieces.resize(num_pieces());
  for (ArmPiece& piece : pieces) {
    scene::Visual visual;
    visual.shape = std::move(piece.mesh);
    visual.color = appearance_ == DemonstratorAppearance::kGhost ? kGhost
                   : piece.is_sleeve                             ? kSleeve
                                                                 : kSkin;
    // Each piece moves by itself.
    visual.frame = visual_model_.num_frames++;
    visual.object_id = object_id(side);
    // A ghost casts none, as it is not there.
    visual.casts_shadow = appearance_ == DemonstratorAppearance::kForearm;
    visual_model_.visuals.push_back(std::move(visual));
  }
}

void SeenDemonstrator::AddTo(scene::VisualState* state, std::uint64_t tick) const {
  const auto& hands = track_.At(tick);
  for (const HandSide side : kHandSides) {
    const auto poses = PiecePoses(side, hands[static_cast<std::size_t>(side)], table_edge_);
    // The order of frames is that of AddHand(): all pieces of the left hand, then of the right.
    state->poses.insert(state->poses.end(), poses.begin(),
                        poses.begin() + static_cast<std::ptrdiff_t>(num_pieces()));
  }
}

std::unique_ptr<const SeenDemonstrator> DemonstratorOf(const recording::Recording& recording,
                                                       DemonstratorAppearance appearance) {
  if (appearance == DemonstratorAppearance::kInvisible) return nullptr;
  return std::make_unique<const SeenDemonstrator>(recording, appearance);
}

}  // namespace smile::picture
