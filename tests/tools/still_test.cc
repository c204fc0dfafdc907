// Stills of runs: what is drawn is there, what is behind is not, numbers do not lie on each other.

#include "tools/picture/still.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <map>
#include <memory>
#include <numbers>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <zlib.h>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"
#include "tools/cli/scene_command.h"
#include "tools/cli/svg_to_png.h"
#include "tools/picture/png.h"
#include "tools/picture/raster.h"

namespace g31::picture::still_test {
namespace {

using testing::TemporaryFolder;

parts::Mesh box(const Point& low, const Point& high) {
  parts::Mesh mesh;
  for (int i = 0; i < 8; ++i) {
    mesh.vertices.emplace_back((i & 1) != 0 ? high.x() : low.x(), (i & 2) != 0 ? high.y() : low.y(),
                               (i & 4) != 0 ? high.z() : low.z());
  }
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

std::size_t count(const std::string& text, const std::string& piece) {
  std::size_t found = 0;
  for (auto at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) {
    ++found;
  }
  return found;
}

struct Still {
  int exit_code = -1;
  std::string file;
  std::string errors;
};

Still still_of(const std::string& program, const std::string& name,
               const std::string& theme = "light") {
  TemporaryFolder folder;
  cli::SceneOptions options;
  options.run.programs = {program};
  options.run.setups = {"parts/library/ring_gauge/ring.toml",
                        "parts/library/ring_gauge/late_probe.toml"};
  options.output = folder.path(name);
  options.theme = theme;
  Still still;
  ::testing::internal::CaptureStderr();
  still.exit_code = static_cast<int>(cli::scene_command(options));
  still.errors = ::testing::internal::GetCapturedStderr();
  std::ifstream file(options.output, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  still.file = std::move(bytes).str();
  return still;
}

const char* const kMeasureRing = "parts/library/ring_gauge/measure_ring.nc";

/// Left, top and width of the fields of numbers, view by view.
std::vector<std::vector<std::array<double, 3>>> fields_of(const std::string& svg) {
  std::vector<std::vector<std::array<double, 3>>> views;
  const std::regex field(
      R"re(<image |<rect class="number" x="([0-9.]+)" y="([0-9.]+)" width="([0-9.]+)")re");
  for (std::sregex_iterator match(svg.begin(), svg.end(), field), end; match != end; ++match) {
    if ((*match)[1].str().empty()) {
      views.emplace_back();
    } else {
      views.back().push_back(
          {std::stod((*match)[1]), std::stod((*match)[2]), std::stod((*match)[3])});
    }
  }
  return views;
}

TEST(Still, OfTheRingHasItsTouchesByNumberTwice) {
  const Still still = still_of(kMeasureRing, "ring.svg");
  ASSERT_EQ(still.exit_code, 0) << still.errors;
  EXPECT_EQ(still.file, still_of(kMeasureRing, "again.svg").file);
  EXPECT_NE(still.file, still_of(kMeasureRing, "dark.svg", "dark").file);
  // A fast and a slow touch at each place; the first of three moves finds no wall.
  for (const char* numbers : {">2, 3<", ">5, 6<", ">8, 9<", ">11, 12<"}) {
    EXPECT_EQ(count(still.file, numbers), 2U) << numbers << ": once in each view";
  }
  for (const char* words : {">measure_ring.nc<", "Isometric, cut open", "From above (XY)", ">ring<",
                            " mm</text>", " \u00b5m (", ">skip move<", "what measuring adds"}) {
    EXPECT_NE(still.file.find(words), std::string::npos) << words;
  }
  const auto views = fields_of(still.file);
  ASSERT_EQ(views.size(), 2U);
  for (const auto& fields : views) {
    ASSERT_EQ(fields.size(), 4U);
    for (const auto& a : fields) {
      for (const auto& b : fields) {
        const bool apart = a == b || a[0] + a[2] < b[0] || b[0] + b[2] < a[0] ||
                           a[1] + 18.0 < b[1] || b[1] + 18.0 < a[1];
        EXPECT_TRUE(apart) << a[0] << " " << a[1] << " and " << b[0] << " " << b[1];
      }
    }
  }
}

TEST(Still, NamesFormsThatItCanWrite) {
  const Still bitmap = still_of(kMeasureRing, "ring.bmp");
  EXPECT_EQ(bitmap.exit_code, 2);
  EXPECT_NE(bitmap.errors.find("a picture of it a .svg or a .png file"), std::string::npos)
      << bitmap.errors;
  EXPECT_TRUE(bitmap.file.empty());
  const Still png = still_of(kMeasureRing, "ring.png");
  if (cli::has_svg_drawer()) {
    EXPECT_EQ(png.exit_code, 0);
    EXPECT_EQ(png.file.substr(0, 4), "\x89PNG");
  } else {
    EXPECT_EQ(png.exit_code, 2);
    EXPECT_NE(png.errors.find("librsvg2-bin"), std::string::npos);
  }
}

/// A cube of 40 mm and a feed along X behind it, as seen from the front; the ball's way is longer.
TEST(Still, AWayBehindAWallIsNotDrawnSolid) {
  const auto cube = std::make_shared<const parts::Mesh>(box({-20, -20, -20}, {20, 20, 20}));
  const std::vector<PicturedPart> parts = {{"cube", cube, false}};
  const std::vector<Way> ways = {{PathKind::Feed, 0.0, 1.0, {{-23, 23, -18}, {23, 23, -18}}}};
  StillScene scene;
  scene.title = "a < b & \"c\"";
  scene.ways = ways;
  const std::string free = still_svg(scene, {});
  EXPECT_EQ(count(free, "class=\"way feed hidden\" d"), 0U);
  EXPECT_NE(free.find("a &lt; b &amp; &quot;c&quot;"), std::string::npos);
  scene.parts = parts;
  const std::string behind = still_svg(scene, {});
  // In the legend, and once in the isometric view; from above it is seen whole.
  EXPECT_EQ(count(behind, "class=\"way feed hidden\" d"), 2U);
  const auto plan = behind.find("From above");
  EXPECT_LT(behind.find("class=\"way feed hidden\" d"), plan);
}

TEST(Still, ADeviationIsAWhiskerOfItsTrueLength) {
  const auto cube = std::make_shared<const parts::Mesh>(box({-20, -20, -20}, {20, 20, 20}));
  const std::vector<PicturedPart> parts = {{"cube", cube, false}};
  Mark mark;
  mark.p_M = {20, 0, 0};
  mark.n_M = Point::UnitX();
  mark.part = "cube";
  mark.touch = 1;
  mark.stylus.p_M = {20.0 + 3.0 - 0.01, 0, 0};  // latched 10 um deep
  mark.ball = TouchingBall{mark.stylus.p_M, 3.0};
  const std::vector<Mark> contacts = {mark};
  StillScene scene;
  scene.parts = parts;
  scene.contacts = contacts;
  scene.tip_radius_mm = 3.0;
  scene.last = mark.stylus;
  const std::string svg = still_svg(scene, {});
  std::smatch whisker;
  ASSERT_TRUE(std::regex_search(
      svg, whisker,
      std::regex(R"re(class="whisker" d="M([0-9.]+) ([0-9.]+)L([0-9.]+) ([0-9.]+)")re")));
  std::smatch bar;
  ASSERT_TRUE(std::regex_search(
      svg, bar,
      std::regex(
          R"re(class="scale added" d="M([0-9.]+) [0-9.]+V[0-9.]+H([0-9.]+)[^>]*>\s*<text[^>]*>([0-9.]+) )re")));
  const double length = std::stod(whisker[1]) - std::stod(whisker[3]);
  const double bar_um = std::stod(bar[3]);
  const double bar_pixels = std::stod(bar[2]) - std::stod(bar[1]);
  EXPECT_NEAR(length / bar_pixels * bar_um, 10.0, 0.1) << "into the wall, to the left";
  EXPECT_EQ(whisker[2], whisker[4]);
}

/// A star stylus: a main ball of 6 mm, one of 4 mm 30 mm beside it along its X, one of 2 mm on the
/// shaft 100 above it.
setup::Job star_stylus() {
  setup::Job job;
  job.probe.emplace();
  job.probe->ball_diameter_mm = 6.0;
  job.probe->length_mm = 150.0;
  job.probe->further_balls = {{Point(30.0, 0.0, 0.0), 4.0}, {Point(0.0, 0.0, 100.0), 2.0}};
  return job;
}

// Each ball latched 0.01 too deep in a wall whose outward normal is -X, and one on the shaft that a
// bend makes nearly as far from the main ball's place as the main ball is.
TEST(TouchingBall, IsTheOneAtTheContact) {
  const setup::Job job = star_stylus();
  const struct {
    Point p_M;  // of the ball, from the main one
    double radius;
  } kBalls[] = {{{0.0, 0.0, 0.0}, 3.0}, {{30.0, 0.0, 0.0}, 2.0}, {{0.0, 0.0, 100.0}, 1.0}};
  for (const auto& ball : kBalls) {
    SCOPED_TRACE(ball.radius);
    Mark mark;
    mark.n_M = -Point::UnitX();
    mark.p_M = ball.p_M + Point(ball.radius - 0.01, 0.0, 0.0);
    mark.ball = touching_ball(job, mark);
    ASSERT_TRUE(mark.ball.has_value());
    EXPECT_EQ(mark.ball->p_M, ball.p_M);
    EXPECT_EQ(mark.ball->radius_mm, ball.radius);
    EXPECT_NEAR(*latched_depth_mm(mark), 0.01, 1e-12);
  }
}

// Turned by 90 degrees the ball along X stands along Y; deep in a wall it is still that ball.
TEST(TouchingBall, TurnsWithTheSpindle) {
  const setup::Job job = star_stylus();
  Mark mark;
  mark.stylus.p_M = Point(100.0, 200.0, -50.0);
  mark.stylus.turn = Eigen::Quaterniond(Eigen::AngleAxisd(std::numbers::pi / 2, Point::UnitZ()));
  mark.n_M = -Point::UnitY();
  mark.p_M = Point(100.0, 230.0 + 2.0 - 1.5, -50.0);
  mark.ball = touching_ball(job, mark);
  ASSERT_TRUE(mark.ball.has_value());
  EXPECT_NEAR((mark.ball->p_M - Point(100.0, 230.0, -50.0)).norm(), 0.0, 1e-12);
  EXPECT_EQ(mark.ball->radius_mm, 2.0);
  EXPECT_NEAR(*latched_depth_mm(mark), 1.5, 1e-12);
}

TEST(TouchingBall, OfAToolIsItsTipAndHasNoDepth) {
  setup::Job job = star_stylus();
  job.tools.emplace_back();
  job.tools.back().number = 5;
  job.tools.back().kind = probe::ToolKind::Mill;
  job.tools.back().diameter_mm = 16.0;
  Mark mark;
  mark.stylus.tool = 5;
  mark.ball = touching_ball(job, mark);
  ASSERT_TRUE(mark.ball.has_value());
  EXPECT_EQ(mark.ball->radius_mm, 8.0);
  EXPECT_FALSE(latched_depth_mm(mark).has_value());
  job.probe.reset();
  mark.stylus.tool = 0;
  EXPECT_FALSE(touching_ball(job, mark).has_value());
}

// In the plan: the star's three balls where they stand, and the 4 mm one where it was latched.
TEST(Still, DrawsTheBallThatTouched) {
  const setup::Job job = star_stylus();
  const auto cube = std::make_shared<const parts::Mesh>(box({40, -20, -20}, {80, 20, 20}));
  const std::vector<PicturedPart> parts = {{"cube", cube, false}};
  const auto stylus = stylus_shape(job, 0);
  Mark mark;
  mark.p_M = {40, 0, 0};
  mark.n_M = -Point::UnitX();
  mark.part = "cube";
  mark.touch = 1;
  mark.stylus.p_M = {8, 0, 0};
  mark.ball = touching_ball(job, mark);
  const std::vector<Mark> contacts = {mark};
  StillScene scene;
  scene.parts = parts;
  scene.contacts = contacts;
  scene.stylus = stylus;
  scene.tip_radius_mm = 3.0;
  scene.last.p_M = {-20, 0, 0};
  const std::string svg = still_svg(scene, {});
  static const std::regex kCircle(
      R"re(<circle class="(ball|latched)" cx="([0-9.-]+)" cy="([0-9.-]+)" r="([0-9.]+)")re");
  std::map<std::string, std::vector<std::array<double, 2>>> circles;  // x and radius
  for (std::sregex_iterator found(svg.begin(), svg.end(), kCircle), end; found != end; ++found) {
    circles[(*found)[1]].push_back({std::stod((*found)[2]), std::stod((*found)[4])});
  }
  ASSERT_EQ(circles["ball"].size(), 3U);
  ASSERT_EQ(circles["latched"].size(), 1U);
  // Main at -20, the second one 30 beside it: so many pixels a millimetre.
  const double scale = (circles["ball"][1][0] - circles["ball"][0][0]) / 30.0;
  EXPECT_NEAR(circles["ball"][0][1], 3.0 * scale, 0.1);
  EXPECT_NEAR(circles["ball"][1][1], 2.0 * scale, 0.1);
  const auto [x, radius] = circles["latched"][0];
  EXPECT_NEAR(radius, 2.0 * scale, 0.1) << "not the main ball";
  EXPECT_NEAR(x - circles["ball"][0][0], (38.0 + 20.0) * scale, 0.2);
}

TEST(Raster, ABallCoversTheAreaOfItsCircle) {
  std::vector<Eigen::Vector2d> profile;
  for (int i = 0; i <= 90; ++i) {
    const double angle = std::numbers::pi * (i - 45) / 90.0;
    profile.emplace_back(i % 90 == 0 ? 0.0 : 10.0 * std::cos(angle), 10.0 * std::sin(angle));
  }
  View view;
  view.pixels_per_mm = 10.0;
  view.width = 300;
  view.height = 240;
  Raster raster(view, std::nullopt);
  raster.draw(turned_body(profile, 180), {}, false);
  int covered = 0;
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const double depth = raster.depth_at(x, y);
      if (!std::isfinite(depth)) {
        continue;
      }
      ++covered;
      const double off = std::hypot(x + 0.5 - 150.0, y + 0.5 - 120.0) / 10.0;
      EXPECT_NEAR(depth, std::sqrt(std::max(0.0, 100.0 - off * off)), off < 9.5 ? 0.05 : 1.0);
    }
  }
  EXPECT_NEAR(covered, std::numbers::pi * 100.0 * 100.0, 60.0);
  EXPECT_TRUE(raster.shows(view.seen({0, 0, 10.1}), 0.0));
  EXPECT_FALSE(raster.shows(view.seen({0, 0, 9.5}), 0.1));
}

TEST(Raster, NoGapIsBetweenFacetsWhosePixelsLieOnTheirEdge) {
  parts::Mesh ring;
  constexpr std::uint32_t kSteps = 720;
  for (std::uint32_t i = 0; i < kSteps; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / kSteps;
    const Point out(std::cos(angle), std::sin(angle), 0.0);
    ring.vertices.insert(ring.vertices.end(), {10.0 * out, 20.0 * out});
    const std::uint32_t here = 2 * i;
    const std::uint32_t next = 2 * ((i + 1) % kSteps);
    ring.triangles.push_back({here, here + 1, next});
    ring.triangles.push_back({next, here + 1, next + 1});
  }
  View view;
  view.width = 900;
  view.height = 900;
  for (int i = 0; i < 20; ++i) {
    view.pixels_per_mm = 20.0 + 0.0937 * i;
    view.p_M_middle = Point(0.0137 * i, 0.0137 * i, 0.0);
    Raster raster(view, std::nullopt);
    raster.draw(ring, {}, false);
    int gaps = 0;
    for (int y = 0; y < view.height; ++y) {
      for (int x = 0; x < view.width; ++x) {
        const double r = Eigen::Vector2d((x + 0.5 - 450.0) / view.pixels_per_mm + 0.0137 * i,
                                         (450.0 - y - 0.5) / view.pixels_per_mm + 0.0137 * i)
                             .norm();
        gaps += r > 10.1 && r < 19.9 && raster.depth_at(x, y) != 0.0 ? 1 : 0;
      }
    }
    EXPECT_EQ(gaps, 0) << view.pixels_per_mm;
  }
}

TEST(Raster, ACutShowsTheFaceWhereItWent) {
  View view;
  view.towards = Point(1, -1, 1).normalized();
  view.right = Point(1, 1, 0).normalized();
  view.up = view.towards.cross(view.right);
  view.pixels_per_mm = 4.0;
  view.width = 400;
  view.height = 400;
  Raster raster(view, CutOpen{5.0, -5.0});
  raster.draw(box({-20, -20, -20}, {20, 20, 20}), {}, true);
  const auto surface_at = [&](const Point& p_M) {
    const Seen seen = view.seen(p_M);
    return raster.depth_at(seen.x, seen.y) - seen.depth;
  };
  EXPECT_NEAR(surface_at({5, -12, 3}), 0.0, 0.5) << "the face across X";
  EXPECT_NEAR(surface_at({12, -5, -8}), 0.0, 0.5) << "the face across Y";
  EXPECT_NEAR(surface_at({0, 0, 20}), 0.0, 0.5) << "the top that is left";
  EXPECT_LT(surface_at({20, -20, 20}), -10.0) << "the corner is gone";
}

TEST(Png, HoldsItsPixels) {
  const std::string pixels = {1, 2, 3, 10, 20, 30, 7, 7, 7, 0, 0, 0};
  const std::string file = png_of(2, 2, pixels);
  const auto data = file.find("IDAT");
  ASSERT_NE(data, std::string::npos);
  std::array<unsigned char, 14> rows = {};
  uLongf size = rows.size();
  ASSERT_EQ(uncompress(rows.data(), &size, reinterpret_cast<const Bytef*>(file.data() + data + 4),
                       file.size() - data - 4 - 16),
            Z_OK);
  // Each row: the filter that takes off the pixel before.
  EXPECT_EQ(rows,
            (std::array<unsigned char, 14>{1, 1, 2, 3, 9, 18, 27, 1, 7, 7, 7, 249, 249, 249}));
}

}  // namespace
}  // namespace g31::picture::still_test
