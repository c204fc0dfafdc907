#include "tools/report/run_recorder.h"

#include <filesystem>

namespace g31::report {

Place place_of(const source::Location& where) {
  if (where.file == nullptr) {
    return {};
  }
  const source::LineColumn start = where.file->line_column(where.span.begin);
  return {std::filesystem::path(where.file->name()).filename().string(), start.line, start.column};
}

}  // namespace g31::report
