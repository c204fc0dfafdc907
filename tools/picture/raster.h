#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "parts/geometry/mesh.h"
#include "tools/picture/view.h"

namespace g31::picture {

struct Rgb {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;

  bool operator==(const Rgb&) const = default;
};

/// What a surface looks like.
struct Material {
  Rgb light;  ///< where it faces the light
  Rgb dark;   ///< where it faces away from it
  Rgb cut;    ///< where it is cut open

  bool operator==(const Material&) const = default;
};

/// Solid bodies as a viewer sees them, drawn facet by facet with a depth for each pixel.
class Raster {
 public:
  Raster(const View& view, std::optional<CutOpen> cut);

  /// Pieces that look alike, one behind the other, are one body without lines between them.
  /// @param cut_open  whether the cut goes through it, as through parts, which are bodies each
  void draw(const parts::Mesh& mesh_M, const Material& material, bool cut_open);

  /// The depth of the surface at a pixel, mm; minus infinity: there is none.  Outside the picture
  /// there is none.
  [[nodiscard]] double depth_at(double x, double y) const;
  /// Whether nothing stands before a point, within so much.
  [[nodiscard]] bool shows(const Seen& point, double slack_mm) const;

  /// The picture with lines where surfaces end or bend, half as many pixels each way; rows from the
  /// top, three bytes a pixel.
  /// @param depth_tone  0 to 1: how much darker the lowest surface is than the highest one
  [[nodiscard]] std::string pixels(Rgb paper, Rgb line, double depth_tone) const;

  [[nodiscard]] const View& view() const { return view_; }

 private:
  struct Fragment {
    double depth;
    std::uint16_t material;  // 0: nothing
    std::uint8_t shade;
    bool from_behind;
  };
  /// How pixels become colours.
  struct Tones {
    Rgb paper;
    Rgb line;
    double highest;
    double per_mm;  // darker
  };
  struct Pen {
    std::uint16_t material;
    std::uint8_t shade;
    bool faces_away;
    bool cut_open;
  };

  void draw(const Point& a, const Point& b, const Point& c, const Pen& pen);
  void put(int x, int y, double depth, const Pen& pen);
  void settle();
  [[nodiscard]] Tones tones(Rgb paper, Rgb line, double depth_tone) const;
  [[nodiscard]] Point place_of(int x, int y, double depth) const;
  [[nodiscard]] const Fragment& at(int x, int y) const {
    return fragments_[static_cast<std::size_t>(y) * static_cast<std::size_t>(view_.width) +
                      static_cast<std::size_t>(x)];
  }
  [[nodiscard]] bool is_line(int x, int y) const;
  [[nodiscard]] Rgb colour(int x, int y, const Tones& tones) const;

  View view_;
  std::optional<CutOpen> cut_;
  Point light_;
  std::vector<Material> materials_;
  std::vector<Fragment> fragments_;
};

}  // namespace g31::picture
