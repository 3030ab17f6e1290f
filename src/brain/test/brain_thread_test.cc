#include "brain/brain_thread.h"

#include "brain_fixture.h"

namespace smile::brain {
namespace {

using namespace std::chrono_literals;

class BrainThreadTest : public BrainProcessTest {
 protected:
  static BrainAnswer AnswerOf(BrainThread* thread) {
    auto answer = thread->WaitForAnswer(20s);
    EXPECT_TRUE(answer.has_value());
    return answer.value_or(BrainError{});
  }
};

TEST_F(BrainThreadTest, AnswersInItsOwnTime) {
  BrainThread thread(Program("think.py",
                             "def step(sensor, motor, aux):\n"
                             "  if sensor.simTime == 1: motor.headVelocity = 0.25\n"
                             "  if sensor.simTime == 2: undefined\n"),
                     {}, nullptr);
  thread.Submit(Classic(Aux{}));
  EXPECT_TRUE(std::holds_alternative<InitReply>(AnswerOf(&thread)));
  EXPECT_FALSE(thread.WaitForAnswer(0s).has_value());
  thread.Submit(Classic(Sensor{.sim_time = 1}));
  const BrainAnswer step = AnswerOf(&thread);
  ASSERT_TRUE(std::holds_alternative<StepReply>(step));
  EXPECT_EQ(std::get<StepReply>(step).motors.front().head_velocity, 0.25);
  thread.Submit(Classic(Sensor{.sim_time = 2}));
  const BrainAnswer failure = AnswerOf(&thread);
  ASSERT_TRUE(std::holds_alternative<BrainError>(failure));
  EXPECT_EQ(std::get<BrainError>(failure).line, 3);
  // A forbidden operation on a process is an error, too.
  thread.Submit(Classic(Sensor{}));
  EXPECT_TRUE(std::holds_alternative<BrainError>(AnswerOf(&thread)));
}

TEST_F(BrainThreadTest, StartsWhenTheOneBeforeHasEnded) {
  const std::string mark = (root_ / "first").string();
  // It takes its time to say farewell.
  auto first = std::make_unique<BrainThread>(Program("first.py",
                                                     "import atexit, os, time\n"
                                                     "def init(aux): open('" +
                                                         mark +
                                                         "', 'w')\n"
                                                         "def leave():\n"
                                                         "  time.sleep(0.2)\n"
                                                         "  os.remove('" +
                                                         mark +
                                                         "')\n"
                                                         "atexit.register(leave)\n"
                                                         "def step(sensor, motor, aux): pass\n"),
                                             BrainOptions{}, nullptr);
  first->Submit(Classic(Aux{}));
  EXPECT_TRUE(std::holds_alternative<InitReply>(AnswerOf(first.get())));
  first->Leave();
  EXPECT_THROW(BrainThread(root_ / "nothing", {}, std::move(first)), std::exception);
  ASSERT_NE(first, nullptr);
  BrainThread second(Program("second.py",
                             "import os\n"
                             "def init(aux): assert not os.path.exists('" +
                                 mark +
                                 "')\n"
                                 "def step(sensor, motor, aux): pass\n"),
                     {}, std::move(first));
  second.Submit(Classic(Aux{}));
  const BrainAnswer answer = AnswerOf(&second);
  const auto* error = std::get_if<BrainError>(&answer);
  EXPECT_EQ(error ? ToString(*error) : "", "");
}

TEST_F(BrainThreadTest, LeavesWhileItStartsOrComputes) {
  const fs::path endless = Program("endless.py",
                                   "import time\n"
                                   "def init(aux): time.sleep(1000)\n"
                                   "def step(sensor, motor, aux): pass\n");
  auto starting = std::make_unique<BrainThread>(endless, BrainOptions{}, nullptr);
  starting->Submit(Classic(Aux{}));
  EXPECT_FALSE(starting->WaitForAnswer(300ms).has_value());
  starting->Leave();
  // No thread lived long enough to be asked.
  for (int i = 0; i < 20; ++i) {
    starting = std::make_unique<BrainThread>(endless, BrainOptions{}, std::move(starting));
    starting->Submit(Classic(Aux{}));
    starting->Leave();
  }
}

}  // namespace
}  // namespace smile::brain
