#include "tools/picture/still_frame.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace g31::picture {
namespace {

constexpr Palette kLightPalette = {"#ffffff",
                                   "#14181c",
                                   "#626c76",
                                   "#0b57a4",
                                   "#b3261e",
                                   {"#7a848e", "#3d74b3", "#0d7d76"},
                                   {255, 255, 255},
                                   {112, 121, 130},
                                   {{240, 242, 244}, {176, 183, 190}, {250, 250, 247}},
                                   {{226, 229, 233}, {150, 158, 167}, {236, 238, 240}},
                                   {{214, 218, 222}, {120, 128, 137}, {214, 218, 222}},
                                   {{225, 120, 120}, {120, 32, 38}, {225, 120, 120}}};

constexpr Palette kDarkPalette = {"#15181b",
                                  "#e7eaed",
                                  "#929ba4",
                                  "#7fb8f2",
                                  "#ff8d82",
                                  {"#858f98", "#74abe6", "#4fc3b8"},
                                  {21, 24, 27},
                                  {128, 138, 147},
                                  {{78, 86, 94}, {38, 43, 48}, {28, 33, 37}},
                                  {{66, 73, 81}, {32, 36, 41}, {24, 28, 32}},
                                  {{120, 129, 138}, {62, 69, 76}, {120, 129, 138}},
                                  {{214, 104, 104}, {96, 30, 34}, {214, 104, 104}}};

Eigen::AlignedBox3d box_of(const parts::Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Point& p : mesh.vertices) {
    box.extend(p);
  }
  return box;
}

Eigen::AlignedBox3d grown(const Eigen::AlignedBox3d& box, double by) {
  return {box.min() - Point::Constant(by), box.max() + Point::Constant(by)};
}

/// Looks at the middle of a box, which fills the picture but for a margin.
View fitted(View view, const Eigen::AlignedBox3d& box, int width, int height) {
  constexpr double kMarginPixels = 44.0;
  view.width = width;
  view.height = height;
  Eigen::AlignedBox2d shown;
  for (int i = 0; i < 8; ++i) {
    const Point p = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(i));
    shown.extend(Eigen::Vector2d(view.right.dot(p), view.up.dot(p)));
  }
  const Eigen::Vector2d size = shown.sizes().cwiseMax(1.0);
  view.pixels_per_mm =
      std::min((width - 2.0 * kMarginPixels) / size.x(), (height - 2.0 * kMarginPixels) / size.y());
  view.p_M_middle = view.right * shown.center().x() + view.up * shown.center().y() +
                    view.towards * view.towards.dot(box.center());
  return view;
}

Eigen::AlignedBox3d marks_of(const StillScene& scene) {
  Eigen::AlignedBox3d box;
  for (const auto marks : {scene.contacts, scene.collisions}) {
    for (const Mark& mark : marks) {
      box.extend(mark.p_M);
    }
  }
  return box;
}

}  // namespace

const Palette& palette_of(Theme theme) {
  return theme == Theme::Light ? kLightPalette : kDarkPalette;
}

Eigen::AlignedBox3d focus_of(const StillScene& scene) {
  const Eigen::AlignedBox3d marks = marks_of(scene);
  std::set<std::string> touched;
  for (const auto list : {scene.contacts, scene.collisions}) {
    for (const Mark& mark : list) {
      touched.insert(mark.part);
    }
  }
  Eigen::AlignedBox3d parts;
  for (const PicturedPart& part : scene.parts) {
    if (touched.empty() ? !part.is_fixture : touched.contains(part.name)) {
      parts.extend(box_of(*part.mesh_M));
    }
  }
  if (!marks.isEmpty()) {
    // Of a table only what lies about the touches.
    constexpr double kLeastAboutMm = 80.0;
    const Eigen::AlignedBox3d about =
        grown(marks, std::max(kLeastAboutMm, 2.0 * marks.sizes().maxCoeff()));
    Eigen::AlignedBox3d shown = parts.isEmpty() ? about : parts.intersection(about);
    shown.extend(marks);
    return shown;
  }
  if (parts.isEmpty()) {
    for (const Way& way : scene.ways) {
      for (const Point& p : way.points) {
        parts.extend(p);
      }
    }
  }
  return parts.isEmpty() ? grown(Eigen::AlignedBox3d(scene.last.p_M), 20.0) : parts;
}

