// What the text of a SINUMERIK program tells `explain` about itself.

#include "interpreter/dialects/sinumerik/explain/program_texts.h"

#include <string>
#include <vector>

#include <gtest/gtest.h>

namespace g31::sinumerik::program_texts_test {
namespace {

/// "name|other|kind|entry's name|text|fact=value;..." of each.
std::vector<std::string> rows_of(const std::string& text) {
  std::vector<std::string> rows;
  for (const Topic& topic : topics_of_text(text)) {
    std::string row = topic.name + "|" + topic.other + "|" + topic.entry.kind + "|" +
                      topic.entry.name + "|" + topic.entry.text + "|";
    for (const runtime::Fact& fact : topic.entry.facts) {
      row += fact.name + "=" + fact.value + ";";
    }
    rows.push_back(row);
  }
  return rows;
}

TEST(ProgramTexts, TellWhatPlacesSay) {
  struct Case {
    const char* what;
    const char* text;
    std::vector<std::string> rows;
  };
  const Case kCases[] = {
      {"nothing", "", {}},
      {"the comment above PROC, over two lines",
       "%_N_HOLE_SPF\n; Measures\n; a hole.\nPROC HOLE(REAL DD=5,STRING[8] NAME) SAVE "
       "DISPLOF\nRET\n",
       {"HOLE||program|HOLE|Measures a hole.|form=HOLE(REAL DD=5,STRING[8] NAME);"}},
      {"PROC without parameters, without a comment",
       "; far above\nG17\nPROC hole SAVE\n",
       {"HOLE||program|HOLE||form=hole;"}},
      {"DEF with elements; the comment of another line does not count",
       "; First.\nDEF CHAN INT AA\n; Second.\n; [0] zero\n; [12] twelve\nDEF NCK REAL _BB[20]\nM17",
       {"AA||global variable|AA|First.|type=INT;",
        "_BB||global variable|_BB[20]|Second.|type=REAL;[0]=zero;[12]=twelve;"}},
      {"several names, with sizes and values",
       "DEF CHAN STRING[9] AA[2,3], BB=SET(\"x,y\",1), CC[2]=REP(\"=,\")\r\n",
       {"AA||global variable|AA[2,3]||type=STRING[9];", "BB||global variable|BB||type=STRING[9];",
        "CC||global variable|CC[2]||type=STRING[9];"}},
      {"DEFINE", "; Off.\nDEFINE _OFF AS 0\n", {"_OFF||macro|_OFF|Off.|stands for=0;"}},
      {"SETAL with its text; what follows a colon is about the place",
       "  SETAL(61002,\"Type wrong: _GMODE\") ; 1 or 2\nSETAL(65000)\n",
       {"ALARM 61002|61002|alarm|61002 Type wrong|1 or 2|"}},
      {"texts behind the labels of CASE",
       "CASE NR OF 61301 GOTOF A301 61302 GOTOF A302 DEFAULT GOTOF OUT\nA301: TEXT=\"one\" ; do\n"
       "A302: TEXT=\"two; half\"\nA303: TEXT=\"three\"\nOUT: SETAL(NR,TEXT)\n",
       {"ALARM 61301|61301|alarm|61301 one|do|", "ALARM 61302|61302|alarm|61302 two; half||"}},
      {"labels of CASE that are no alarms",
       "CASE KIND OF 1 GOTOF ONE 976 GOTOF BALL DEFAULT GOTOF OUT\nONE: TEXT=\"=\"\n"
       "BALL: TEXT=\"Ball diameter\"\n",
       {}},
      {"broken texts", "PROC\nDEF\nDEF CHAN\nDEFINE\nCASE\nSETAL(\n;\n\"\n; [\nDEF REAL ,,\n", {}},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.what);
    EXPECT_EQ(rows_of(c.text), c.rows);
  }
}

}  // namespace
}  // namespace g31::sinumerik::program_texts_test
