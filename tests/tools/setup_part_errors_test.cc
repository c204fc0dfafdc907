#include <gtest/gtest.h>

#include "tests/tools/setup_error_text.h"

namespace g31::setup::setup_part_errors_test {
namespace {

const ErrorCase kOfFilesOfParts[] = {
    {"a shape with a unit", "[[part]]\nshape = \"ring\"\nunit = \"inch\"\nclosed = false\n",
     R"(sheet1.toml:3:8: error: part.unit is for a part from a file, not for a shape [SET124]
    3 | unit = "inch"
      |        ^
      = leave it out
sheet1.toml:4:10: error: part.closed is for a part from a file, not for a shape [SET124]
    4 | closed = false
      |          ^
      = leave it out
)"},
    {"an unknown unit", "[[part]]\nfile = \"ring.stl\"\nunit = \"in\"\n",
     R"(sheet1.toml:3:8: error: part.unit is "in", it should be "um", "mm", "cm", "m", "inch" or "foot" [SET105]
    3 | unit = "in"
      |        ^
)"},
    {"behind characters of two cells",
     "part = [{name = \"測定\", file = \"ring.stl\", unit = \"in\"}]\n",
     R"(sheet1.toml:1:49: error: part.unit is "in", it should be "um", "mm", "cm", "m", "inch" or "foot" [SET105]
    1 | part = [{name = "測定", file = "ring.stl", unit = "in"}]
      |                                                   ^
)"},
};

TEST_F(SetupErrorText, OfFilesOfParts) {
  for (const ErrorCase& c : kOfFilesOfParts) {
    expect_text(c);
  }
}

TEST_F(SetupErrorText, OfAPartFileThatIsAFolder) {
  std::filesystem::create_directory(path_of("meshes"));
  expect_text({"a folder", "[[part]]\nfile = \"meshes\"\n",
               R"(sheet1.toml:2:8: error: there is no file meshes [SET107]
    2 | file = "meshes"
      |        ^
      = this is a folder: name a mesh or STEP file in it
)"});
}

}  // namespace
}  // namespace g31::setup::setup_part_errors_test
