#include "tools/evaluate/data_error.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/args.h>
#include <fmt/format.h>

#include "interpreter/source/printable.h"
#include "machine/base/utf_8.h"

namespace g31::evaluate {
namespace {

constexpr auto kDataErrorRows = std::to_array<DataErrorRow>({
#define DATA_ERROR(name, code, text) {code, text},
#include "tools/evaluate/data_errors.def"
#undef DATA_ERROR
});

constexpr std::size_t kLongestDetail = 200;

std::string shown(std::string_view detail) {
  return detail.size() <= kLongestDetail
             ? source::printable(detail)
             : source::printable(detail.substr(0, kLongestDetail)) + "...";
}

}  // namespace

std::span<const DataErrorRow> data_error_rows() {
  return kDataErrorRows;
}

char line_end_of(std::string_view text) {
  return text.find('\n') != std::string_view::npos ? '\n' : '\r';
}

DataError data_error(DataErrorId id, const DataFile& file, DataPlace place,
                     std::initializer_list<std::string_view> details, std::string remedy) {
  const DataErrorRow& row = kDataErrorRows.at(static_cast<std::size_t>(id));
  fmt::dynamic_format_arg_store<fmt::format_context> words;
  for (const std::string_view detail : details) {
    words.push_back(shown(detail));
  }
  DataError error;
  error.file = file.name;
  error.message = fmt::vformat(row.text, words);
  error.code = row.code;
  error.remedy = std::move(remedy);
  if (place.line > 0) {
    const char line_end = line_end_of(file.text);
    const std::size_t at = std::min(place.offset, file.text.size());
    const std::size_t break_before =
        at == 0 ? std::string_view::npos : file.text.rfind(line_end, at - 1);
    const std::size_t first = file.text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
    const std::size_t begin =
        break_before == std::string_view::npos ? std::min(first, at) : break_before + 1;
    const std::size_t end = std::min(file.text.find(line_end, at), file.text.size());
    error.line = static_cast<int>(place.line);
    error.column = column_behind(file.text.substr(begin, at - begin));
    error.source_line = file.text.substr(begin, end - begin);
  }
  return error;
}

DataPlace place_of_line(const DataFile& file, std::size_t line) {
  const char line_end = line_end_of(file.text);
  std::size_t offset = 0;
  for (std::size_t i = 1; i < line; ++i) {
    offset = file.text.find(line_end, offset) + 1;
  }
  return {line, offset};
}

}  // namespace g31::evaluate
