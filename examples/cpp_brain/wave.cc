// A brain in C++: waves with both arms, and opens and closes the grippers.

#include <cmath>
#include <cstdio>

#include "brain_client/brain.h"

namespace {

constexpr double kPeriod = 4;   // seconds for one wave
constexpr double kSpeed = 0.4;  // rad/s at the fastest

class Wave : public smile::brain_client::Brain {
 public:
  void Init(smile::brain_client::Aux& aux) override {
    Eigen::MatrixXd angles(2, 7);
    angles << 0, -0.5, 0, 1.0, 0, 0.5, 0,  //
        0, -0.5, 0, 1.0, 0, 0.5, 0;
    aux.init_joint_angles = angles;
    aux.notes = {"plan: waves with both arms"};
  }

  void Step(const smile::brain_client::Sensor& sensor, smile::brain_client::Motor& motor,
            smile::brain_client::Aux& /*aux*/) override {
    const double time = sensor.Number("simTime");
    const double swing = std::cos(2 * M_PI * time / kPeriod);
    for (const int joint : {0, 4}) {
      motor.joint_velocities.col(joint) << kSpeed * swing, -kSpeed * swing;
    }
    motor.gripper_velocities << 0.5 * swing, 0.5 * swing;

    if (time < next_report_) return;
    const Eigen::MatrixXd grippers = sensor.Matrix("endEffPos");
    std::printf("%5.1f s: left gripper at %6.2f %6.2f %6.2f\n", time, grippers(0, 0),
                grippers(0, 1), grippers(0, 2));
    next_report_ += kPeriod;
  }

 private:
  double next_report_ = 0;  // when to print again, in seconds
};

}  // namespace

int main() {
  Wave wave;
  return smile::brain_client::Run(wave);
}
