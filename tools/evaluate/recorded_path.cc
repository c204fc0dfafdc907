#include "tools/evaluate/recorded_path.h"

#include <algorithm>

#include <fmt/format.h>

namespace g31::evaluate {
namespace {

bool needs_time(const Request& request) {
  return !request.interval_s && request.kind != Kind::Diagonal;
}

std::vector<WantedColumn> wanted_columns(const Request& request) {
  std::vector<WantedColumn> wanted;
  for (const std::string& axis : request.plane) {
    wanted.push_back({axis, ColumnKind::Length, axis + "_true"});
  }
  if (needs_time(request)) {
    wanted.push_back({"t", ColumnKind::Number, "time_s", false,
                      "--interval is the time from row to row of a file without one"});
  } else if (request.interval_s) {
    wanted.push_back({"t", ColumnKind::Text, "time_s", true});
  }
  return wanted;
}

}  // namespace

std::optional<Eigen::Vector2d> point_of(const std::optional<Pair>& pair) {
  return pair ? std::optional(Eigen::Vector2d((*pair)[0], (*pair)[1])) : std::nullopt;
}

Result<RecordedPath, DataError> read_path(const DataFile& file, const Request& request) {
  auto table = read_table(file, wanted_columns(request), request.columns);
  if (!table) {
    return table.error();
  }
  const auto& x = table.value().numbers(request.plane[0]);
  const auto& y = table.value().numbers(request.plane[1]);
  RecordedPath path;
  path.watch = file.watch;
  path.resolution = std::max(table.value().resolution(request.plane[0]),
                             table.value().resolution(request.plane[1]));
  if (!needs_time(request)) {
    path.x = x;
    path.y = y;
    if (!request.interval_s) {
      return path;
    }
    if (table.value().has("t")) {
      return data_error(DataErrorId::CannotEvaluate, file, {},
                        {"it has a column t: --interval is for a file without one"});
    }
    path.t.reserve(x.size());
    for (std::size_t i = 0; i < x.size(); ++i) {
      path.t.push_back(static_cast<double>(i) * *request.interval_s);
    }
    return path;
  }
  const auto& t = table.value().numbers("t");
  path.t.reserve(t.size());
  path.x.reserve(t.size());
  path.y.reserve(t.size());
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (i > 0 && t[i] <= t[i - 1]) {
      if (t[i] == t[i - 1] && x[i] == x[i - 1] && y[i] == y[i - 1]) {
        continue;
      }
      return data_error(DataErrorId::TimeNotRising, file,
                        place_of_line(file, table.value().line(i)),
                        {"t", fmt::format("{}", t[i]), fmt::format("{}", t[i - 1])});
    }
    path.t.push_back(t[i]);
    path.x.push_back(x[i]);
    path.y.push_back(y[i]);
  }
  return path;
}

}  // namespace g31::evaluate
