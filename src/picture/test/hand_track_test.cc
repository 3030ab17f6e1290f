#include "picture/hand_track.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "picture/surface_probe.h"
#include "recorder/test/recording_fixture.h"
#include "recording/trace_reader.h"
#include "recording/view_sample.h"

namespace smile::picture {
namespace {

constexpr double kSpeedLimit = 1.5;  ///< [m/s]

/// Two blocks, and a plank that lies across.
constexpr const char* kTable = R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <block id="a" location="(0, -2, 0.5)"/>
  <block id="b" location="(3, -2, 0.5)" rotation="(0, 0, 30)"/>
  <block id="plank" location="(-4, 1, 0.5)" xspan="3" yspan="1" zspan="1"/>
</tabletop>)xml";

class HandTrackTest : public recorder::RecordingFixture {
 protected:
  /// The track of a script's recording.
  HandTrack TrackOf(const char* script, const char* xml = kTable) {
    if (!recording_) recording_ = recording::OpenRecording(Record(script, false, nullptr, xml));
    return HandTrack(*recording_);
  }

  std::optional<recording::Recording> recording_;
};

/// How far a point is from a cuboid about the origin, from outside or inside [m].
double DistanceToCuboid(const Vector3& p, const Vector3& half_size) {
  const Vector3 q = p.cwiseAbs() - half_size;
  const double outside = q.cwiseMax(0).norm();
  return outside > 0 ? outside : -q.maxCoeff();
}

constexpr const char* kWork = R"({"do":"wait","seconds":1}
{"hand":"right","do":"grasp","object":"a"}
{"hand":"right","do":"move_to","position":[-2,-1,3]}
{"do":"wait","until":"arrived"}
{"hand":"right","do":"rotate","angles":[0,0,90]}
{"hand":"left","do":"grasp","object":"b"}
{"hand":"left","do":"move_to","position":[4,1,2]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"release"}
{"do":"wait","seconds":0.9}
{"hand":"right","do":"move_to","position":[-2,-1,0.51]}
{"do":"wait","until":"arrived"}
{"hand":"right","do":"release"}
{"do":"wait","seconds":4}
{"hand":"both","do":"grasp","object":"plank"}
{"hand":"both","do":"move_to","position":[0,2,2]}
{"do":"wait","until":"arrived"}
{"hand":"both","do":"release"}
{"do":"wait","seconds":2}
{"hand":"any","do":"point","part":"a"}
{"do":"wait","seconds":2})";

TEST_F(HandTrackTest, NeverJumpsNorHurries) {
  const HandTrack track = TrackOf(kWork);
  recording::TraceReader trace(*recording_);
  double fastest = 0;
  std::optional<std::array<HandPosture, 2>> before;
  while (const auto moment = trace.Next()) {
    const auto now = track.At(moment->tick);
    for (const HandSide side : kHandSides) {
      if (!before) continue;
      const auto k = static_cast<std::size_t>(side);
      const auto from = FingertipsInHand(side, (*before)[k]), to = FingertipsInHand(side, now[k]);
      const RigidTransform &X_from = (*before)[k].X_WH, &X_to = now[k].X_WH;
      const double moved = (X_to.translation() - X_from.translation()).norm();
      fastest = std::max(fastest, moved * sim::kTicksPerSecond);
      // Also where it turns and closes.
      for (std::size_t tip = 0; tip < to.size(); ++tip) {
        EXPECT_LT((X_to * to[tip] - X_from * from[tip]).norm(), 0.05) << moment->tick;
      }
      const auto arm_from = PiecePoses(side, (*before)[k], 0.6),
                 arm_to = PiecePoses(side, now[k], 0.6);
      for (std::size_t piece = 0; piece < kArmPieces; ++piece) {
        EXPECT_LT((arm_to[piece].translation() - arm_from[piece].translation()).norm(), 0.05)
            << moment->tick << ", piece " << piece;
      }
      const double turned =
          Eigen::AngleAxisd(Matrix3(X_from.rotation().transpose() * X_to.rotation())).angle();
      EXPECT_LT(turned, 0.13) << moment->tick;
    }
    before = now;
  }
  EXPECT_LT(fastest, kSpeedLimit);
  EXPECT_GT(fastest, 0.5);
  EXPECT_EQ(before->at(0), track.At(1u << 30)[0]);
}

TEST_F(HandTrackTest, TouchesWhatItHolds) {
  const HandTrack track = TrackOf(kWork);
  recording::TraceReader trace(*recording_);
  int num_held = 0;
  while (const auto moment = trace.Next()) {
    for (const HandSide side : kHandSides) {
      const auto k = static_cast<std::size_t>(side);
      for (const ContactInterval& interval : track.schedule().of[k]) {
        const bool is_held = interval.kind == ContactInterval::Kind::kHold &&
                             moment->tick >= interval.first && moment->tick < interval.last;
        if (!is_held) continue;
        ++num_held;
        const HandPosture& hand = track.At(moment->tick)[k];
        const RigidTransform X_WB = moment->objects[interval.object].pose_in_world();
        const Vector3 half_size =
            interval.object == 2 ? Vector3(0.15, 0.05, 0.05) : Vector3(0.05, 0.05, 0.05);
        // Thumb and index finger lie on it, the point at which it was grasped between them.
        const auto tips = FingertipsInHand(side, hand);
        for (const std::size_t tip : {0u, 1u}) {
          const Vector3 p_BTip = X_WB.inverse() * (hand.X_WH * tips[tip]);
          EXPECT_LT(DistanceToCuboid(p_BTip, half_size), 0.0095)
              << "tick " << moment->tick << ", object " << interval.object;
        }
        const Vector3 p_HQ = hand.X_WH.inverse() * (X_WB * interval.p_BQ);
        EXPECT_LT(std::hypot(p_HQ.y(), p_HQ.z()), 0.045) << moment->tick;
        EXPECT_LT(p_HQ.x(), tips[1].x());
        EXPECT_GT(p_HQ.x(), tips[0].x());
      }
    }
  }
  EXPECT_GT(num_held, 100);
}

