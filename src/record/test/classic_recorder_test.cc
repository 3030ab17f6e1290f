#include "record/classic_recorder.h"

#include <cstdio>

#include "painted_eye.h"
#include "record/classic_text.h"
#include "record/png.h"
#include "recording_fixture.h"

namespace smile::record {
namespace {

class ClassicRecorderTest : public RecordingFixture {};

TEST_F(ClassicRecorderTest, SegmentZeroDescribesTheSceneInItsOrder) {
  const auto demo = Record();
  const auto lines = Lines(demo / "0.txt");
  ASSERT_GE(lines.size(), 4u);
  EXPECT_EQ(lines[0], "0,create,a,shape,block,color,red");
  EXPECT_EQ(lines[1], "0,create,b,shape,block,label,tall\\, blue");
  EXPECT_EQ(lines[2], "0,move,a,0.0,-2.0,0.5,0.0,-0.0,0.0");
  EXPECT_EQ(lines[3], "0,move,b,3.0,-2.0,0.5,0.0,-0.0,30.0");
}

TEST_F(ClassicRecorderTest, EveryActionOpensASegmentWithItselfAsFirstLine) {
  const auto demo = Record();
  EXPECT_EQ(Lines(demo / "1.txt")[0].substr(2), "grasp,LeftHand,a");
  EXPECT_NE(Lines(demo / "2.txt")[0].find(",release,LeftHand"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(demo / "3.txt"));
  // The release segment ends with the exact pose of rest.
  std::string last;
  for (const std::string& line : Lines(demo / "2.txt")) {
    if (line.find(",move,a,") != std::string::npos) last = line;
  }
  double x = 0, y = 0, z = 0;
  ASSERT_EQ(std::sscanf(last.c_str(), "%*d,move,a,%lf,%lf,%lf", &x, &y, &z), 3) << last;
  EXPECT_LT((Vector3(x, y, z) - Vector3(3, -2, 1.5)).norm(), 0.01);
}

TEST_F(ClassicRecorderTest, OnlyFramesInWhichSomethingMovedHaveAPicture) {
  PaintedEye eye;
  const auto demo = Record(kStackAOnB, false, &eye);
  const auto index = Lines(demo / "frames.csv");
  EXPECT_EQ(index[0], "frame,tick,image");
  int pictures = 0;
  for (std::size_t i = 1; i < index.size(); ++i) {
    const std::string frame = std::to_string(i - 1);
    EXPECT_EQ(index[i].substr(0, frame.size() + 1), frame + ",");
    EXPECT_NE(index[i].find("," + std::to_string((i - 1) * 15) + ","), std::string::npos);
    const std::string image = index[i].substr(index[i].rfind(',') + 1);
    if (image.empty()) continue;
    ++pictures;
    EXPECT_EQ(ReadPng(demo / image).color[0], pictures) << image;
  }
  EXPECT_EQ(pictures, eye.looks());
  EXPECT_GT(pictures, 4);
  EXPECT_LT(pictures, static_cast<int>(index.size()) - 4);
}

TEST_F(ClassicRecorderTest, WhatMovedAndCameToRestBetweenTwoFramesHasALine) {
  // Frames every 4 s: it sleeps at 4 s, goes a unit to the left, and sleeps again at 8 s.
  const auto demo = Record(R"({"do":"wait","seconds":4.2}
{"hand":"left","do":"grasp","object":"a"}
{"hand":"left","do":"move_to","position":[-1,-2,0.5]}
{"do":"wait","until":"arrived"}
{"hand":"left","do":"release"}
{"do":"wait","seconds":5})",
                           false, nullptr, kScene, {.frames_per_second = 0.25});
  const std::string text = ReadFile(demo / "2.txt", 1 << 20);
  EXPECT_NE(text.find(",move,a,"), std::string::npos) << text;
}

TEST(ClassicNumber, IsTheOriginalsShortestSinglePrecision) {
  EXPECT_EQ(ClassicNumber(2), "2.0");
  EXPECT_EQ(ClassicNumber(-0.0), "-0.0");
  EXPECT_EQ(ClassicNumber(0.50038415), "0.50038415");
  EXPECT_EQ(ClassicNumber(3.4144908e-4), "3.4144908E-4");
  EXPECT_EQ(ClassicNumber(1e7), "1.0E7");
  EXPECT_EQ(ClassicNumber(1234567), "1234567.0");
  EXPECT_EQ(ClassicNumber(0.001), "0.001");
}

}  // namespace
}  // namespace smile::record
