// CYCLE95 over contours drawn by chance: what it does is held against the contour itself, taken as
// a dense polyline, which knows nothing of crossings and of ways beside others.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/run_program.h"

namespace g31::testing::stock_removal_test {
namespace {

using Point = Eigen::Vector2d;  ///< Z and the radius X, mm

/// As far as the polyline stands off arcs of 6 mm, and more.
constexpr double kChord = 2e-5;

struct Element {
  Point to;
  int g = 1;
  double radius = 0.0;
};

class RandomContour {
 public:
  explicit RandomContour(unsigned seed) : random_(seed) {
    elements_.push_back({{0.0, 10.0}});
    along(between(3.0, 8.0), 0.0);
    const int count = 1 + static_cast<int>(between(0.0, 4.0));
    for (int i = 0; i < count; ++i) {
      add_rise();
      along(between(3.0, 8.0), 0.0);
    }
  }

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
  }
  [[nodiscard]] const std::vector<Element>& elements() const { return elements_; }
  /// Of a bore instead of a shaft.
  void turn_inside_out() {
    for (Element& element : elements_) {
      element.to.y() = 60.0 - element.to.y();
      element.g = element.g > 1 ? 5 - element.g : 1;
    }
  }

 private:
  void along(double back, double out, int g = 1, double radius = 0.0) {
    const Point to = elements_.back().to + Point(-back, out);
    elements_.push_back({to, g, radius});
  }
  void add_rise() {
    const double size = between(2.0, 6.0);
    const double kind = between(0.0, 4.0);
    if (kind < 1.0) {
      along(between(1.0, 6.0), size);
    } else if (kind < 2.0) {
      along(0.0, size);
    } else {
      along(size, size, kind < 3.0 ? 2 : 3, size);
    }
  }

  std::mt19937 random_;
  std::vector<Element> elements_;
};

/// The centre of a quarter of a circle.
Point centre_of(const Point& from, const Element& element) {
  const Point way = element.to - from;
  const double side = element.g == 3 ? 1.0 : -1.0;
  return from + 0.5 * way + 0.5 * side * Point(-way.y(), way.x());
}

Point turned(const Point& arm, double angle) {
  return {std::cos(angle) * arm.x() - std::sin(angle) * arm.y(),
          std::sin(angle) * arm.x() + std::cos(angle) * arm.y()};
}

struct Outline {
  std::vector<Point> points;
  std::vector<Point> centres;  ///< of arcs, and corners, about which arcs beside may go

  Outline(const std::vector<Element>& elements, const Point& shift) {
    Point at = elements.front().to;
    points.push_back(at + shift);
    for (std::size_t i = 1; i < elements.size(); ++i) {
      if (elements[i].g > 1) {
        const Point centre = centre_of(at, elements[i]);
        centres.push_back(centre + shift);
        constexpr int kChords = 400;
        const double step = (elements[i].g == 3 ? 0.5 : -0.5) * std::numbers::pi / kChords;
        for (int k = 1; k < kChords; ++k) {
          points.push_back(centre + turned(at - centre, k * step) + shift);
        }
      }
      at = elements[i].to;
      points.push_back(at + shift);
      centres.push_back(at + shift);
    }
  }

  [[nodiscard]] double distance(const Point& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < points.size(); ++i) {
      const Point way = points[i] - points[i - 1];
      const double share = std::clamp((p - points[i - 1]).dot(way) / way.squaredNorm(), 0.0, 1.0);
      least = std::min(least, (p - points[i - 1] - share * way).norm());
    }
    return least;
  }

