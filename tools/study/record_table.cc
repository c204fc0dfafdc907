#include "tools/study/record_table.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace g31::study {
namespace {

/// Lines of cells, the first left, the others right.
class TextTable {
 public:
  void add(std::vector<std::string> cells) { lines_.push_back(std::move(cells)); }

  [[nodiscard]] std::string text() const {
    std::vector<std::size_t> widths;
    for (const auto& line : lines_) {
      widths.resize(std::max(widths.size(), line.size()));
      for (std::size_t i = 0; i < line.size(); ++i) {
        widths[i] = std::max(widths[i], line[i].size());
      }
    }
    std::string text;
    for (const auto& line : lines_) {
      std::string row;
      for (std::size_t i = 0; i < line.size(); ++i) {
        row += i == 0 ? fmt::format("{:<{}}", line[i], widths[i])
                      : fmt::format("  {:>{}}", line[i], widths[i]);
      }
      row.erase(row.find_last_not_of(' ') + 1);
      text += row + "\n";
    }
    return text;
  }

 private:
  std::vector<std::vector<std::string>> lines_;
};

/// mm to 0.01 um, other units alike; what is less by its first digits, and what is no more than
/// rounding as 0.
std::string shown(const std::optional<double>& number) {
  if (!number) {
    return "-";
  }
  constexpr double kLongest = 1e9;  // more digits say nothing
  if (std::abs(*number) >= kLongest) {
    return fmt::format("{:.5e}", *number);
  }
  constexpr double kRounding = 1e-9;
  const std::string text = fmt::format("{:.5f}", *number);
  if (text.find_first_not_of("-0.") != std::string::npos) {
    return text;
  }
  return std::abs(*number) < kRounding ? fmt::format("{:.5f}", 0.0)
                                       : fmt::format("{:.1e}", *number);
}

std::string shown_difference(const std::optional<double>& a, const std::optional<double>& b) {
  return a && b ? shown(*a - *b) : "-";
}

std::string title_of(const Description& d, std::size_t point) {
  std::string title;
  for (std::size_t i = 0; i < d.listed.size(); ++i) {
    title += fmt::format("{}{} = {}", title.empty() ? "" : ", ", d.listed[i], d.points[point][i]);
  }
  return title;
}

std::string statistics_table(const Record& record, std::size_t point) {
  const Description& d = record.description;
  TextTable table;
  table.add({"result", "unit", "n", "mean", "deviation",
             fmt::format("{}% low", d.confidence_percent),
             fmt::format("{}% high", d.confidence_percent), "U (k=2)", "min", "max", "bias"});
  for (std::size_t i = 0; i < d.results.size(); ++i) {
    const Summary s = summary_of(record, point, i);
    const auto end = [&](double Interval::*which) {
      return s.mean_confidence ? shown((*s.mean_confidence).*which) : "-";
    };
    table.add({d.results[i].name, d.results[i].unit, fmt::format("{}", s.n), shown(s.mean),
               shown(s.standard_deviation), end(&Interval::low), end(&Interval::high),
               shown(s.expanded_uncertainty), shown(s.min), shown(s.max), shown(s.bias)});
  }
  return table.text();
}

/// As table 3 of Hirose's paper: the readings by their number, then mean and standard deviation.
std::string readings_table(const Record& record, std::size_t point) {
  const Description& d = record.description;
  TextTable table;
  std::vector<std::string> head = {"reading"};
  for (const ResultForm& result : d.results) {
    head.push_back(fmt::format("{} [{}]", result.name, result.unit));
  }
  table.add(head);
  for (const Row& row : record.rows) {
    if (row.run / d.repeats != point) {
      continue;
    }
    std::vector<std::string> cells = {fmt::format("{}", row.run % d.repeats + 1)};
    for (const auto& result : row.results) {
      cells.push_back(shown(result));
    }
    table.add(cells);
  }
  std::vector<std::string> means = {"mean"};
  std::vector<std::string> deviations = {"standard deviation"};
  for (std::size_t i = 0; i < d.results.size(); ++i) {
    const Summary s = summary_of(record, point, i);
    means.push_back(shown(s.mean));
    deviations.push_back(shown(s.standard_deviation));
  }
  table.add(means);
  table.add(deviations);
  return table.text();
}

/// As table 4 of Hirose's paper: for each place mean and deviation of both, and their differences.
std::string comparison_table(const Record& record) {
  const Description& d = record.description;
  const std::string& first = d.points.at(0).at(0);
  const std::string& second = d.points.at(1).at(0);
  TextTable table;
  table.add({"place", "size", "tolerance", first, "deviation", second, "deviation", "difference",
             "of deviations"});
  for (std::size_t i = 0; i < d.results.size(); ++i) {
    const ResultForm& result = d.results[i];
    const Summary a = summary_of(record, 0, i);
    const Summary b = summary_of(record, 1, i);
    table.add({result.name, result.nominal, result.tolerance, shown(a.mean),
               shown(a.standard_deviation), shown(b.mean), shown(b.standard_deviation),
               shown_difference(a.mean, b.mean),
               shown_difference(a.standard_deviation, b.standard_deviation)});
  }
  return table.text();
}

/// What others found, each with its distance from the mean in standard deviations.
std::string published_table(const Record& record, std::size_t point) {
  const Description& d = record.description;
  TextTable table;
  table.add({"published", "unit", "value", "from mean", "z"});
  bool is_empty = true;
  for (std::size_t i = 0; i < d.results.size(); ++i) {
    const Summary summary = summary_of(record, point, i);
    for (const double value : d.results[i].published) {
      const auto z = z_score(value, summary);
      table.add({d.results[i].name, d.results[i].unit, shown(value),
                 shown_difference(value, summary.mean), z ? fmt::format("{:+.2f}", *z) : "-"});
      is_empty = false;
    }
  }
  return is_empty ? std::string() : "\n" + table.text();
}

std::string tables(const Record& record) {
  const Description& d = record.description;
  if (d.table == TableForm::Comparison && d.points.size() == 2 && !d.listed.empty()) {
    return comparison_table(record);
  }
  std::string text;
  for (std::size_t point = 0; point < d.points.size(); ++point) {
    if (!d.listed.empty()) {
      text += (point > 0 ? "\n" : "") + title_of(d, point) + "\n";
    }
    if (d.table == TableForm::Readings) {
      text += readings_table(record, point) + "\n";
    }
    text += statistics_table(record, point) + published_table(record, point);
  }
  return text;
}

}  // namespace