View isometric_view(const StillScene& scene, int width, int height) {
  View view;
  view.towards = Point(1.0, -1.0, 1.0).normalized();
  view.right = Point(1.0, 1.0, 0.0).normalized();
  view.up = view.towards.cross(view.right);
  Eigen::AlignedBox3d box = focus_of(scene);
  if (scene.tip_radius_mm > 0.0) {
    // Stem and way in from above.
    const double above = std::max(4.0 * scene.tip_radius_mm, 0.4 * box.sizes().maxCoeff());
    box.extend(Point(box.max() + Point(0.0, 0.0, above)));
  }
  return fitted(view, box, width, height);
}

View plan_view(const StillScene& scene, int width, int height) {
  Point along = Point::Zero();
  for (const Mark& mark : scene.contacts) {
    along += mark.n_M.cwiseAbs();
  }
  constexpr double kShare = 0.05;  // less is the slope of a surface, not a direction of touches
  const auto uses = [&](Eigen::Index axis) { return along[axis] > kShare * along.sum(); };
  View view;
  if (!scene.has_y) {
    view = {Point::UnitZ(), Point::UnitX(), Point::UnitY()};
  } else if (uses(2) && uses(0) && !uses(1)) {
    view = {Point::UnitX(), Point::UnitZ(), -Point::UnitY()};
  } else if (uses(2) && uses(1) && !uses(0)) {
    view = {Point::UnitY(), Point::UnitZ(), Point::UnitX()};
  }
  return fitted(view, focus_of(scene), width, height);
}

std::string plane_of(const View& view) {
  const auto letter = [](const Point& direction) {
    Eigen::Index axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    return std::string(1, "XYZ"[axis]);
  };
  return letter(view.right) + letter(view.up);
}

Raster raster_of_parts(const StillScene& scene, const View& view, std::optional<CutOpen> cut,
                       const Palette& palette) {
  Raster raster(view, cut);
  for (const PicturedPart& part : scene.parts) {
    raster.draw(*part.mesh_M, part.is_fixture ? palette.fixture : palette.part, true);
  }
  return raster;
}

std::optional<CutOpen> cut_for(const StillScene& scene, const View& view) {
  if (scene.contacts.empty() && scene.collisions.empty()) {
    return std::nullopt;
  }
  const Palette& palette = palette_of(Theme::Light);
  const double pixel_mm = 1.0 / view.pixels_per_mm;
  const auto is_hidden = [&](const Raster& raster, const Mark& mark) {
    return !raster.shows(view.seen(mark.p_M + pixel_mm * mark.n_M), pixel_mm);
  };
  const auto hidden_by_part = [&](const Raster& raster) {
    std::map<std::string, std::vector<const Mark*>> hidden;
    for (const auto list : {scene.contacts, scene.collisions}) {
      for (const Mark& mark : list) {
        if (is_hidden(raster, mark)) {
          hidden[mark.part].push_back(&mark);
        }
      }
    }
    return hidden;
  };
  const auto whole = hidden_by_part(raster_of_parts(scene, view, std::nullopt, palette));
  const auto most =
      std::ranges::max_element(whole, {}, [](const auto& entry) { return entry.second.size(); });
  if (most == whole.end()) {
    return std::nullopt;
  }
  Eigen::AlignedBox3d box;
  for (const auto list : {scene.contacts, scene.collisions}) {
    for (const Mark& mark : list) {
      if (mark.part == most->first) {
        box.extend(mark.p_M);
      }
    }
  }
  const CutOpen cut = {box.center().x(), box.center().y()};
  const auto left = hidden_by_part(raster_of_parts(scene, view, cut, palette));
  const auto found = left.find(most->first);
  return found == left.end() || found->second.size() < most->second.size() ? std::optional(cut)
                                                                           : std::nullopt;
}

}  // namespace g31::picture
