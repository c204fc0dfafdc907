#pragma once

#include <string>
#include <utility>
#include <vector>

#include "tools/picture/still_frame.h"

namespace g31::picture {

/// One of the views of a still: its bodies as a picture, the lines and words on it as SVG.
class StillView {
 public:
  /// What it shows beside bodies, ways and touches.
  struct Extras {
    bool stylus = false;    ///< with stem and body; else the ball alone, as a circle
    bool whiskers = false;  ///< how much deeper than the wall each ball was latched
  };

  StillView(const StillScene& scene, const View& view, std::optional<CutOpen> cut,
            const Palette& palette, Extras extras);

  /// Elements of SVG in pixels of the view.
  [[nodiscard]] const std::string& svg() const { return svg_; }
  /// By how much the whiskers are magnified; 0: there are none.
  [[nodiscard]] double magnification() const { return magnification_; }

 private:
  struct Room {
    Eigen::Vector2d low;
    Eigen::Vector2d high;
  };
  /// Touches whose places are one in the picture.
  struct Group {
    Seen seen;
    std::vector<const Mark*> marks;
  };

  void draw_bodies();
  void draw_edges();
  void draw_ways();
  void draw_kind(PathKind kind);
  void draw_balls();
  void find_groups();
  void draw_whiskers();
  void draw_touches();
  void draw_collisions();
  void draw_names();
  void draw_axes();
  void draw_scale();
  void add_line(const Seen& from, const Seen& to, std::string_view seen_class,
                std::string_view hidden_class);
  /// Words in a free place near a point, with a line to it.
  void label(const Eigen::Vector2d& at, const Eigen::Vector2d& wish, const std::string& words,
             std::string_view style);
  [[nodiscard]] bool is_free(const Room& room) const;
  [[nodiscard]] bool is_visible(const Seen& seen) const;
  [[nodiscard]] std::optional<double> deviation_mm(const Mark& mark) const;

  const StillScene& scene_;
  View view_;
  std::optional<CutOpen> cut_;
  const Palette& palette_;
  Extras extras_;
  Raster raster_;
  double slack_mm_;
  std::vector<Group> groups_;
  std::vector<Room> taken_;
  double magnification_ = 0.0;
  std::string svg_;
};

}  // namespace g31::picture
