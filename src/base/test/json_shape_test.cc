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

TEST(JsonShape, AcceptsMatchingValues) {
  EXPECT_TRUE(Fits(R"({"name":"four","kind":"round","place":[-2,0.5,2]})"));
  EXPECT_TRUE(Fits(R"({"free":false,"tags":["b"],"place":[0,0,0],"kind":"square","name":""})"));
}

TEST(JsonShape, RefusesOtherValues) {
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

TEST(JsonShape, ReportsMismatchesWithTheirLocation) {
  const auto misfit = [](const JsonShape& shape, const char* text) {
    std::string reason;
    EXPECT_FALSE(shape.Fits(ParseJson(text), &reason));
    return reason;
  };
  const JsonShape tables = JsonShape::Map(JsonShape::List(Table()));
  EXPECT_EQ(misfit(tables, R"({"a":[],"b":[{"name":"a","kind":"round","place":[0,0,9]}]})"),
            ".b.0.place.2 is 9");
  EXPECT_EQ(misfit(Table(), R"({"name":"a","kind":"round"})"), ".place is missing");
  EXPECT_EQ(misfit(Table(), R"({"name":"a","kind":"round","place":[0,0,0],"size":1})"),
            ".size is unknown");
}

TEST(JsonShape, MayBeAWholeNumber) {
  const JsonShape shape = JsonShape::Whole(1, std::uint64_t{1} << 53);
  for (const char* text : {"1", "9007199254740992"}) EXPECT_TRUE(shape.Fits(ParseJson(text)));
  for (const char* text : {"0", "-1", "1.5", "1.0", "9007199254740994", "\"1\""}) {
    EXPECT_FALSE(shape.Fits(ParseJson(text))) << text;
  }
  EXPECT_EQ(shape.Schema().at("type"), "integer");
  EXPECT_EQ(shape.TypeScript(), "number");
}

TEST(JsonShape, MayBeNull) {
  const JsonShape shape = JsonShape::Object({{"place", JsonShape::Number().OrNull()}});
  EXPECT_TRUE(shape.Fits(ParseJson(R"({"place":null})")));
  EXPECT_FALSE(JsonShape::Number().Fits(Json()));
  EXPECT_EQ(shape.TypeScript(), "{ place: number | null }");
}

TEST(JsonShape, MayBeOneOfTwo) {
  const JsonShape shape = JsonShape::List(JsonShape::Number(), 2, 2)
                              .Or(JsonShape::Map(JsonShape::Number(), /*max_count=*/2,
                                                 /*max_name=*/4));
  for (const char* text : {"[1,2]", "{}", R"({"left":1,"b":2})"}) {
    EXPECT_TRUE(shape.Fits(ParseJson(text))) << text;
  }
  for (const char* text : {"[1]", R"({"a":1,"b":2,"c":3})", R"({"right":1})", R"({"a":"1"})"}) {
    EXPECT_FALSE(shape.Fits(ParseJson(text))) << text;
  }
  EXPECT_EQ(shape.TypeScript(), "[number, number] | Record<string, number>");
  EXPECT_EQ(shape.Schema()["anyOf"][1]["maxProperties"], 2);
}

TEST(JsonShape, MayBeTrue) {
  const JsonShape shape = JsonShape::Text().OrTrue();
  EXPECT_TRUE(shape.Fits(true));
  EXPECT_TRUE(shape.Fits("a reason"));
  EXPECT_FALSE(shape.Fits(false));
  EXPECT_FALSE(JsonShape::Text().Fits(true));
  EXPECT_EQ(JsonShape::List(shape).TypeScript(), "(string | true)[]");
  EXPECT_EQ(shape.Called("Allowed").OrNull().TypeScriptDefinition(),
            "export type Allowed = string | true;\n");
  EXPECT_EQ(shape.Schema()["anyOf"][1], Json({{"const", true}}));
}

TEST(JsonShape, ReturnsItsSchema) {
  const Json schema = Table().Schema();
  EXPECT_EQ(schema["required"], ParseJson(R"(["name","kind","place"])"));
  EXPECT_EQ(schema["additionalProperties"], false);
  EXPECT_EQ(ToText(schema["properties"]["place"]),
            R"({"type":"array","items":{"type":"number","minimum":-2.0,"maximum":2.0},)"
            R"("minItems":3,"maxItems":3})");
  EXPECT_EQ(ToText(schema["properties"]["kind"]), R"({"enum":["round","square"]})");
}

TEST(JsonShape, ReturnsItsTypeScriptType) {
  EXPECT_EQ(Table().TypeScript(),
            "{ name: string; kind: \"round\" | \"square\"; place: [number, number, number]; "
            "tags?: (\"a\" | \"b\")[]; free?: boolean }");
}

TEST(JsonShape, DefinesTheTypeThatItsNameStandsFor) {
  const JsonShape point = JsonShape::List(JsonShape::Number(), 2, 2).Called("Point");
  const JsonShape line = JsonShape::Object({{"from", point},
                                            {"to", point.OrNull(), true, "null: no end"},
                                            {"via", JsonShape::List(point), false}})
                             .Called("Line");
  EXPECT_EQ(point.TypeScriptDefinition(), "export type Point = [number, number];\n");
  EXPECT_EQ(line.TypeScriptDefinition("It is straight."),
            "/** It is straight. */\nexport interface Line {\n  from: Point;\n"
            "  /** null: no end */\n  to: Point | null;\n  via?: Point[];\n}\n");
}

}  // namespace
}  // namespace smile
