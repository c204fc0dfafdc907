// Blocks with 3 to 12 features at random, made by Open CASCADE, written as STEP and recognised.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "machine/base/random.h"
#include "parts/features/recognise.h"
#include "parts/solids/removal.h"
#include "tests/solids/made_parts.h"
#include "tests/solids/step_text.h"
#include "tests/support/effort.h"
#include "tests/support/temporary_folder.h"

namespace g31::random_blocks_test {
namespace {

using parts::Box;
using parts::FeatureKind;
using enum parts::Side;

struct Expected {
  FeatureKind kind = FeatureKind::ClosedPocket;
  Box box;
  std::array<bool, parts::kSides> open{};
};

/// A block of 4 x 3 cells, a feature in each at most, and a step or an open slot beside them.
class BlockMaker {
 public:
  explicit BlockMaker(std::uint64_t number) : stream_{number, 0} {
    stock_ = Box{{0.0, 0.0, -60.0}, {4 * kCell + kStrip, 3 * kCell + kStrip, 0.0}};
    add_beside_the_cells();
    std::vector<std::size_t> cells;
    for (std::size_t cell = 0; cell < 12; ++cell) {
      cells.push_back(cell);
    }
    const std::size_t count = 2 + draw_index(10);
    for (std::size_t i = 0; i < count; ++i) {
      std::swap(cells[i], cells[i + draw_index(cells.size() - i)]);
      add_in_cell(cells[i]);
    }
  }

  [[nodiscard]] TopoDS_Shape product() const { return testing::cut(testing::block(stock_), cuts_); }
  [[nodiscard]] const Box& stock() const { return stock_; }

  /// As parts::recognise sorts them.
  [[nodiscard]] std::vector<Expected> expected() const {
    std::vector<Expected> sorted = features_;
    std::ranges::sort(sorted, {}, [](const Expected& row) {
      return std::array{row.box.min.x(), row.box.min.y(), row.box.min.z()};
    });
    return sorted;
  }

 private:
  static constexpr double kCell = 60.0;
  static constexpr double kStrip = 30.0;  // at +X and at +Y

  double draw(double from, double to) {
    const double share = uniform(stream_, next_++);
    return std::round(1000.0 * (from + share * (to - from))) / 1000.0;  // as drawings have it
  }
  std::size_t draw_index(std::size_t count) {
    return static_cast<std::size_t>(uniform(stream_, next_++) * static_cast<double>(count));
  }

  void add(FeatureKind kind, const Box& box, std::initializer_list<parts::Side> open) {
    Expected feature{kind, box, {}};
    for (const parts::Side side : open) {
      feature.open[static_cast<std::size_t>(side)] = true;
    }
    features_.push_back(feature);
    const bool is_round = kind == FeatureKind::BlindHole || kind == FeatureKind::ThroughHole;
    if (is_round) {
      const Point foot((box.min.x() + box.max.x()) / 2, (box.min.y() + box.max.y()) / 2,
                       box.min.z());
      cuts_.push_back(testing::pin(foot, box.max.x() - box.min.x(), box.max.z() - box.min.z()));
    } else {
      cuts_.push_back(testing::block(box));
    }
  }

  /// In the strips outside of the cells: a step at +X, or a slot along X and one along Y.
  void add_beside_the_cells() {
    const double depth = draw(3.0, 40.0);
    if (draw_index(2) == 0) {
      const double x = stock_.max.x() - draw(5.0, kStrip - 5.0);
      return add(FeatureKind::Step, {{x, 0.0, -depth}, stock_.max}, {ZPlus, XPlus, YPlus, YMinus});
    }
    const double y = stock_.max.y() - draw(15.0, kStrip - 5.0);
    add(FeatureKind::OpenSlot, {{0.0, y, -depth}, {stock_.max.x(), y + draw(5.0, 12.0), 0.0}},
        {ZPlus, XPlus, XMinus});
  }

  void add_in_cell(std::size_t cell) {
    const double x = kCell * static_cast<double>(cell % 4);
    const double y = kCell * static_cast<double>(cell / 4);
    const double depth = draw(2.0, 50.0);
    Box box{{x + draw(3.0, 20.0), y + draw(3.0, 20.0), -depth},
            {x + draw(30.0, 55.0), y + draw(30.0, 55.0), 0.0}};
    Box through = box;
    through.min.z() = stock_.min.z();
    const bool is_left = cell % 4 == 0;
    const bool is_front = cell / 4 == 0;
    switch (draw_index(6)) {
      case 0:
        return add(FeatureKind::ClosedPocket, box, {ZPlus});
      case 1:
        return add(FeatureKind::ThroughPocket, through, {ZPlus, ZMinus});
      case 2:
        return add(FeatureKind::BlindHole, squared(box), {ZPlus});
      case 3:
        return add(FeatureKind::ThroughHole, squared(through), {ZPlus, ZMinus});
      default:
        break;
    }
    if (is_left && is_front) {
      box.min.x() = box.min.y() = 0.0;
      return add(FeatureKind::OpenPocket, box, {ZPlus, XMinus, YMinus});
    }
    if (is_left) {
      box.min.x() = 0.0;
      return add(FeatureKind::ClosedSlot, box, {ZPlus, XMinus});
    }
    if (is_front) {
      box.min.y() = 0.0;
      return add(FeatureKind::ClosedSlot, box, {ZPlus, YMinus});
    }
    add(FeatureKind::ClosedPocket, box, {ZPlus});
  }

  /// The box around a circle of a drawn diameter in the lower corner.
  static Box squared(Box box) {
    const double diameter = std::min(box.max.x() - box.min.x(), box.max.y() - box.min.y());
    box.max.x() = box.min.x() + diameter;
    box.max.y() = box.min.y() + diameter;
    return box;
  }

  Stream stream_;
  std::uint64_t next_ = 0;
  Box stock_;
  std::vector<TopoDS_Shape> cuts_;
  std::vector<Expected> features_;
};

TEST(RandomBlocks, AreRecognisedWithoutOneMistake) {
  const std::uint64_t blocks = testing::of_many(200U);
  const testing::TemporaryFolder folder;
  const std::string path = folder.path("block.step");
  std::size_t features = 0;
  for (std::uint64_t number = 0; number < blocks; ++number) {
    SCOPED_TRACE(fmt::format("block {}", number));
    const BlockMaker maker(number);
    testing::write_step(maker.product(), "block", path);
    const Point size = maker.stock().max - maker.stock().min;
    const auto removal = parts::removal_of(path, {"", size});
    ASSERT_TRUE(removal.ok()) << removal.error();
    const auto part = parts::recognise(removal.value().stock_P, removal.value().volumes);
    for (const auto& unknown : part.unknown) {
      ADD_FAILURE() << unknown.why;
    }
    const std::vector<Expected> expected = maker.expected();
    ASSERT_EQ(part.features.size(), expected.size());
    features += expected.size();
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_EQ(name_of(part.features[i].kind), name_of(expected[i].kind));
      EXPECT_LT((part.features[i].box_P.min - expected[i].box.min).norm(), 1e-6);
      EXPECT_LT((part.features[i].box_P.max - expected[i].box.max).norm(), 1e-6);
      EXPECT_EQ(part.features[i].open, expected[i].open);
    }
  }
  EXPECT_GT(features, 3 * blocks);
}

}  // namespace
}  // namespace g31::random_blocks_test
