#include <gtest/gtest.h>

#include <map>

#include "scene_xml/internal_expression.h"

namespace smile::scene_xml {
namespace {

class FixedVariables : public Variables {
 public:
  Binding Find(std::string_view name) override {
    const auto found = values_.find(name);
    return found == values_.end() ? Binding{} : Binding{.value = &found->second};
  }
  std::vector<std::string_view> SomeNames() const override {
    std::vector<std::string_view> names;
    for (const auto& [name, value] : values_) names.push_back(name);
    return names;
  }

 private:
  std::map<std::string, std::string, std::less<>> values_{
      {"a", "2"},           {"b", "0.5"},        {"s", "red"},   {"n", "-3"},
      {"z", "0"},           {"id", "007"},       {"f", "0.1"},   {"empty", ""},
      {"loc", "(1, 2, 3)"}, {"big", "12345678"}, {"width", "4"}, {"cash", "5$"}};
};

Substitution Evaluated(std::string_view text) {
  FixedVariables variables;
  return Substitute(text, 1'000, &variables);
}

std::string ValueOf(std::string_view text) {
  const Substitution result = Evaluated(text);
  EXPECT_FALSE(result.has_fault) << text << " " << result.fault;
  return result.text;
}

std::string FaultIn(std::string_view text) {
  const Substitution result = Evaluated(text);
  EXPECT_TRUE(result.has_fault) << text << " gives " << result.text;
  EXPECT_EQ(result.text, text);
  return result.fault;
}

TEST(Expression, GivesTheResultsOfTheOriginal) {
  EXPECT_EQ(ValueOf("$a+b$"), "2.5");
  EXPECT_EQ(ValueOf("$a + b * 3$"), "3.5");
  EXPECT_EQ(ValueOf("$(a+b)*3$"), "7.5");
  EXPECT_EQ(ValueOf("$a*-b$"), "-1");
  EXPECT_EQ(ValueOf("$a - -b$"), "2.5");
  EXPECT_EQ(ValueOf("$-(a+b)$"), "-2.5");
  EXPECT_EQ(ValueOf("$n*n$"), "9");
  EXPECT_EQ(ValueOf("$a/z$"), "Infinity");
  EXPECT_EQ(ValueOf("$empty$"), "");
  EXPECT_EQ(ValueOf("$s$x$a$"), "redx2");
  EXPECT_EQ(ValueOf("$a$$b$"), "20.5");
  EXPECT_EQ(ValueOf("$1/3$"), "0.33333334");
  EXPECT_EQ(ValueOf("$1/3*3$"), "1");
  EXPECT_EQ(ValueOf("$.5*a$"), "1");
  EXPECT_EQ(ValueOf("$1e3$"), "1000");
  EXPECT_EQ(ValueOf("cost $5"), "cost $5");
}

TEST(Expression, KeepsTheTextOfASingleName) {
  EXPECT_EQ(ValueOf("$id$"), "007");
  EXPECT_EQ(ValueOf("$ id $"), "007");
  EXPECT_EQ(ValueOf("$id+0$"), "7");
  EXPECT_EQ(ValueOf("$(id)$"), "7");
  EXPECT_EQ(ValueOf("at $loc$!"), "at (1, 2, 3)!");
}

TEST(Expression, BindsASignTighterThanAProduct) {
  EXPECT_EQ(ValueOf("$-a/2$"), "-1");
  EXPECT_EQ(ValueOf("$2*-3+ +1$"), "-5");
  EXPECT_EQ(ValueOf("$7-2-1$"), "4");
  EXPECT_EQ(ValueOf("$8/2/2$"), "2");
  EXPECT_EQ(ValueOf("$-z$"), "0");
}

TEST(Expression, ReadsEveryWayToWriteANumber) {
  EXPECT_EQ(ValueOf("$5.+.5$"), "5.5");
  EXPECT_EQ(ValueOf("$1e-3*1$"), "0.001");
  EXPECT_EQ(ValueOf("$1E+2$"), "100");
  EXPECT_EQ(ValueOf("$2.5e-1-1$"), "-0.75");
  EXPECT_EQ(ValueOf("$2d+1f$"), "3");
  EXPECT_EQ(ValueOf("$-Infinity$"), "-Infinity");
  EXPECT_EQ(ValueOf("$z/z$"), "NaN");
  EXPECT_EQ(ValueOf("$1e50$"), "Infinity");
  EXPECT_EQ(ValueOf("$1e-50$"), "0");
}

TEST(Expression, CalculatesInSinglePrecision) {
  EXPECT_EQ(ValueOf("$big*10$"), "123456784");
  EXPECT_EQ(ValueOf("$big*1000$"), "1.23456778E10");
  EXPECT_EQ(ValueOf("$f+0.2$"), "0.3");
  EXPECT_EQ(ValueOf("$f*3$"), "0.3");
  EXPECT_EQ(ValueOf("$16777216+1$"), "16777216");
}

TEST(SinglePrecisionText, WritesAsJavaDoes) {
  EXPECT_EQ(SinglePrecisionText(1e-4f), "1.0E-4");
  EXPECT_EQ(SinglePrecisionText(1.5e-4f), "1.5E-4");
  EXPECT_EQ(SinglePrecisionText(0.0125f), "0.0125");
  EXPECT_EQ(SinglePrecisionText(-1234.5f), "-1234.5");
  EXPECT_EQ(SinglePrecisionText(1.0000005f), "1");
  EXPECT_EQ(SinglePrecisionText(-0.0f), "0");
  EXPECT_EQ(SinglePrecisionText(2147483648.0f), "2.14748365E9");
  EXPECT_EQ(SinglePrecisionText(1e10f), "1.0E10");
  EXPECT_EQ(SinglePrecisionText(-3e38f), "-3.0E38");
}

TEST(Expression, TakesOnlyPairsOnOneLine) {
  EXPECT_FALSE(HoldsExpression("$"));
  EXPECT_FALSE(HoldsExpression("$5\n6$"));
  EXPECT_TRUE(HoldsExpression("$5\n$6$"));
  EXPECT_EQ(ValueOf("$5\n$a$"), "$5\n2");
}

TEST(Expression, ReportsSyntaxErrors) {
  EXPECT_EQ(FaultIn("$widht/2$"),
            "with the unknown variable \"widht\", expected one of the instance, of its def or of "
            "an instance around it; did you mean \"width\"?");
  EXPECT_EQ(FaultIn("$a b$"), "with \"b\" after a value, expected an operator + - * /");
  EXPECT_EQ(FaultIn("$a)$"), "with \")\" after a value, expected an operator + - * /");
  EXPECT_EQ(FaultIn("$a%b$"), "with \"%b\" after a value, expected an operator + - * /");
  EXPECT_EQ(FaultIn("$- a$"), "with \" a\", expected a number, a variable or (");
  EXPECT_EQ(FaultIn("$a*$"), "with the end, expected a number, a variable or (");
  EXPECT_EQ(FaultIn("$$"), "with the end, expected a number, a variable or (");
  EXPECT_EQ(FaultIn("$(a+b$"), "with the end, expected an operator + - * / or )");
  EXPECT_EQ(FaultIn("$s*2$"), "with s=\"red\" in arithmetic, expected a number");
  EXPECT_EQ(FaultIn("$empty+1$"), "with empty=\"\" in arithmetic, expected a number");
}

TEST(Expression, RefusesAValueThatWouldMakeAnother) {
  EXPECT_EQ(ValueOf("$cash$"), "5$");
  EXPECT_EQ(FaultIn("$cash$ and $cash$"),
            "with $ in the value of a variable, expected no nested expression");
}

TEST(Expression, BoundsWhatItDoes) {
  EXPECT_EQ(ValueOf("$" + std::string(64, '(') + "1" + std::string(64, ')') + "$"), "1");
  EXPECT_EQ(FaultIn("$" + std::string(100'000, '(') + "$"),
            "with more than 64 parentheses inside one another, expected fewer");
  std::string text;
  for (int i = 0; i < 500; ++i) text += "$loc$";
  EXPECT_EQ(FaultIn(text), "with a text that exceeds the limits of a scene, expected less");
}

}  // namespace
}  // namespace smile::scene_xml
