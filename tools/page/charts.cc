#include "tools/page/charts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tools/page/html.h"
#include "tools/page/said.h"

namespace g31::page {
namespace {

constexpr double kWidth = 560.0;
constexpr double kHeight = 220.0;
constexpr double kLeft = 64.0;
constexpr double kRight = 16.0;
constexpr double kTop = 14.0;
constexpr double kBottom = 30.0;

/// What values a drawing must show, a little more on both sides.
struct Span {
  double least = 0.0;
  double most = 0.0;

  explicit Span(const Readings& readings) {
    std::vector<double> all = readings.values;
    all.insert(all.end(), readings.published.begin(), readings.published.end());
    if (readings.known) {
      all.push_back(*readings.known);
    }
    if (readings.mean && readings.deviation) {
      all.push_back(*readings.mean - 2.0 * *readings.deviation);
      all.push_back(*readings.mean + 2.0 * *readings.deviation);
    }
    const auto [low, high] = std::ranges::minmax(all);
    const double room = high > low ? (high - low) * 0.06 : std::max(std::abs(high) * 1e-6, 1e-6);
    least = low - room;
    most = high + room;
  }
  [[nodiscard]] double share(double value) const { return (value - least) / (most - least); }
};

/// Decimals that tell two ends of a span apart.
int decimals_for(const Span& span) {
  return std::clamp(static_cast<int>(std::ceil(1.5 - std::log10(span.most - span.least))), 0, 9);
}

std::string text(double x, double y, std::string_view anchor, std::string_view words,
                 std::string_view colour = "--ink2") {
  return fmt::format(
      R"html(<text x="{:.1f}" y="{:.1f}" font-size="11" text-anchor="{}" fill="var({})">{}</text>)html",
      x, y, anchor, colour, escaped(words));
}

/// Where a drawing begins that has numbers of so many letters before it.
double left_of(std::size_t letters) {
  constexpr double kLetter = 7.0;  // as wide as fonts have a digit
  return std::max(kLeft, 10.0 + kLetter * static_cast<double>(letters));
}

std::string opened_svg(std::string_view label) {
  return fmt::format(
      R"(<svg class="fig" style="max-width:44rem" viewBox="0 0 {} {}" role="img" aria-label="{}">)",
      kWidth, kHeight, escaped(label));
}

/// @param what  with a place for their count
std::string labelled(const Readings& readings, Word what, const Span& span, Language language) {
  const int decimals = decimals_for(span);
  std::string label = said(language, what, fmt::arg("count", readings.values.size()));
  if (readings.mean) {
    label += said(language, Word::LabelMean, fmt::arg("value", number(readings.mean, decimals)),
                  fmt::arg("unit", readings.unit));
  }
  if (readings.known) {
    label += said(language, Word::LabelKnown, fmt::arg("value", number(readings.known, decimals)));
  }
  return label;
}

/// A line across the drawing for what is known or was published.
std::string mark(double x1, double y1, double x2, double y2, std::string_view colour,
                 std::string_view dashes) {
  return fmt::format(
      R"html(<path d="M{:.1f} {:.1f}L{:.1f} {:.1f}" stroke="var({})" stroke-width="1.6"{}/>)html",
      x1, y1, x2, y2, colour,
      dashes.empty() ? std::string() : fmt::format(R"( stroke-dasharray="{}")", dashes));
}

std::vector<std::size_t> counted(const Readings& readings, const Span& span) {
  const auto classes = static_cast<std::size_t>(
      std::clamp(std::sqrt(static_cast<double>(readings.values.size())), 5.0, 40.0));
  std::vector<std::size_t> counts(classes, 0);
  for (const double value : readings.values) {
    const auto at = static_cast<std::size_t>(span.share(value) * static_cast<double>(classes));
    ++counts[std::min(at, classes - 1)];
  }
  return counts;
}

}  // namespace

std::string histogram(const Readings& readings, Language language) {
  if (readings.values.empty()) {
    return {};
  }
  const Span span(readings);
  const std::vector<std::size_t> counts = counted(readings, span);
  const std::string most_shown = fmt::format("{}", std::ranges::max(counts));
  const double left = left_of(most_shown.size());
  const auto x = [&](double value) { return left + span.share(value) * (kWidth - left - kRight); };
  const double most = static_cast<double>(std::ranges::max(counts));
  const double floor = kHeight - kBottom;
  const double step = (kWidth - left - kRight) / static_cast<double>(counts.size());
  std::string svg = opened_svg(labelled(readings, Word::LabelHistogram, span, language));
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double height = static_cast<double>(counts[i]) / most * (floor - kTop);
    svg += fmt::format(
        R"html(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="var(--mat3)"/>)html",
        left + static_cast<double>(i) * step + 0.5, floor - height, std::max(step - 1.0, 0.5),
        height);
  }
  svg += mark(left, floor, kWidth - kRight, floor, "--ink3", "");
  svg += text(left - 6.0, kTop + 8.0, "end", most_shown) + text(left - 6.0, floor, "end", "0");
  if (readings.known) {
    svg += mark(x(*readings.known), kTop, x(*readings.known), floor, "--accent", "");
  }
  for (const double value : readings.published) {
    svg += mark(x(value), kTop, x(value), floor, "--warn", "5 3");
  }
  if (readings.mean) {
    svg += mark(x(*readings.mean), kTop, x(*readings.mean), floor, "--ink", "2 2");
  }
  const int decimals = decimals_for(span);
  svg += text(left, kHeight - 10.0, "start", number(span.least, decimals)) +
         text(kWidth - kRight, kHeight - 10.0, "end",
              fmt::format("{} {}", number(span.most, decimals), readings.unit));
  return svg + "</svg>";
}

