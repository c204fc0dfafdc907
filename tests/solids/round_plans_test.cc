// Blocks with holes and bosses at random: each is measured by the cycle of the control where that
// has room, and every value is that of the drawing.

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "machine/base/random.h"
#include "tests/solids/made_parts.h"
#include "tests/solids/step_text.h"
#include "tests/support/effort.h"
#include "tests/support/temporary_folder.h"
#include "tools/plan/plan_part.h"

namespace g31::round_plans_test {
namespace {

using plan::PlannedPart;

struct Circle {
  double x = 0.0;
  double y = 0.0;
  double diameter = 0.0;
  double depth = 0.0;  ///< 0: through
  bool is_boss = false;
  bool is_close = false;  ///< a boss with 8 mm around it
};

/// 3 x 2 cells of 60 mm, a hole in each or a boss in a pocket; heights from -40 to 0.
class BlockMaker {
 public:
  explicit BlockMaker(std::uint64_t number) : stream_{number, 7} {
    for (int cell = 0; cell < 6; ++cell) {
      add(kCell * (cell % 3), kCell * static_cast<double>(cell / 3));
    }
  }

  [[nodiscard]] const std::vector<Circle>& circles() const { return circles_; }
  [[nodiscard]] TopoDS_Shape product() const {
    return testing::cut(testing::block({{0.0, 0.0, -40.0}, {3 * kCell, 2 * kCell, 0.0}}), cuts_);
  }

 private:
  static constexpr double kCell = 60.0;

  double draw(double from, double to) {
    const double share = uniform(stream_, next_++);
    return std::round(1000.0 * (from + share * (to - from))) / 1000.0;
  }

  void add(double x, double y) {
    Circle circle;
    circle.x = x + draw(28.0, 32.0);
    circle.y = y + draw(28.0, 32.0);
    circle.is_boss = draw(0.0, 1.0) < 0.4;
    circle.depth = draw(0.0, 1.0) < 0.3 && !circle.is_boss ? 0.0 : draw(9.0, 25.0);
    circle.diameter = circle.is_boss || draw(0.0, 1.0) < 0.6 ? draw(9.6, 24.0) : draw(7.0, 9.4);
    const double height = circle.depth == 0.0 ? 40.0 : circle.depth;
    const Point foot(circle.x, circle.y, -height);
    const TopoDS_Shape pin = testing::pin(foot, circle.diameter, height);
    if (!circle.is_boss) {
      cuts_.push_back(pin);
    } else {
      circle.is_close = draw(0.0, 1.0) < 0.4;
      const double half = circle.diameter / 2 + (circle.is_close ? 8.0 : 13.0);
      cuts_.push_back(testing::cut(testing::block({{circle.x - half, circle.y - half, -height},
                                                   {circle.x + half, circle.y + half, 0.0}}),
                                   {pin}));
    }
    circles_.push_back(circle);
  }

  Stream stream_;
  std::uint64_t next_ = 0;
  std::vector<Circle> circles_;
  std::vector<TopoDS_Shape> cuts_;
};

/// O9010 draws back by 3 mm, half a millimetre stays free; the ball is one of 6 mm.
bool has_cycle(const Circle& circle, bool is_sinumerik) {
  return is_sinumerik || (circle.is_boss ? !circle.is_close : circle.diameter - 6.0 >= 3.5);
}

void expect_circle(const PlannedPart& planned, std::size_t feature, const Circle& circle,
                   bool is_sinumerik) {
  const probe::PlannedRound* const round = plan::round_of(planned, feature);
  ASSERT_NE(round, nullptr);
  EXPECT_EQ(round->by_points.empty(), has_cycle(circle, is_sinumerik)) << round->by_points;
  std::map<std::string, double> expected = {
      {"X", circle.diameter}, {"X.place", circle.x}, {"Y", circle.diameter}, {"Y.place", circle.y}};
  if (circle.depth > 0.0) {
    expected["Z"] = circle.depth;
  }
  std::size_t found = 0;
  for (std::size_t i = 0; i < planned.plan.measures.size(); ++i) {
    const probe::PlannedMeasure& measure = planned.plan.measures[i];
    if (measure.feature == feature) {
      const std::string name = measure.id.substr(measure.id.find('.') + 1);
      EXPECT_NEAR(planned.proven_values[i].value_or(-1.0), expected.at(name), 1e-6) << measure.id;
      ++found;
    }
  }
  EXPECT_EQ(found, expected.size());
}

TEST(RoundPlans, OfRandomHolesAndBossesAreThoseOfTheDrawing) {
  const std::uint64_t blocks = testing::of_many(12U);
  const testing::TemporaryFolder folder;
  const std::string path = folder.path("block.step");
  std::map<bool, std::size_t> by_cycle;
  for (std::uint64_t number = 0; number < blocks; ++number) {
    const BlockMaker maker(number);
    testing::write_step(maker.product(), "block", path);
    for (const char* const control : {"fanuc-30i", "sinumerik-828d"}) {
      SCOPED_TRACE(fmt::format("block {}, {}", number, control));
      const bool is_sinumerik = std::string(control) == "sinumerik-828d";
      plan::PlanRequest request;
      request.product = path;
      request.stock = "180,120,40";
      request.control = control;
      request.folder = folder.path("");
      const auto planned = plan::plan_part(request);
      ASSERT_TRUE(planned.ok()) << planned.error().message;
      std::size_t found = 0;
      const auto& features = planned.value().part.features;
      for (std::size_t i = 0; i < features.size(); ++i) {
        const Point middle = (features[i].box_P.min + features[i].box_P.max) / 2;
        for (const Circle& circle : maker.circles()) {
          if (features[i].is_round &&
              std::hypot(middle.x() - circle.x, middle.y() - circle.y) < 1.0) {
            expect_circle(planned.value(), i, circle, is_sinumerik);
            ++by_cycle[has_cycle(circle, is_sinumerik)];
            ++found;
          }
        }
      }
      EXPECT_EQ(found, maker.circles().size());
    }
  }
  EXPECT_GT(by_cycle[true], 3 * by_cycle[false]);
  EXPECT_GT(by_cycle[false], 0U);
}

// The touches begin 3 mm off the wall wherever the boss is, however its coordinates are rounded.
TEST(RoundPlans, MeasureABossByTheCycleWhereverItIs) {
  constexpr double kDiameter = 20.0;
  const testing::TemporaryFolder folder;
  for (const auto& [x, y] : {std::pair(48.7, 51.0), std::pair(48.7, 51.04), std::pair(47.3, 53.1),
                             std::pair(52.6, 48.9)}) {
    SCOPED_TRACE(fmt::format("boss at X{} Y{}", x, y));
    plan::PlanRequest request;
    request.product = folder.path("boss.step");
    request.stock = "box";
    request.control = "fanuc-30i";
    request.folder = folder.path("");
    testing::write_step(testing::cut(testing::block({{0, 0, -30}, {100, 100, 0}}),
                                     {testing::cut(testing::block({{10, 10, -10}, {90, 90, 0}}),
                                                   {testing::pin({x, y, -10}, kDiameter, 10)})}),
                        "boss", request.product);
    const auto planned = plan::plan_part(request);
    ASSERT_TRUE(planned.ok()) << planned.error().message;
    ASSERT_EQ(planned.value().plan.rounds.size(), 1U);
    EXPECT_EQ(planned.value().plan.rounds[0].by_points, "");
    expect_circle(planned.value(), planned.value().plan.rounds[0].feature,
                  {x, y, kDiameter, 10.0, true, false}, false);
  }
}

}  // namespace
}  // namespace g31::round_plans_test
