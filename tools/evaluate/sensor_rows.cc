#include "tools/evaluate/sensor_rows.h"

#include <map>

#include <fmt/format.h>

namespace g31::evaluate {
namespace {

/// Of two sensors.
std::vector<WantedColumn> sensor_columns() {
  return {
      {"K", ColumnKind::Number, "", true}, {"A", ColumnKind::Length}, {"B", ColumnKind::Length}};
}

/// A line while it is read.
struct OpenLine {
  SensorLine line;
  std::size_t first_row = 0;
  std::size_t last_row = 0;
};

/// Takes rows one by one and puts each with its line.
class LineBuilder {
 public:
  /// @param has_third  there is a third sensor
  LineBuilder(const DataFile& file, const DataTable& table, Sense sense, bool has_third)
      : file_(file),
        table_(table),
        factor_(sense == Sense::Gap ? -1.0 : 1.0),
        has_third_(has_third) {}

  std::optional<DataError> take(std::size_t row, double key) {
    const double k = table_.has("K") ? table_.numbers("K")[row] : 0.0;
    const auto [found, is_new] = numbers_.try_emplace(key, lines_.size());
    if (is_new) {
      lines_.push_back({{key, {k, {}, {}, {}}}, row, row});
    }
    OpenLine& open = lines_[found->second];
    SensorRows& rows = open.line.rows;
    const double expected = rows.first + static_cast<double>(rows.a.size());
    if (table_.has("K") && k != expected) {
      return data_error(DataErrorId::RowMissing, file_, place_of_line(file_, table_.line(row)),
                        {"K", fmt::format("{}", k), fmt::format("{}", expected)});
    }
    rows.a.push_back(factor_ * table_.numbers("A")[row]);
    rows.b.push_back(factor_ * table_.numbers("B")[row]);
    if (has_third_) {
      rows.c.push_back(factor_ * table_.numbers("C")[row]);
    }
    open.last_row = row;
    return std::nullopt;
  }

  [[nodiscard]] Result<std::vector<SensorLine>, DataError> lines() const {
    std::vector<SensorLine> all;
    const double first = lines_.front().line.rows.first;
    for (const OpenLine& open : lines_) {
      if (open.line.rows.first != first) {
        return data_error(DataErrorId::RowMissing, file_,
                          place_of_line(file_, table_.line(open.first_row)),
                          {"K", fmt::format("{}", open.line.rows.first), fmt::format("{}", first)});
      }
      const std::size_t rows = open.line.rows.a.size();
      const std::size_t expected = lines_.front().line.rows.a.size();
      if (rows != expected || rows < 2) {
        return data_error(
            DataErrorId::CannotEvaluate, file_, place_of_line(file_, table_.line(open.last_row)),
            {rows < 2
                 ? fmt::format("a line needs at least two rows, this one has {}", rows)
                 : fmt::format("this line ends after {} rows, the first has {}", rows, expected)});
      }
      all.push_back(open.line);
    }
    return all;
  }

 private:
  const DataFile& file_;
  const DataTable& table_;
  double factor_;
  bool has_third_;
  std::vector<OpenLine> lines_;
  std::map<double, std::size_t> numbers_;  // of lines by their keys
};

}  // namespace

Result<SensorRows, DataError> read_sensor_rows(const DataFile& file, const Request& request) {
  std::vector<WantedColumn> wanted = sensor_columns();
  wanted.push_back({"C", ColumnKind::Length, "", true});
  const auto table = read_table(file, wanted, request.columns);
  if (!table) {
    return table.error();
  }
  LineBuilder builder(file, table.value(), request.sense, table.value().has("C"));
  for (std::size_t row = 0; row < table.value().size(); ++row) {
    if (auto wrong = builder.take(row, 0.0)) {
      return *wrong;
    }
  }
  const auto lines = builder.lines();
  if (!lines) {
    return lines.error();
  }
  return lines.value().front().rows;
}

Result<std::vector<SensorLine>, DataError> read_sensor_lines(const DataFile& file,
                                                             const Request& request,
                                                             const WantedColumn& key) {
  std::vector<WantedColumn> wanted = sensor_columns();
  wanted.push_back(key);
  const auto table = read_table(file, wanted, request.columns);
  if (!table) {
    return table.error();
  }
  LineBuilder builder(file, table.value(), request.sense, false);
  for (std::size_t row = 0; row < table.value().size(); ++row) {
    if (auto wrong = builder.take(row, table.value().numbers(key.name)[row])) {
      return *wrong;
    }
  }
  return builder.lines();
}

}  // namespace g31::evaluate
