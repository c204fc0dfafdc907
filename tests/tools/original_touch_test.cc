// Our O9010 and the one that Hirose's paper prints: the same touches leave the same points.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/original_listings.h"
#include "tests/support/run_program.h"

namespace g31::original_touch_test {
namespace {

using testing::original_listings;
using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

constexpr int kFirstKept = 540;      ///< points of a run: three variables each from here on
constexpr int kTouchesOfARun = 150;  ///< up to #989
const unsigned kRuns = testing::of_many(7U);

class RandomTouches {
 public:
  explicit RandomTouches(unsigned seed) : random_(seed) {}

  double between(double low, double high) {
    return std::uniform_real_distribution<>(low, high)(random_);
  }
  double sign() { return random_() % 2U == 0U ? 1.0 : -1.0; }
  std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(random_() % limit); }

  /// A touch of the ring from its centre, or of its top face.  Where U is longest, or 0, both
  /// macros draw back the same way; elsewhere the original's is longer, and may be too long for the
  /// ring.
  std::string call(int row) {
    const std::string end = fmt::format(" R5. Z{:.3f} A{}.", between(-11.0, -8.0), row);
    const double way = sign() * between(30.0, 60.0);
    switch (below(5)) {
      case 0:
        return at_centre() + fmt::format("G100 U{:.4f}", way) + end;
      case 1:
        return at_centre() +
               fmt::format("G100 U{:.4f} V{:.4f} W{:.4f}", way, way * between(-0.99, 0.99),
                           way * between(-0.3, 0.3)) +
               end;
      case 2:
        return at_centre() + fmt::format("G100 V{:.4f} W{:.4f}", way, way * between(-0.3, 0.3)) +
               end;
      case 3: {
        const double u = sign() * between(18.0, 24.0);
        return at_centre() +
               fmt::format("G100 U{:.4f} V{:.4f}", u, u * sign() * between(0.0, 1.0)) + end;
      }
      default:
        return fmt::format("X{:.3f} Y{:.3f}\nG100 W{:.4f} R8. Z{:.3f} A{}.", between(28.0, 32.0),
                           between(-3.0, 3.0), between(-20.0, -12.0), between(4.0, 6.0), row);
    }
  }

 private:
  std::string at_centre() {
    return fmt::format("X{:.3f} Y{:.3f}\n", between(-2.0, 2.0), between(-2.0, 2.0));
  }

  std::mt19937 random_;
};

std::string program_of(RandomTouches& touches) {
  std::string text = "%\nO1\nG90 G59 G00 X0 Y0\nG43 Z20. H99\n";
  for (int i = 0; i < kTouchesOfARun; ++i) {
    const int row = 1 + static_cast<int>(touches.below(9));
    const int kept = kFirstKept + 3 * i;
    text += fmt::format("{}\n#{}= #{}\n#{}= #{}\n#{}= #{}\n", touches.call(row), kept, 159 + row,
                        kept + 1, 174 + row, kept + 2, 189 + row);
  }
  return text + "M30\n%\n";
}

std::vector<double> kept_points(const std::string& program, const std::string& sheet,
                                const std::vector<std::string>& libraries) {
  cli::RunOptions options;
  options.programs = {program};
  options.setups = {"parts/library/ring_gauge/ring.toml", sheet};
  options.libraries = libraries;
  options.prints = {fmt::format("#{}-#{}", kFirstKept, kFirstKept + 3 * kTouchesOfARun - 1)};
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  std::vector<double> points;
  for (int i = 0; i < 3 * kTouchesOfARun && output.exit_code == 0; ++i) {
    points.push_back(
        output.document.at("variables").at(fmt::format("#{}", kFirstKept + i)).get<double>());
  }
  return points;
}

TEST(OriginalTouch, AThousandRandomTouchesLeaveTheSamePoints) {
  const auto listings = original_listings();
  if (!listings) {
    GTEST_SKIP() << "the original listings are not here; G31_HIROSE names their folder";
  }
  TemporaryFolder folder;
  for (unsigned run = 0; run < kRuns; ++run) {
    RandomTouches touches(run);
    const std::string program = folder.write("touches.nc", program_of(touches));
    const std::string sheet = folder.write(
        "late.toml",
        fmt::format("[probe]\ntrigger_delay_s = {:.6f}\n[variables]\n\"#517\" = {:.4f}\n"
                    "\"#518\" = {:.4f}\n\"#519\" = {:.4f}\n\"#530\" = {:.4f}\n"
                    "\"#531\" = {:.4f}\n",
                    touches.between(0.0, 0.005), touches.between(-0.01, 0.0),
                    touches.between(-0.01, 0.0), touches.between(-0.01, 0.0),
                    touches.between(-0.03, 0.03), touches.between(-0.03, 0.03)));
    const auto ours = kept_points(program, sheet, {"macros/fanuc"});
    const auto original = kept_points(program, sheet, {*listings});
    ASSERT_EQ(ours.size(), original.size());
    ASSERT_FALSE(ours.empty());
    double worst = 0.0;
    for (std::size_t i = 0; i < ours.size(); ++i) {
      worst = std::max(worst, std::abs(ours[i] - original[i]));
    }
    EXPECT_LT(worst, 1e-9) << "run " << run;
  }
}

TEST(OurTouch, DrawsBackAShortWayAlsoWhereTheMoveIsSteep) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write(
      "steep.nc", "O1\nG90 G59 G00 X0 Y0\nG43 Z20. H99\nG100 U1. V50. R5. Z-9. A1.\nM30\n")};
  options.setups = {"parts/library/ring_gauge/ring.toml"};
  options.prints = {"#160", "#175"};
  const RunOutput output = run_program(options);
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  // Along a radius of the ring of 39.996 mm; the way back is rounded to thousandths.
  const double length = std::hypot(1.0, 50.0);
  EXPECT_NEAR(output.document.at("variables").at("#160").get<double>(), 19.998 / length, 1e-3);
  EXPECT_NEAR(output.document.at("variables").at("#175").get<double>(), 19.998 * 50.0 / length,
              1e-3);
}

}  // namespace
}  // namespace g31::original_touch_test
