// Comments that allow a message, in a program that is looked at piece by piece.

#include <cstddef>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/control_run.h"
#include "tools/session/heard.h"

namespace g31::program_comments_test {
namespace {

constexpr const char* kComment = "(g31: allow PRB301 no part there)\n";

/// Blocks of so many bytes, then the comment.
std::string program_with(std::size_t before) {
  std::string text = "O1\n";
  while (text.size() + 8 <= before) {
    text += "G4 P10\n";
  }
  return text + std::string(before - text.size() - 1, ' ') + "\n" + kComment + "G31 X1 F100\n";
}

TEST(ProgramComments, AreFoundWhereverAPieceEnds) {
  const session::Control control = session::control_named("fanuc-30i").value();
  constexpr std::size_t kPiece = 1U << 16;
  for (std::size_t behind = 0; behind < 12; ++behind) {
    const std::string text = program_with(kPiece - behind);
    testing::FilesInMemory files({{"a.nc", text}});
    session::ProgramComments comments(files, control);
    const auto& found = comments.of("a.nc");
    ASSERT_EQ(found.size(), 1U) << behind;
    EXPECT_EQ(found[0].code, "PRB301");
    EXPECT_EQ(found[0].begin, text.find('('));
  }
}

TEST(ProgramComments, OfAFileThatIsNotThereAreNone) {
  const session::Control control = session::control_named("fanuc-30i").value();
  testing::FilesInMemory files({{"a.nc", std::string("O1\n(g31: nothing)\nM30\n")}});
  session::ProgramComments comments(files, control);
  EXPECT_TRUE(comments.of("a.nc").empty());
  EXPECT_TRUE(comments.of("b.nc").empty());
}

}  // namespace
}  // namespace g31::program_comments_test
