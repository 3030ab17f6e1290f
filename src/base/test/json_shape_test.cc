#include "base/json_shape.h"

#include <gtest/gtest.h>

namespace smile {
namespace {

JsonShape Table() {
  return JsonShape::Object(
      {{"name", JsonShape::Text(4)},
       {"kind", JsonShape::Word({"round", "square"})},
       {"place", JsonShape::List(JsonShape::Number(-2, 2), 3, 3)},
       {"tags", JsonShape::List(JsonShape::Word({"a", "b"}), 1, 9), /*is_required=*/false},
       {"free", JsonShape::Flag(), /*is_required=*/false}});
}

bool Fits(const char* text) { return Table().Fits(ParseJson(text)); }

TEST(JsonShape, FitsWhatIsAsItTells) {
  EXPECT_TRUE(Fits(R"({"name":"four","kind":"round","place":[-2,0.5,2]})"));
  EXPECT_TRUE(Fits(R"({"free":false,"tags":["b"],"place":[0,0,0],"kind":"square","name":""})"));
}

TEST(JsonShape, FitsNothingElse) {
  EXPECT_FALSE(Fits(R"({"kind":"round","place":[0,0,0]})")) << "no name";
  EXPECT_FALSE(Fits(R"({"name":"a","kind":"round","place":[0,0,0],"size":1})")) << "unknown";
  EXPECT_FALSE(Fits(R"({"name":"fours","kind":"round","place":[0,0,0]})")) << "too long";
  EXPECT_FALSE(Fits(R"({"name":1,"kind":"round","place":[0,0,0]})"));
  EXPECT_FALSE(Fits(R"({"name":"a","kind":"oval","place":[0,0,0]})"));
  EXPECT_FALSE(Fits(R"({"name":"a","kind":"round","place":[0,0]})"));
  EXPECT_FALSE(Fits(R"({"name":"a","kind":"round","place":[0,0,2.1]})"));
  EXPECT_FALSE(Fits(R"({"name":"a","kind":"round","place":[0,0,true]})"));
  EXPECT_FALSE(Fits(R"({"name":"a","kind":"round","place":[0,0,0],"tags":[]})"));
  EXPECT_FALSE(Fits(R"({"name":"a","kind":"round","place":[0,0,0],"free":0})"));
  EXPECT_FALSE(Fits(R"(["name"])"));
}

TEST(JsonShape, TellsItsSchema) {
  const Json schema = Table().Schema();
  EXPECT_EQ(schema["required"], ParseJson(R"(["name","kind","place"])"));
  EXPECT_EQ(schema["additionalProperties"], false);
  EXPECT_EQ(ToText(schema["properties"]["place"]),
            R"({"type":"array","items":{"type":"number","minimum":-2.0,"maximum":2.0},)"
            R"("minItems":3,"maxItems":3})");
  EXPECT_EQ(ToText(schema["properties"]["kind"]), R"({"enum":["round","square"]})");
}

TEST(JsonShape, TellsItsTypeScriptType) {
  EXPECT_EQ(Table().TypeScript(),
            "{ name: string; kind: \"round\" | \"square\"; place: [number, number, number]; "
            "tags?: (\"a\" | \"b\")[]; free?: boolean }");
}

}  // namespace
}  // namespace smile