TEST_F(HandTrackTest, GivesAnyToTheHandThatIsFree) {
  const HandTrack track = TrackOf(R"({"hand":"any","do":"grasp","object":"b"}
{"do":"wait","seconds":0.5}
{"hand":"left","do":"grasp","object":"a"}
{"do":"wait","seconds":0.5}
{"hand":"left","do":"release"}
{"hand":"any","do":"release"}
{"do":"wait","seconds":1}
{"hand":"any","do":"grasp","object":"b"}
{"do":"wait","seconds":0.5})");
  const auto& [left, right] = track.schedule().of;
  // `b` is on the left hand's side, but that is needed for `a`; later it is not.
  ASSERT_EQ(right.size(), 1u);
  EXPECT_EQ(right[0].object, model::ObjectIndex(1));
  ASSERT_EQ(left.size(), 2u);
  EXPECT_EQ(left[0].object, model::ObjectIndex(0));
  EXPECT_EQ(left[1].object, model::ObjectIndex(1));
}

TEST_F(HandTrackTest, CrossesNoArmsThatNeedNot) {
  // As seen from the robot's side.
  const HandTrack track = TrackOf(R"({"hand":"left","do":"grasp","object":"plank"}
{"hand":"right","do":"grasp","object":"b"}
{"do":"wait","seconds":0.5})");
  const auto& [left, right] = track.schedule().of;
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].object, model::ObjectIndex(1));
  ASSERT_EQ(right.size(), 1u);
  EXPECT_EQ(right[0].object, model::ObjectIndex(2));
}

TEST_F(HandTrackTest, TakesHoldAtTheLoggedPlace) {
  const HandTrack track = TrackOf(
      R"({"hand":"right","do":"grasp","object":"plank","point":[-5.2,1,0.8]}
{"hand":"right","do":"move_to","position":[-5.2,1,3]}
{"do":"wait","until":"arrived"})");
  const auto& right = track.schedule().of[1];
  ASSERT_EQ(right.size(), 1u);
  EXPECT_LT((right[0].p_BQ - Vector3(-0.12, 0, 0.03)).norm(), 1e-6);
}

TEST_F(HandTrackTest, ArrivesLateRatherThanJumps) {
  const HandTrack track = TrackOf(R"({"hand":"right","do":"grasp","object":"a"}
{"do":"wait","seconds":0.5}
{"hand":"right","do":"release"}
{"hand":"right","do":"grasp","object":"plank"}
{"do":"wait","seconds":1})");
  const auto& right = track.schedule().of[1];
  ASSERT_EQ(right.size(), 2u);
  const Vector3 goal = right[1].begin.poses[3] * right[1].p_BQ;
  const auto distance = [&](std::uint64_t tick) {
    return (track.At(tick)[1].X_WH.translation() - goal).norm();
  };
  EXPECT_GT(distance(right[1].first + 6), 0.2);
  EXPECT_LT(distance(right[1].first + 30), 0.05);
}

TEST_F(HandTrackTest, IsReproducible) {
  const HandTrack one = TrackOf(kWork), other = TrackOf(kWork);
  for (std::uint64_t tick = 0; tick < 1200; ++tick) EXPECT_EQ(one.At(tick), other.At(tick));
}

TEST_F(HandTrackTest, FindsMaterialToTakeHoldOf) {
  // The origin of a box container is in the hollow.
  (void)TrackOf("{\"do\":\"wait\",\"seconds\":0.1}",
                R"xml(<tabletop xmlns="http://synapse.cs.umd.edu/tabletop-xml">
  <box id="bin" location="(0, 0, 1)" xspan="4" yspan="4" zspan="2"/>
</tabletop>)xml");
  const model::Model& model = *recording_->model;
  const SurfaceProbe probe(model);
  const auto variants = recording::VisualStateAt(recording::StartOf(model), model).variants;
  const model::FrameIndex bin = model.frame_of(*model.FindObject("bin"));
  const Vector3 hollow(0, 0, 0.05);
  EXPECT_EQ(probe.Around(bin, variants, hollow, Vector3::UnitX()).to, 0);
  const Vector3 wall = probe.PointWithin(bin, variants, hollow);
  const Span through = probe.Around(bin, variants, wall, Vector3::UnitZ());
  EXPECT_GT(through.to - through.from, 0.015);
  EXPECT_EQ(probe.PointWithin(bin, variants, wall), wall);
}

}  // namespace
}  // namespace smile::picture