  /// Points of a move; none where it is an arc about nothing of the contour.
  [[nodiscard]] std::vector<Point> samples(const Point& from, const Point& to, int g) const {
    constexpr int kPieces = 16;
    std::vector<Point> all;
    std::optional<Point> centre;
    for (const Point& about : centres) {
      const Point a = from - about;
      const Point b = to - about;
      const bool is_left = a.x() * b.y() - a.y() * b.x() > 0.0;
      if (g > 1 && std::abs(a.norm() - b.norm()) < 1e-6 && is_left == (g == 3) &&
          (!centre || a.norm() < (from - *centre).norm())) {
        centre = about;
      }
    }
    if (g > 1 && !centre) {
      return all;
    }
    for (int k = 0; k <= kPieces; ++k) {
      const double share = static_cast<double>(k) / kPieces;
      Point p = from + share * (to - from);
      if (centre) {
        const Point a = from - *centre;
        const Point b = to - *centre;
        const double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
        p = *centre + turned(a, share * angle);
      }
      all.push_back(p);
    }
    return all;
  }
};

std::string block_of(const char* code, const Element& element) {
  std::string text = fmt::format("{} X{:.9f} Z{:.9f}", code, 2.0 * element.to.y(), element.to.x());
  if (element.radius > 0.0) {
    text += fmt::format(" CR={:.9f}", element.radius);
  }
  return text + "\n";
}

std::string program_of(const std::vector<Element>& elements, bool is_backward) {
  constexpr const char* kCodes[] = {"G0", "G1", "G2", "G3"};
  std::vector<Element> list = elements;
  if (is_backward) {
    for (std::size_t i = 0; i < list.size(); ++i) {
      const std::size_t from = elements.size() - 1 - i;
      const Element way = i == 0 ? Element() : elements[from + 1];
      list[i] = {elements[from].to, way.g > 1 ? 5 - way.g : 1, way.radius};
    }
  }
  std::string text = block_of("G0", {list.front().to});
  for (std::size_t i = 1; i < list.size(); ++i) {
    text += block_of(kCodes[list[i].g], list[i]);
  }
  return text;
}

struct Move {
  Point from;
  Point to;
  int g = 0;
};

/// Of a program that calls CYCLE95 alone.
std::vector<Move> moves_of(const std::string& call, const std::string& shape) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.control = "sinumerik-828d";
  options.programs = {
      folder.write("main.mpf", "G18 G90 DIAMON G94\nG0 X60 Z50\n" + call + "M30\n")};
  folder.write("SHAPE.SPF", shape + "M17\n");
  options.moves = true;
  const RunOutput run = run_program(options);
  EXPECT_EQ(run.exit_code, 0) << run.errors << shape;
  std::vector<Move> moves;
  Point at(0.0, 0.0);
  for (const auto& row : run.document["moves"]) {
    const Point to(row["to"][2].get<double>(), row["to"][0].get<double>());
    moves.push_back({at, to, row["g"].get<int>()});
    at = to;
  }
  return moves;
}

struct Wanted {
  double beside = 0.0;
  double cut = 0.0;
  int level_axis = 0;  ///< of a Point
};

/// Cuts end beside the contour and go along it; nothing comes nearer; cuts are evenly spread.
void expect_roughing(const std::vector<Move>& moves, const Outline& outline, const Wanted& wanted) {
  ASSERT_GT(moves.size(), 4U);
  std::vector<double> levels;
  for (std::size_t i = 2; i < moves.size(); ++i) {
    const Move& move = moves[i];
    const auto points = outline.samples(move.from, move.to, move.g);
    EXPECT_FALSE(points.empty()) << "move " << i;
    const bool is_cut = move.g == 1 && moves[i - 1].g == 0;
    for (const Point& p : points) {
      const double distance = outline.distance(p);
      EXPECT_GT(distance, wanted.beside - kChord) << "move " << i << " at " << p.transpose();
      if (move.g > 0 && !is_cut) {
        EXPECT_NEAR(distance, wanted.beside, kChord) << "move " << i << " at " << p.transpose();
      }
    }
    if (is_cut) {
      EXPECT_NEAR(outline.distance(move.to), wanted.beside, kChord) << "move " << i;
      levels.push_back(move.to[wanted.level_axis]);
    }
  }
  EXPECT_EQ(moves.back().to, moves[1].to);
  for (std::size_t i = 1; i < levels.size(); ++i) {
    const double step = std::abs(levels[i] - levels[i - 1]);
    EXPECT_LE(step, wanted.cut + 1e-9);
    EXPECT_NEAR(step, std::abs(levels[1] - levels[0]), 1e-9);
  }
}

