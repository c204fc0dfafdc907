// DPRNT and BPRNT byte for byte; the numbers are those of the control manuals' examples as far as
// the Macro B semantics (MB-239 to MB-248) quote them.

#include "interpreter/dialects/fanuc/text/output_format.h"

#include <gtest/gtest.h>

namespace g31::fanuc::output_format_test {
namespace {

TEST(DecimalText, FillsItsPlaces) {
  struct Case {
    const char* name;
    double value;
    int places, decimals;
    const char* blanks;   ///< 6001.1 = 0
    const char* omitted;  ///< 6001.1 = 1
  };
  const Case kCases[] = {
      {"the manual's positive number", 128.47398, 5, 3, "   128.474", "128.474"},
      {"the manual's negative number", -91.2, 5, 3, "-   91.200", "-91.200"},
      {"sign before the blanks", -123.456, 4, 4, "- 123.4560", "-123.4560"},
      {"digits above the field are dropped", 123.456, 2, 2, " 23.46", "23.46"},
      {"no decimals, no point", 123.456, 2, 0, " 23", "23"},
      {"a zero integer part prints one 0", 0.056, 2, 0, "  0", "0"},
      {"no integer places: nothing before the point", -0.456, 0, 2, "-.46", "-.46"},
      {"halves away from zero", 2.5, 1, 0, " 3", "3"},
      {"a half that its double misses", 1.2345, 1, 3, " 1.235", "1.235"},
      {"a value that rounds to 0 keeps its sign", -0.0004, 1, 3, "-0.000", "-0.000"},
      {"rounding carries into the integer part", 9.9996, 2, 3, " 10.000", "10.000"},
      {"what is left of a cut number has no leading zeros", 12005.0, 3, 0, "   5", "5"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    OutputStyle style;
    EXPECT_EQ(decimal_text(c.value, c.places, c.decimals, style), c.blanks);
    style.leading_zeros = OutputStyle::LeadingZeros::Omit;
    EXPECT_EQ(decimal_text(c.value, c.places, c.decimals, style), c.omitted);
  }
}

TEST(DecimalText, WidensWhereTheControlDoes) {
  OutputStyle style;
  style.overflow = OutputStyle::Overflow::Widen;
  style.plus_sign = OutputStyle::PlusSign::Omit;
  EXPECT_EQ(decimal_text(123.456, 1, 2, style), "123.46");
  EXPECT_EQ(decimal_text(1.5436, 4, 4, style), "   1.5436");
}

TEST(BinaryText, IsFourBytesHighestFirst) {
  using namespace std::string_literals;
  EXPECT_EQ(binary_text(0.40596, 3), "\x00\x00\x01\x96"s);
  EXPECT_EQ(binary_text(-1638.4, 3), "\xFF\xE7\x00\x00"s);
  EXPECT_EQ(binary_text(258.647673, 3), "\x00\x03\xF2\x58"s);
  EXPECT_EQ(binary_text(2147483.648, 3), std::nullopt);
  EXPECT_EQ(binary_text(-2147483.648, 3), "\x80\x00\x00\x00"s);
}

TEST(OutputFormat, TakesTextAndVariables) {
  const auto items = parse_output_format("X #100[53]*Y*#1[2]END");
  ASSERT_TRUE(items.ok());
  ASSERT_EQ(items.value().size(), 5U);
  EXPECT_EQ(items.value()[0].text, "X");
  EXPECT_EQ(items.value()[1].variable, 100);
  EXPECT_EQ(items.value()[1].integer_places, 5);
  EXPECT_EQ(items.value()[1].decimals, 3);
  EXPECT_EQ(items.value()[2].text, " Y ");
  EXPECT_EQ(items.value()[3].integer_places, 0);
  EXPECT_EQ(items.value()[3].decimals, 2);
  EXPECT_EQ(items.value()[4].text, "END");
}

TEST(OutputFormat, RefusesWhatIsNone) {
  for (const char* format :
       {"#[#1][53]", "#1", "#1[]", "#1[5.3]", "#1[123]", "#1[53", "#x[1]", "[A]"}) {
    EXPECT_FALSE(parse_output_format(format).ok()) << format;
  }
}

}  // namespace
}  // namespace g31::fanuc::output_format_test