std::string record_table(const Record& record) {
  const Description& d = record.description;
  std::string text =
      fmt::format("{}: {} on {}, {} {} of each set-up, seed {}\n\n", d.name, d.program, d.control,
                  d.repeats, d.repeats == 1 ? "run" : "runs", d.seed);
  text += tables(record);
  if (!d.assumes.empty()) {
    text += "\nAssumed:\n";
    for (const std::string& sentence : d.assumes) {
      text += "  * " + sentence + "\n";
    }
  }
  return text;
}

std::string record_warnings(const Record& record) {
  std::string text;
  for (const auto& [status, count] : count_by_status(record)) {
    if (status == "completed") {
      continue;
    }
    const auto first = std::ranges::find(record.rows, status, &Row::status);
    text += fmt::format(
        "{} of {} runs ended with {} and {} left out of the statistics; run {}: {}\n", count,
        record.rows.size(), status, count == 1 ? "is" : "are", first->run + 1, first->note);
  }
  const auto has_findings = [](const Row& row) {
    return row.has_completed() && row.exit_code != 0;
  };
  if (const auto count = std::ranges::count_if(record.rows, has_findings); count > 0) {
    const auto first = std::ranges::find_if(record.rows, has_findings);
    text += fmt::format("{} of {} runs completed with findings; run {}: {}\n", count,
                        record.rows.size(), first->run + 1, first->note);
  }
  for (std::size_t i = 0; i < record.description.results.size(); ++i) {
    const auto vacant = std::ranges::count_if(
        record.rows, [&](const Row& row) { return row.has_completed() && !row.results.at(i); });
    if (vacant > 0) {
      text += fmt::format(
          "result {} is vacant or not a number in {} of {} runs, which its statistics "
          "leave out\n",
          record.description.results[i].name, vacant, record.rows.size());
    }
  }
  return text;
}

}  // namespace g31::study