TEST(StockRemoval, CutsEndBesideAnyContourAndNothingComesNearer) {
  for (unsigned seed = 0; seed < of_many(80U); ++seed) {
    SCOPED_TRACE(seed);
    RandomContour contour(seed);
    const int form = static_cast<int>(seed % 4);
    const bool is_inside = form > 1;
    if (is_inside) {
      contour.turn_inside_out();
    }
    const double along = contour.between(0.0, 0.5);
    const double across = contour.between(0.0, 0.5);
    const Wanted wanted{contour.between(0.1, 0.8), contour.between(0.5, 3.0),
                        form % 2 == 0 ? 1 : 0};
    const Outline outline(contour.elements(), {along, is_inside ? -across : across});
    const auto moves =
        moves_of(fmt::format("CYCLE95(\"SHAPE\",{:.9f},{:.9f},{:.9f},{:.9f},100,,,{},,,0.5)\n",
                             wanted.cut, along, across, wanted.beside, form + 1),
                 program_of(contour.elements(), seed % 3 == 0));
    expect_roughing(moves, outline, wanted);
    if (form % 2 == 0) {
      // Both ends are cylinders: the depth between them in cuts of `wanted.cut` at most.
      const double depth =
          std::abs(contour.elements().back().to.y() - contour.elements().front().to.y());
      const auto cuts = std::ranges::count_if(
          moves, [&](const Move& move) { return move.g == 1 && move.from.x() == moves[1].to.x(); });
      EXPECT_EQ(cuts, static_cast<long>(std::ceil(depth / wanted.cut)));
    }
  }
}

/// The moves that go along the contour itself.
std::vector<Move> finishing_of(const std::vector<Move>& moves, const Outline& outline) {
  const auto is_on_it = [&](const Point& p) { return outline.distance(p) < kChord; };
  std::vector<Move> along;
  for (const Move& move : moves) {
    const auto points = outline.samples(move.from, move.to, move.g);
    if (move.g > 0 && !points.empty() && std::ranges::all_of(points, is_on_it)) {
      along.push_back(move);
    }
  }
  return along;
}

TEST(StockRemoval, FinishingGoesAlongTheContourAloneAsItIsWrittenBehindRoughingAsTheCutsRun) {
  for (unsigned seed = 0; seed < of_many(32U); ++seed) {
    SCOPED_TRACE(seed);
    RandomContour contour(seed);
    const int form = static_cast<int>(seed % 4);
    if (form > 1) {
      contour.turn_inside_out();
    }
    const bool is_alone = seed % 8 < 4;
    const bool is_backward = seed % 3 == 0;
    const Outline outline(contour.elements(), {0.0, 0.0});
    const auto moves = moves_of(
        fmt::format("CYCLE95(\"SHAPE\",1,0.1,0.1,,100,,50,{})\n", form + (is_alone ? 5 : 9)),
        program_of(contour.elements(), is_backward));
    const auto along = finishing_of(moves, outline);
    ASSERT_EQ(along.size(), contour.elements().size() - 1);
    // Cuts along Z run from the free end, those along X from the shoulder.
    const bool from_behind = is_alone ? is_backward : form % 2 == 1;
    const Point first = from_behind ? outline.points.back() : outline.points.front();
    EXPECT_LT((along.front().from - first).norm(), 1e-6);
    EXPECT_EQ(moves.back().to, moves[1].to);
  }
}

}  // namespace
}  // namespace g31::testing::stock_removal_test
