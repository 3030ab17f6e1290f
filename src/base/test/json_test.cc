#include "base/json.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace smile {
namespace {

std::string Repeated(const std::string& text, int count) {
  std::string repeated;
  for (int i = 0; i < count; ++i) repeated += text;
  return repeated;
}

std::string FaultOf(const std::string& text, int max_keys = kMaxJsonKeys) {
  try {
    ParseJson(text, max_keys);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return {};
}

TEST(Json, IsBoundedInDepthAndKeys) {
  EXPECT_EQ(FaultOf(Repeated("[", 32) + "1" + Repeated("]", 32)), "");
  EXPECT_EQ(FaultOf(Repeated("[", 33) + Repeated("]", 33)),
            "this JSON is nested deeper than 32 levels");
  EXPECT_EQ(FaultOf(Repeated("[", 1'000'000)), "this JSON is nested deeper than 32 levels");
  EXPECT_EQ(FaultOf("[{}" + Repeated(",{\"a\":1}", 10'000) + "]"), "");
  EXPECT_EQ(FaultOf("[{}" + Repeated(",{\"a\":1}", 10'001) + "]"),
            "this JSON has more than 10000 keys");
  EXPECT_NO_THROW(ParseJson("[{}" + Repeated(",{\"a\":1}", 10'001) + "]", 20'000));
  std::string many = "{\"0\":1";
  for (int i = 1; i <= 10'000; ++i) many += ",\"" + std::to_string(i) + "\":1";
  EXPECT_EQ(FaultOf(many + "}", 20'000), "this JSON has more than 10000 keys") << "in one object";
}

TEST(Json, HasNoKeyTwiceInOneObject) {
  EXPECT_EQ(FaultOf(R"({"a":{"a":1},"b":[{"a":1},{"a":1}]})"), "");
  EXPECT_EQ(FaultOf(R"({"a":1,"b":2,"a":1})"), "the key \"a\" appears twice");
  EXPECT_EQ(FaultOf(R"({"a":1,"\u0061":2})"), "the key \"a\" appears twice");
  EXPECT_EQ(FaultOf(R"({"x":0,"arms":[0,{"left":{},"tool":1,"left":{}}]})"),
            "the key \"left\" appears twice in \"arms\"");
}

TEST(Json, TakesTimeInProportionToItsLength) {
  EXPECT_EQ(ParseJson("[1" + Repeated(",{}", 1'000'000) + "]").size(), 1'000'001u);
}

TEST(Json, RefusesWhatIsNone) {
  for (const char* text : {"", "[1,]", "{\"a\":1", "1e999", "\"\xFF\"", "[] []", "[NaN]"}) {
    EXPECT_EQ(FaultOf(text), "this is not JSON") << text;
  }
  EXPECT_EQ(FaultOf("{\"a\": 1,\n\n\"b\" 2}\n"), "this is not JSON from line 3 on");
}

}  // namespace
}  // namespace smile
