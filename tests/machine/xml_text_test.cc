#include "machine/base/xml_text.h"

#include <gtest/gtest.h>

namespace g31::xml_text_test {
namespace {

/// XML 1.0, 2.2: what is no Char is no part of a document, not even as a reference.
TEST(XmlText, HasNothingThatXmlHasNot) {
  EXPECT_EQ(xml_escaped("a<b>&\"c\""), "a&lt;b&gt;&amp;&quot;c&quot;");
  EXPECT_EQ(xml_escaped(std::string_view("\x01"
                                         "\0"
                                         "X\n",
                                         4)),
            "??X?");
  EXPECT_EQ(xml_escaped("\xEF\xBF\xBE-\xEF\xBF\xBF-\xEF\xBF\xBD"), "?-?-\xEF\xBF\xBD");
  EXPECT_EQ(xml_escaped("\xE3\x83\x90 \xF0\x9F\x98\x80"), "\xE3\x83\x90 \xF0\x9F\x98\x80");
}

}  // namespace
}  // namespace g31::xml_text_test
