#pragma once

#include <span>
#include <string>
#include <string_view>

#include <Eigen/Core>
#include <fmt/format.h>

#include "tools/plot/growth.h"
#include "tools/plot/language.h"

namespace g31::plot {

/// Where a text stands beside its point.
enum class Anchor { Start, Middle, End };

/// A drawing that is written piece by piece; pixels, y downwards.
///
/// Colours are classes of one style sheet, with a second set for readers that prefer dark: `ink`,
/// `faint` (text), `frame`, `grid`, `nominal`, `line0` to `line3`, `fill0` to `fill3`.  The same
/// calls give the same bytes.
class Svg {
 public:
  /// @param language  of the texts, so that readers choose and speak the letters of it
  Svg(double width, double height, std::string_view title, Language language = Language::English,
      Growth growth = {});

  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, std::string_view style);
  /// A line through points.
  void way(std::span<const Eigen::Vector2d> points, std::string_view style);
  /// A closed outline, its inside filled.
  void area(std::span<const Eigen::Vector2d> corners, std::string_view style);
  void dot(const Eigen::Vector2d& at, double radius, std::string_view style);
  /// A filled arrow head whose tip is at a point.
  void arrow(const Eigen::Vector2d& tip, const Eigen::Vector2d& along, std::string_view style);
  void text(const Eigen::Vector2d& at, std::string_view words, Anchor anchor = Anchor::Start,
            std::string_view style = "ink");
  /// Reads upwards, its middle at a point.
  void text_upwards(const Eigen::Vector2d& at, std::string_view words);

  /// What comes until end_window() is shown within a rectangle only.
  void begin_window(const Eigen::Vector2d& top_left, const Eigen::Vector2d& size);
  void end_window();

  /// The whole drawing.
  [[nodiscard]] std::string finish() const;

 private:
  template <typename... Values>
  void add(fmt::format_string<const Values&...> piece, const Values&... values);

  std::string text_;
  Growth growth_;
};

}  // namespace g31::plot
