// What the interpreter does not mind and a control's program memory does: the shipped programs keep
// to the characters of the ISO code, to short blocks and to the number in their file's name.

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace g31::macro_texts_test {
namespace {

TEST(MacroTexts, KeepToWhatAControlStores) {
  const std::string allowed = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789 %()[]#=+-*/.,&_";
  int programs = 0;
  for (const auto& entry : std::filesystem::directory_iterator("macros/fanuc")) {
    const std::string name = entry.path().stem().string();
    SCOPED_TRACE(name);
    ++programs;
    std::ifstream file(entry.path());
    std::string line;
    for (int number = 1; std::getline(file, line); ++number) {
      EXPECT_EQ(line.find_first_not_of(allowed), std::string::npos) << number << ": " << line;
      EXPECT_LE(line.size(), 80U) << number << ": " << line;
      if (number == 1) {
        EXPECT_EQ(line, "%");
      }
      if (number == 2) {
        EXPECT_EQ(line.substr(0, line.find(' ')), name);
      }
    }
  }
  EXPECT_EQ(programs, 21);
}

}  // namespace
}  // namespace g31::macro_texts_test
