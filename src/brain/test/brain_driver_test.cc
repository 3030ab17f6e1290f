#include "brain/brain_driver.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/files.h"
#include "robot/urdf_reader.h"

namespace smile::brain {
namespace {

/// An eye whose pictures are all alike.
class GrayEye : public sim::Eye {
 public:
  const Image& Draw(const scene::VisualModel&, const sim::Sight&) override { return image_; }
  const sim::EyeSpec& spec() const override { return spec_; }

 private:
  sim::EyeSpec spec_{.width_px = 2, .height_px = 1};
  Image image_{.width_px = 2, .height_px = 1, .color = std::vector<std::uint8_t>(6, 128)};
};

/// A driver whose brain is the test.
class BrainDriverTest : public ::testing::Test {
 protected:
  static sim::RobotPlacement Baxter() {
    static const robot::RobotModel kBaxter = robot::ReadRobot(DataFile("robots/baxter.urdf"));
    return {.model = kBaxter};
  }

  void TickSeconds(double seconds) {
    for (int i = 0; i < seconds * sim::kTicksPerSecond; ++i) simulation_.Tick();
  }
  void Start(const InitReply& reply = {}) {
    EXPECT_TRUE(std::holds_alternative<Aux>(driver_.Ask(&simulation_)));
    driver_.Take(reply, &simulation_);
    EXPECT_EQ(driver_.status(), BrainStatus::kRunning);
  }
  Sensor Step(const StepReply& reply = {}) {
    const Sensor sensor = std::get<Sensor>(driver_.Ask(&simulation_));
    driver_.Take(reply, &simulation_);
    simulation_.Tick();
    return sensor;
  }

  GrayEye eye_;
  sim::Simulation simulation_{scene::SceneSpec{.name = "test"}, Baxter()};
  BrainDriver driver_{{.eye = &eye_}};
};

TEST_F(BrainDriverTest, PicturesComeAtTheirRateInAnOldSimulation) {
  TickSeconds(2);
  Start();
  std::vector<int> steps_with_picture;
  for (int step = 0; step < 40; ++step) {
    if (!Step().pictures.empty()) steps_with_picture.push_back(step);
  }
  EXPECT_EQ(steps_with_picture, (std::vector<int>{0, 15, 30}));
}

}  // namespace
}  // namespace smile::brain
