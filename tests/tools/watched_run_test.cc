// A run that a page or a scene watches is the run that nobody watches.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/captured.h"
#include "tests/support/temporary_folder.h"
#include "tools/page/write_page.h"

namespace g31::watched_run_test {
namespace {

using testing::g31;

constexpr const char* kPitchErrors =
    "[parameters]\n"
    "\"3620.X\" = 0\n\"3621.X\" = 0\n\"3622.X\" = 9\n\"3623.X\" = 1\n\"3624.X\" = 10.0\n"
    "\"10001\" = 5\n\"10002\" = 7\n\"10003\" = 7\n";
constexpr const char* kProbeAndBlock =
    "[probe]\nlength = 100.0\n[[part]]\nshape = \"block\"\nat = [70.0, 0.0, -95.0]\n";

class WatchedRun : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!page::read_assets()) {
      GTEST_SKIP() << "the page's script was not built: node and npm are not here";
    }
  }

  /// The exit codes of a run without and with a page.
  std::vector<int> codes(const std::string& program, const std::string& sheet,
                         const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"run", program, "-s", folder_.write("sheet.toml", sheet)};
    words.insert(words.end(), more.begin(), more.end());
    std::vector<int> codes = {g31(words).exit_code};
    words.insert(words.end(), {"--report", folder_.path("page.html")});
    codes.push_back(g31(words).exit_code);
    return codes;
  }

  testing::TemporaryFolder folder_;
};

/// X37 less 5 + 7 + 7 um, by the tables of the control.
TEST_F(WatchedRun, IsCorrectedByTheControl) {
  const std::string program =
      folder_.write("pitch.nc", "%\nO1\nG90 G21 G94\nG31 X60. F100.\n#100=#5061\nM30\n%\n");
  EXPECT_EQ(codes(program, std::string(kPitchErrors) + kProbeAndBlock,
                  {"--expect", "#100=36.981+-0.0001"}),
            (std::vector<int>{0, 0}));
}

/// v/2 (v/a + a/j) = 3.5 mm of braking are more than the stylus gives way.
TEST_F(WatchedRun, BrakesAsTheControlSaysIt) {
  const std::string program =
      folder_.write("jerk.mpf", "G90 G71 G94 G500 D0\nMEAS=1 G1 X60 F6000\nM30\n");
  const std::string sheet = std::string("[machine.axes.X]\njerk = 100000.0\n") + kProbeAndBlock;
  EXPECT_EQ(codes(program, sheet), (std::vector<int>{4, 4}));
  const auto scene =
      g31({"scene", program, "-s", folder_.path("sheet.toml"), "-o", folder_.path("scene.gltf")});
  EXPECT_EQ(scene.exit_code, 4) << scene.errors;
}

}  // namespace
}  // namespace g31::watched_run_test
