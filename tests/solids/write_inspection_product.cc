// Writes parts/library/inspection/product.step:
//   write_inspection_product PATH

#include <cstdio>
#include <exception>

#include "tests/solids/made_parts.h"
#include "tests/solids/step_text.h"

int main(int count, char** words) {
  if (count != 2) {
    std::fputs("usage: write_inspection_product PATH\n", stderr);
    return 2;
  }
  try {
    g31::testing::write_step(g31::testing::inspection_product(), "product", words[1]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
