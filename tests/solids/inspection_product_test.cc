// parts/library/inspection/product.step is what write_inspection_product writes.

#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "tests/solids/made_parts.h"
#include "tests/solids/step_text.h"
#include "tests/support/temporary_folder.h"

namespace g31::inspection_product_test {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(InspectionProduct, IsWhatItsWriterWrites) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path("product.step");
  testing::write_step(testing::inspection_product(), "product", path);
  const std::string text = text_of(path);
  EXPECT_NE(text.find("MANIFOLD_SOLID_BREP"), std::string::npos);
  EXPECT_TRUE(text == text_of("parts/library/inspection/product.step"));
  // Nor does what was written before change it.
  testing::write_step(testing::inspection_product(), "product", path);
  EXPECT_TRUE(text_of(path) == text);
}

}  // namespace
}  // namespace g31::inspection_product_test
