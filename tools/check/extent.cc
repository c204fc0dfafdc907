#include "tools/check/extent.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "interpreter/source/printable.h"

namespace g31::check {
namespace {

/// @param bytes  of the line before the column
int column_of(std::string_view line, std::size_t bytes) {
  return 1 + static_cast<int>(source::character_count(source::printable(line.substr(0, bytes))));
}

/// Of a program whose blocks all stand on one line the line would come with each finding.
std::string text_of_line(const source::ShownPlace& place) {
  constexpr std::size_t kMostBytes = 1000;
  return source::printable(std::string_view(place.text).substr(0, kMostBytes));
}

std::size_t bytes_before(const source::ShownPlace& place) {
  return static_cast<std::size_t>(std::max(place.column, 1)) - 1;
}

}  // namespace

Extent extent_of(const analysis::Finding& finding, const source::SourceMap& sources) {
  const source::ShownPlace place = sources.show(finding.where);
  const std::size_t before = bytes_before(place);
  const int column = column_of(place.text, before);
  const int end = column_of(place.text, before + finding.where.length);
  return {place.file,         place.line, column, place.line, std::max(end, column + 1),
          text_of_line(place)};
}

Extent extent_of(const analysis::Edit& edit, const source::SourceMap& sources) {
  const source::ShownPlace begin = sources.show(edit.where);
  const source::ShownPlace end =
      sources.show({edit.where.file, 0, edit.where.begin + edit.where.length});
  return {begin.file,
          begin.line,
          column_of(begin.text, bytes_before(begin)),
          end.line,
          column_of(end.text, bytes_before(end)),
          text_of_line(begin)};
}

}  // namespace g31::check
