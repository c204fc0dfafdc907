#include "tools/picture/raster.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>

#include "parts/geometry/facet_normal.h"

namespace g31::picture {
namespace {

constexpr double kNothing = -std::numeric_limits<double>::infinity();
/// How a face of the cut is told from a surface: two shades, one for each plane.
constexpr std::uint8_t kCutX = 1;
constexpr std::uint8_t kCutY = 2;
/// Of a material: its cut face.
constexpr unsigned kCutFace = 0x8000U;
constexpr int kHatchPixels = 14;
/// Surfaces that are no further apart lie in one plane: the first one is seen, without a line.
constexpr double kOneDepthMm = 1e-6;

Rgb mixed(Rgb a, Rgb b, double share) {
  const auto mix = [share](std::uint8_t from, std::uint8_t to) {
    return static_cast<std::uint8_t>(std::lround(from + share * (to - from)));
  };
  return {mix(a.r, b.r), mix(a.g, b.g), mix(a.b, b.b)};
}

/// The columns of a row that a triangle covers.
struct Span {
  double first;
  double last;

  /// Only where a number that grows by `step` with each column is not negative.  A pixel on the
  /// edge of two triangles is of both, so that rounding leaves no gap between them.
  void keep(double at_zero, double step) {
    constexpr double kSlack = 1e-6;  // columns
    if (step > 0.0) {
      first = std::max(first, std::ceil(-at_zero / step - kSlack));
    } else if (step < 0.0) {
      last = std::min(last, std::floor(-at_zero / step + kSlack));
    } else if (at_zero < -kSlack) {
      last = first - 1.0;
    }
  }
};

/// Twice the area that three points span, positive with y downwards and clockwise.
double area(const Seen& a, const Seen& b, double x, double y) {
  return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

}  // namespace

Raster::Raster(const View& view, std::optional<CutOpen> cut)
    : view_(view),
      cut_(cut),
      light_((0.55 * view.towards + 0.75 * Point::UnitZ() - 0.35 * view.right).normalized()),
      materials_(1),
      fragments_(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height),
                 {kNothing, 0, 0, false}) {}

void Raster::draw(const parts::Mesh& mesh_M, const Material& material, bool cut_open) {
  const bool is_first = materials_.size() == 1;  // which is the paper
  if (is_first || cut_open || materials_.back() != material) {
    materials_.push_back(material);
  }
  const auto number = static_cast<std::uint16_t>(materials_.size() - 1);
  for (std::uint32_t t = 0; t < mesh_M.triangles.size(); ++t) {
    const auto n = parts::facet_normal(mesh_M, t);
    if (!n) {
      continue;
    }
    const bool faces_away = n->dot(view_.towards) < 0.0;
    const double lit = std::max(0.0, (faces_away ? -1.0 : 1.0) * n->dot(light_));
    const auto& corners = mesh_M.triangles[t];
    draw(mesh_M.vertices[corners[0]], mesh_M.vertices[corners[1]], mesh_M.vertices[corners[2]],
         {number, static_cast<std::uint8_t>(std::lround(255.0 * lit)), faces_away,
          cut_open && cut_.has_value()});
  }
  if (cut_open && cut_) {
    settle();
  }
}

void Raster::draw(const Point& a, const Point& b, const Point& c, const Pen& pen) {
  const Seen p = view_.seen(a);
  const Seen q = view_.seen(b);
  const Seen r = view_.seen(c);
  const double whole = area(p, q, r.x, r.y);
  if (whole == 0.0) {
    return;
  }
  const auto first = [](double least) { return std::max(0.0, std::ceil(least - 0.5)); };
  const auto last = [](double most, int size) { return std::min(size - 1.0, most - 0.5); };
  const Span all = {first(std::min({p.x, q.x, r.x})), last(std::max({p.x, q.x, r.x}), view_.width)};
  const double y_last = last(std::max({p.y, q.y, r.y}), view_.height);
  const auto [lowest, highest] = std::minmax({p.depth, q.depth, r.depth});
  const double u_step = (q.y - r.y) / whole;
  const double v_step = (r.y - p.y) / whole;
  for (double y = first(std::min({p.y, q.y, r.y})); y <= y_last; ++y) {
    const double u = area(q, r, 0.5, y + 0.5) / whole;
    const double v = area(r, p, 0.5, y + 0.5) / whole;
    Span row = all;
    row.keep(u, u_step);
    row.keep(v, v_step);
    row.keep(1.0 - u - v, -u_step - v_step);
    for (double x = row.first; x <= row.last; ++x) {
      const double u_here = u + x * u_step;
      const double v_here = v + x * v_step;
      const double w_here = 1.0 - u_here - v_here;
      put(static_cast<int>(x), static_cast<int>(y),
          std::clamp(u_here * p.depth + v_here * q.depth + w_here * r.depth, lowest, highest), pen);
    }
  }
}

void Raster::put(int x, int y, double depth, const Pen& pen) {
  Fragment& here = fragments_[static_cast<std::size_t>(y) * static_cast<std::size_t>(view_.width) +
                              static_cast<std::size_t>(x)];
  if (depth <= here.depth + kOneDepthMm || (pen.cut_open && cut_->removes(place_of(x, y, depth)))) {
    return;
  }
  here = {depth, pen.material, pen.shade, pen.cut_open && pen.faces_away};
}

Point Raster::place_of(int x, int y, double depth) const {
  return view_.p_M_middle + (x + 0.5 - 0.5 * view_.width) / view_.pixels_per_mm * view_.right -
         (y + 0.5 - 0.5 * view_.height) / view_.pixels_per_mm * view_.up + depth * view_.towards;
}

/// Where the inside of a body is seen, the ray has entered it through the cut: there its face is.
void Raster::settle() {
  for (int y = 0; y < view_.height; ++y) {
    for (int x = 0; x < view_.width; ++x) {
      Fragment& here =
          fragments_[static_cast<std::size_t>(y) * static_cast<std::size_t>(view_.width) +
                     static_cast<std::size_t>(x)];
      if (!here.from_behind) {
        continue;
      }
      here.from_behind = false;
      const Point p_M = place_of(x, y, here.depth);
      const double to_x = (cut_->x - p_M.x()) / view_.towards.x();
      const double to_y = (cut_->y - p_M.y()) / view_.towards.y();
      here.depth += std::max({0.0, to_x, to_y});
      here.shade = to_x > to_y ? kCutX : kCutY;
      here.from_behind = false;
      here.material = static_cast<std::uint16_t>(here.material | kCutFace);
    }
  }
}

double Raster::depth_at(double x, double y) const {
  const double column = std::floor(x);
  const double row = std::floor(y);
  if (!(column >= 0.0 && row >= 0.0 && column < view_.width && row < view_.height)) {
    return kNothing;
  }
  return at(static_cast<int>(column), static_cast<int>(row)).depth;
}

bool Raster::shows(const Seen& point, double slack_mm) const {
  return point.depth >= depth_at(point.x, point.y) - slack_mm;
}

/// A surface ends here, or bends: lines are some three pixels wide, of which two make one.
bool Raster::is_line(int x, int y) const {
  constexpr int kReach = 3;
  if (x < kReach || y < kReach || x + kReach >= view_.width || y + kReach >= view_.height) {
    return false;
  }
  const Fragment& here = at(x, y);
  const std::array<const Fragment*, 4> around = {&at(x - kReach, y), &at(x + kReach, y),
                                                 &at(x, y - kReach), &at(x, y + kReach)};
  for (const Fragment* const other : around) {
    if (other->material != here.material) {
      return here.depth > other->depth + kOneDepthMm;
    }
  }
  if (here.material == 0) {
    return false;
  }
  const double bend = std::max(std::fabs(around[0]->depth - 2.0 * here.depth + around[1]->depth),
                               std::fabs(around[2]->depth - 2.0 * here.depth + around[3]->depth));
  constexpr double kBend = 1.2;  // how much steeper the surface becomes
  return bend * view_.pixels_per_mm > kBend * kReach;
}

Raster::Tones Raster::tones(Rgb paper, Rgb line, double depth_tone) const {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = kNothing;
  for (const Fragment& fragment : fragments_) {
    if (fragment.material != 0) {
      lowest = std::min(lowest, fragment.depth);
      highest = std::max(highest, fragment.depth);
    }
  }
  return {paper, line, highest, highest > lowest ? depth_tone / (highest - lowest) : 0.0};
}

Rgb Raster::colour(int x, int y, const Tones& tones) const {
  const Fragment& here = at(x, y);
  if (is_line(x, y)) {
    return tones.line;
  }
  if (here.material == 0) {
    return tones.paper;
  }
  const Material& material = materials_[here.material & ~kCutFace];
  if ((here.material & kCutFace) == 0) {
    const double shade = here.shade / 255.0 - (tones.highest - here.depth) * tones.per_mm;
    return mixed(material.dark, material.light, std::clamp(shade, 0.0, 1.0));
  }
  const int along = here.shade == kCutX ? x + y : x - y + kHatchPixels * view_.height;
  return along % kHatchPixels < 2 ? mixed(material.cut, tones.line, 0.45) : material.cut;
}

std::string Raster::pixels(Rgb paper, Rgb line, double depth_tone) const {
  const Tones how = tones(paper, line, depth_tone);
  std::string bytes;
  for (int y = 0; y + 1 < view_.height; y += 2) {
    for (int x = 0; x + 1 < view_.width; x += 2) {
      int r = 2;
      int g = 2;
      int b = 2;
      for (int i = 0; i < 4; ++i) {
        const Rgb part = colour(x + i % 2, y + i / 2, how);
        r += part.r;
        g += part.g;
        b += part.b;
      }
      bytes += {static_cast<char>(r / 4), static_cast<char>(g / 4), static_cast<char>(b / 4)};
    }
  }
  return bytes;
}

}  // namespace g31::picture
