#include "tools/check/extent.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

#include "interpreter/source/printable.h"
#include "interpreter/source/readable_text.h"

namespace g31::check {
namespace {

/// Of a program whose blocks all stand on one line the line would come with each finding.
std::string text_of_line(const source::ShownPlace& place) {
  constexpr std::size_t kMostBytes = 1000;
  const std::string_view line = place.text;
  const std::string_view shown = line.substr(0, kMostBytes);
  const auto writing = source::writing_of(line);
  return source::printable(writing == source::Writing::ShiftJis ? source::read_as(writing, shown)
                                                                : std::string(shown));
}

}  // namespace

Extent extent_of(const analysis::Finding& finding, const source::SourceMap& sources) {
  const source::ShownPlace place = sources.show(finding.where);
  const std::string_view line = place.text;
  const int end = source::column_in(line, bytes_before(place) + finding.where.length);
  return {place.file,         place.line, place.column, place.line, std::max(end, place.column + 1),
          text_of_line(place)};
}

Extent extent_of(const analysis::Edit& edit, const source::SourceMap& sources) {
  const source::ShownPlace begin = sources.show(edit.where);
  const source::ShownPlace end =
      sources.show({edit.where.file, 0, edit.where.begin + edit.where.length});
  return {begin.file, begin.line, begin.column, end.line, end.column, text_of_line(begin)};
}

}  // namespace g31::check