std::string run_chart(const Readings& readings, Language language) {
  if (readings.values.empty()) {
    return {};
  }
  const Span span(readings);
  const int decimals = decimals_for(span);
  const std::string most_shown = number(span.most, decimals);
  const std::string least_shown = number(span.least, decimals);
  const double left = left_of(std::max(most_shown.size(), least_shown.size()));
  const auto y = [&](double value) {
    return kHeight - kBottom - span.share(value) * (kHeight - kBottom - kTop);
  };
  const double count = static_cast<double>(readings.values.size());
  const auto x = [&](std::size_t i) {
    return left + (static_cast<double>(i) + 0.5) / count * (kWidth - left - kRight);
  };
  std::string svg = opened_svg(labelled(readings, Word::LabelRunChart, span, language));
  if (readings.mean && readings.deviation) {
    const double top = y(*readings.mean + 2.0 * *readings.deviation);
    const double bottom = y(*readings.mean - 2.0 * *readings.deviation);
    svg += fmt::format(
        R"html(<rect x="{:.1f}" y="{:.1f}" width="{:.1f}" height="{:.1f}" fill="var(--mat)"/>)html",
        left, top, kWidth - left - kRight, bottom - top);
    svg += mark(left, y(*readings.mean), kWidth - kRight, y(*readings.mean), "--ink", "2 2");
  }
  if (readings.known) {
    svg += mark(left, y(*readings.known), kWidth - kRight, y(*readings.known), "--accent", "");
  }
  for (const double value : readings.published) {
    svg += mark(left, y(value), kWidth - kRight, y(value), "--warn", "5 3");
  }
  constexpr std::size_t kMostPlaces = 2000;
  const std::size_t stride = (readings.values.size() + kMostPlaces - 1) / kMostPlaces;
  std::string dots;
  for (std::size_t i = 0; i < readings.values.size(); i += stride) {
    const auto here =
        std::span(readings.values).subspan(i).first(std::min(stride, readings.values.size() - i));
    const auto [least, most] = std::ranges::minmax(here);
    dots += fmt::format("M{:.1f} {:.1f}V{:.1f}", x(i), y(least), y(most));
  }
  svg += fmt::format(
      R"html(<path d="{}" stroke="var(--feed)" stroke-width="4" stroke-linecap="round"/>)html",
      dots);
  svg += text(left - 6.0, kTop + 8.0, "end", most_shown) +
         text(left - 6.0, kHeight - kBottom, "end", least_shown) +
         text(left, kHeight - 10.0, "start", "1") +
         text(kWidth - kRight, kHeight - 10.0, "end", fmt::format("{:.0f}", count));
  return svg + "</svg>";
}

}  // namespace g31::page
