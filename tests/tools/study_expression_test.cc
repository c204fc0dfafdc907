#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tools/study/expression.h"

namespace g31::study::study_expression_test {
namespace {

TEST(StudyExpression, ComputesAsPeopleRead) {
  // #1 is 6, #2 is 4.
  struct Case {
    const char* text;
    double value;
  };
  const Case kCases[] = {
      {"#1", 6.0},           {" #1 - #2 ", 2.0},
      {"#1-#2-1", 1.0},      {"2+3*#2", 14.0},
      {"#1/#2/2", 0.75},     {"-#1+#2", -2.0},
      {"-(#1+#2)*2", -20.0}, {"[#1+#2]/2", 5.0},
      {"2*-#1", -12.0},      {"SQRT[#1*#1 + #2*#2]", std::sqrt(52.0)},
      {"ABS(#2-#1)", 2.0},   {"MIN(#1, #2) + MAX[#1, #2]*10", 64.0},
      {"1.5e1", 15.0},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.text);
    const auto parsed = Expression::parse(c.text);
    ASSERT_TRUE(parsed) << parsed.error();
    std::vector<std::optional<double>> values;
    for (const std::string& name : parsed.value().variables()) {
      values.emplace_back(name == "#1" ? 6.0 : 4.0);
    }
    EXPECT_EQ(parsed.value().value(values), c.value);
  }
}

TEST(StudyExpression, ReadsVariablesWithNames) {
  struct Case {
    const char* text;
    std::vector<std::string> variables;
  };
  const Case kCases[] = {
      {"_OVR[4]", {"_OVR[4]"}},
      {"_OVR[04] - R010", {"_OVR[4]", "R10"}},
      {"(_OVR[4] + _OVR[5])/2 + _OVR[4]", {"_OVR[4]", "_OVR[5]"}},
      {"SQRT[R1*R1 + R2*R2]", {"R1", "R2"}},
      {"$P_UIFR[1,X,TR]*[R1 - 2]", {"$P_UIFR[1,X,TR]", "R1"}},
      {"MY_GUD", {"MY_GUD"}},
      {"TABLE[1,2]", {"TABLE[1,2]"}},
      {"MIN(SQRTS, #5)", {"SQRTS", "#5"}},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.text);
    const auto parsed = Expression::parse(c.text);
    ASSERT_TRUE(parsed) << parsed.error();
    EXPECT_EQ(parsed.value().variables(), c.variables);
  }
  const auto difference = Expression::parse("_OVR[4] - R10*2");
  ASSERT_TRUE(difference);
  EXPECT_EQ(difference.value().value({20.5, 10.0}), 0.5);
}

TEST(StudyExpression, HasNoValueWhereThereIsNone) {
  for (const char* const text : {"#1", "1/0", "0/0", "SQRT[-1]", "1e308*10", "2+#1"}) {
    SCOPED_TRACE(text);
    const auto parsed = Expression::parse(text);
    ASSERT_TRUE(parsed) << parsed.error();
    const std::vector<std::optional<double>> vacant(parsed.value().variables().size());
    EXPECT_EQ(parsed.value().value(vacant), std::nullopt);
  }
}

TEST(StudyExpression, SaysWhereItIsWrong) {
  struct Case {
    const char* text;
    const char* message;
  };
  const Case kCases[] = {
      {"", "at character 1: a variable, a number or a bracket is expected"},
      {"#", "at character 2: a variable is # and a number"},
      {"#1 +", "at character 5: a variable, a number or a bracket is expected"},
      {"(#1 + 2", "at character 8: ')' is missing"},
      {"[#1)", "at character 4: ']' is missing"},
      {"#1 2", "at character 4: '2' does not belong here"},
      {"SQRTT[#1]", "at character 1: there is no function SQRTT, did you mean SQRT?"},
      {"COSINE(1)", "at character 1: there is no function COSINE, known are ABS, SQRT, MIN, MAX"},
      {"ABS #1", "at character 5: a function needs a bracket"},
      {"MIN[#1]", "at character 7: 2 values separated by commas are expected"},
      {"_OVR[", "at character 1: there is no function _OVR, known are ABS, SQRT, MIN, MAX"},
      {"R1[R2+1]", "at character 1: there is no function R1, known are ABS, SQRT, MIN, MAX"},
      {"1e999", "at character 1: a variable, a number or a bracket is expected"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.text);
    const auto parsed = Expression::parse(c.text);
    ASSERT_FALSE(parsed);
    EXPECT_EQ(parsed.error(), c.message);
  }
  EXPECT_FALSE(Expression::parse(std::string(100000, '(')));
  EXPECT_FALSE(Expression::parse(std::string(100000, '-')));
}

}  // namespace
}  // namespace g31::study::study_expression_test
