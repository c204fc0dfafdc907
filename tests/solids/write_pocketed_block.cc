// Writes a block with pockets and holes in rows, for measurements of speed:
//   write_pocketed_block COLUMNS ROWS PATH

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <vector>

#include "tests/solids/made_parts.h"
#include "tests/solids/step_text.h"

int main(int count, char** words) {
  if (count != 4) {
    std::fputs("usage: write_pocketed_block COLUMNS ROWS PATH\n", stderr);
    return 2;
  }
  constexpr double kCell = 40.0;
  const int columns = std::atoi(words[1]);
  const int rows = std::atoi(words[2]);
  try {
    std::vector<TopoDS_Shape> cuts;
    for (int i = 0; i < columns * rows; ++i) {
      const double x = kCell * (i % columns);
      const double y = kCell * (i / columns);
      const double depth = 8.0 + i % 7;
      if (i % 3 == 0) {
        cuts.push_back(g31::testing::pin({x + 20.0, y + 20.0, -depth}, 16.0 + i % 5, depth));
      } else {
        cuts.push_back(
            g31::testing::block({{x + 8.0, y + 10.0, -depth}, {x + 32.0, y + 30.0, 0.0}}));
      }
    }
    const TopoDS_Shape stock =
        g31::testing::block({{0.0, 0.0, -30.0}, {kCell * columns, kCell * rows, 0.0}});
    g31::testing::write_step(g31::testing::cut(stock, cuts), "block", words[3]);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
