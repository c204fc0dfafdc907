// CONTOUR_NOTE and what goes with it: how CYCLE95 learns where a contour runs.

#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/run/procedures.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"

namespace g31::sinumerik {
namespace {

using path::PlaneWay;

constexpr int kColumns = 7;
constexpr double kLine = 1.0;
constexpr double kClockwise = 2.0;
constexpr double kCounterclockwise = 3.0;

MaybeFailure is_contour_table(const VariableView& table) {
  const bool fits = table.shape.dimensions == 2 && table.shape.size[1] == kColumns;
  return fits ? std::nullopt
              : MaybeFailure(failure(AlarmId::WrongDimension, "a table of a contour is [n,7]"));
}

double* row_of(const VariableView& table, std::size_t row) {
  return table.numbers + row * kColumns;
}

/// Writes ways as rows; how many there are goes to a variable.
MaybeFailure fill_table(Operands& at, const VariableView& table, const std::vector<PlaneWay>& ways,
                        const Argument& count, double mm_per_length) {
  if (ways.size() > static_cast<std::size_t>(table.shape.size[0])) {
    return failure(AlarmId::ContourTooLong,
                   fmt::format("{} ways, {} rows", ways.size(), table.shape.size[0]));
  }
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const PlaneWay& way = ways[i];
    double* const row = row_of(table, i);
    row[0] = !way.arc                                    ? kLine
             : way.arc->turn == machine::Turn::Clockwise ? kClockwise
                                                         : kCounterclockwise;
    const path::PlanePoint centre = way.arc ? way.arc->centre : path::PlanePoint(0.0, 0.0);
    int column = 1;
    for (const path::PlanePoint& point : {way.from, way.to, centre}) {
      row[column++] = point.x() / mm_per_length;
      row[column++] = point.y() / mm_per_length;
    }
  }
  return at.assign(count, static_cast<double>(ways.size()));
}

/// A program may have written the table: only what a contour can be is one.
bool is_way(const PlaneWay& way, double kind) {
  constexpr double kFarthest = 1e9;
  constexpr double kSameRadius = 1e-3;
  const auto is_near = [](const path::PlanePoint& p) { return p.norm() < kFarthest; };
  if (!is_near(way.from) || !is_near(way.to)) {
    return false;
  }
  if (!way.arc) {
    return kind == kLine;
  }
  const double radius = (way.from - way.arc->centre).norm();
  return (kind == kClockwise || kind == kCounterclockwise) && is_near(way.arc->centre) &&
         radius > path::kOnePointMm &&
         std::abs(radius - (way.to - way.arc->centre).norm()) < kSameRadius;
}

PlaneWay way_of(const double* row, double mm_per_length) {
  const auto point = [&](int column) {
    return path::PlanePoint(row[column] * mm_per_length, row[column + 1] * mm_per_length);
  };
  PlaneWay way{point(1), point(3), std::nullopt};
  if (row[0] != kLine) {
    way.arc = path::ArcShape{point(5), row[0] == kClockwise ? machine::Turn::Clockwise
                                                            : machine::Turn::Counterclockwise};
  }
  return way;
}

}  // namespace

MaybeFailure Calls::call_part(const std::string& first, const std::string& last) {
  std::optional<std::int32_t> begin;
  std::optional<std::int32_t> end;
  std::size_t which = stack_.depth();
  while (!end && which-- > 0) {
    const auto [program, step] = stack_.level(which).own_place();
    begin = find_label(*program, upper(first), step, Direction::Both);
    end = begin ? find_label(*program, upper(last), *begin, Direction::Forward) : std::nullopt;
  }
  if (!end) {
    return failure(AlarmId::JumpTargetMissing, fmt::format("{} to {}", first, last));
  }
  if (stack_.is_full()) {
    return failure(AlarmId::TooManyLevels, first);
  }
  Level& into = stack_.next();
  into = stack_.level(which);
  into.leave_texts();
  into.passes_left = 0;
  into.is_modal_call = false;
  into.step = *begin;
  const std::int32_t behind = into.program->ops[static_cast<std::size_t>(*end)].a.place;
  into.parts.assign(1, {RunningPart::kWholeLevel, behind, 0, 1});
  begin_level(into);
  return std::nullopt;
}

namespace procedure {

/// CONTOUR_NOTE
MaybeFailure begin_noting(Channel& channel, Operands& /*at*/, Arguments /*list*/) {
  return begin_contour(channel);
}

/// CONTOUR_TAKE(table, count)
MaybeFailure take_noted(Channel& channel, Operands& at, Arguments list) {
  const VariableView table = at.variable(list[0].variable);
  if (MaybeFailure wrong = is_contour_table(table)) {
    return wrong;
  }
  const auto ways = end_contour(channel);
  return ways ? fill_table(at, table, ways.value(), list[1], channel.mm_per_length())
              : MaybeFailure(ways.error());
}

/// CONTOUR_OFFSET(table, n, left, count)
MaybeFailure offset_noted(Channel& channel, Operands& at, Arguments list) {
  const VariableView table = at.variable(list[0].variable);
  if (MaybeFailure wrong = is_contour_table(table)) {
    return wrong;
  }
  const double count = rounded(at.number(list[1]));
  if (!(count >= 1.0 && count <= table.shape.size[0])) {
    return failure(AlarmId::ValueOutOfLimits, fmt::format("CONTOUR_OFFSET: {:g} rows", count));
  }
  const double mm = channel.mm_per_length();
  std::vector<PlaneWay> ways;
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const double* const row = row_of(table, i);
    ways.push_back(way_of(row, mm));
    const bool goes_on = i == 0 || (ways[i].from - ways[i - 1].to).norm() < path::kOnePointMm;
    if (!is_way(ways[i], row[0]) || !goes_on) {
      return failure(AlarmId::ValueOutOfLimits,
                     fmt::format("CONTOUR_OFFSET: row {} is no way that goes on", i));
    }
  }
  const auto beside = contour_beside(ways, at.number(list[2]) * mm);
  return beside ? fill_table(at, table, beside.value(), list[3], mm) : MaybeFailure(beside.error());
}

/// CONTOUR_PART(first, last)
MaybeFailure call_part(Calls& calls, Operands& at, Arguments list) {
  return calls.call_part(at.text(list[0].value), at.text(list[1].value));
}

}  // namespace procedure
}  // namespace g31::sinumerik
