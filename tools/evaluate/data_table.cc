#include "tools/evaluate/data_table.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "machine/base/contract.h"
#include "machine/base/nearest_name.h"
#include "machine/base/utf_8.h"
#include "tools/evaluate/data_field.h"

namespace g31::evaluate {
namespace {

/// UTF-16 begins with its byte order mark, or has every other byte 0.
bool is_wide(std::string_view text) {
  const std::string_view beginning = text.substr(0, 2);
  return beginning == "\xFF\xFE" || beginning == "\xFE\xFF" ||
         beginning.find('\0') != std::string_view::npos;
}

struct Separator {
  char sign;
  std::string_view name;
};
constexpr Separator kSeparators[] = {{',', "commas"}, {';', "semicolons"}, {'\t', "tabs"}};

/// Whether a line has a separator outside of double quotes; where their number is odd they are
/// text.
bool separates(char separator, std::string_view line) {
  const bool quotes_close = std::ranges::count(line, '"') % 2 == 0;
  bool is_between = false;
  for (const char c : line) {
    is_between = is_between != (c == '"' && quotes_close);
    if (c == separator && !is_between) {
      return true;
    }
  }
  return false;
}

/// Digits behind the point; the most where a power of ten moves it.  From the end, where both
/// stand: every number of a long record is looked at.
constexpr int kMostDecimals = 15;
int decimals_in(std::string_view text) {
  for (std::size_t i = text.size(); i-- > 0;) {
    if (text[i] == 'e' || text[i] == 'E') {
      return kMostDecimals;
    }
    if (text[i] == '.' || text[i] == ',') {
      return std::min(static_cast<int>(text.size() - i) - 1, kMostDecimals);
    }
  }
  return 0;
}

}  // namespace

/// Goes through a file line by line.
class TableReader {
 public:
  TableReader(const DataFile& file, const std::vector<WantedColumn>& wanted,
              const ColumnRules& rules)
      : file_(file), wanted_(wanted), rules_(rules), line_end_(line_end_of(file.text)) {
    if (file.text.starts_with(kByteOrderMark)) {
      offset_ = kByteOrderMark.size();
    }
    table_.columns_.reserve(wanted.size());
    for (const WantedColumn& column : wanted) {
      const double unit = column.kind == ColumnKind::Length ? rules.mm_per_unit : 1.0;
      table_.columns_.push_back({column.name, false, 0, unit, {}, {}});
    }
  }

  std::optional<DataError> read() {
    if (is_wide(file_.text)) {
      return data_error(DataErrorId::WideText, file_, {}, {});
    }
    auto wrong = read_header();
    while (!wrong && next_line()) {
      if (file_.watch != nullptr) {
        file_.watch->look();
      }
      wrong = read_row();
    }
    if (!wrong && table_.lines_.empty()) {
      wrong = data_error(DataErrorId::NoRows, file_, header_, {});
    }
    return wrong;
  }

  DataTable take_table() { return std::move(table_); }

 private:
  /// The next line with something in it.
  bool next_line() {
    while (offset_ < file_.text.size()) {
      begin_ = offset_;
      const std::size_t end = std::min(file_.text.find(line_end_, offset_), file_.text.size());
      line_ = file_.text.substr(begin_, end - begin_);
      offset_ = end + 1;
      ++number_;
      if (!line_.empty() && line_.back() == '\r') {
        line_.remove_suffix(1);
      }
      const std::size_t first = line_.find_first_not_of(" \t");
      if (first != std::string_view::npos && line_[first] != '#') {
        return true;
      }
    }
    return false;
  }

  [[nodiscard]] DataPlace here(std::size_t column = 0) const { return {number_, begin_ + column}; }

  std::optional<DataError> read_header() {
    if (!next_line()) {
      return data_error(DataErrorId::NoHeader, file_, {}, {});
    }
    header_ = here();
    std::string seen;
    int kinds = 0;
    for (const Separator& separator : kSeparators) {
      if (separates(separator.sign, line_)) {
        separator_ = separator.sign;
        seen += fmt::format("{}{}", kinds > 0 ? " and " : "", separator.name);
        ++kinds;
      }
    }
    if (kinds > 1) {
      return data_error(DataErrorId::MixedSeparators, file_, here(), {seen});
    }
    const std::vector<std::string_view> names = fields_of(line_, separator_);
    wanted_at_.assign(names.size(), -1);
    if (auto wrong = why_not_renamed()) {
      return wrong;
    }
    for (std::size_t i = 0; i < wanted_.size(); ++i) {
      if (auto wrong = find_column(i, names)) {
        return wrong;
      }
    }
    return std::nullopt;
  }

  /// A name of --columns that nothing here looks for.
  std::optional<DataError> why_not_renamed() const {
    for (const auto& [name, column] : rules_.names) {
      if (std::ranges::find(wanted_, name, &WantedColumn::name) == wanted_.end()) {
        std::vector<std::string_view> known;
        for (const WantedColumn& wanted : wanted_) {
          known.push_back(wanted.name);
        }
        return data_error(
            DataErrorId::CannotEvaluate, file_, {},
            {fmt::format("--columns {}={}: {} is none of the columns here, which are {}", name,
                         column, name, fmt::join(known, ", "))});
      }
    }
    return std::nullopt;
  }

  std::optional<DataError> find_column(std::size_t i, const std::vector<std::string_view>& names) {
    const WantedColumn& column = wanted_[i];
    const auto renamed = rules_.names.find(column.name);
    const std::string& name = renamed == rules_.names.end() ? column.name : renamed->second;
    auto found = std::ranges::find(names, name);
    const bool has_other = renamed == rules_.names.end() && !column.other_name.empty();
    if (found == names.end() && has_other) {
      found = std::ranges::find(names, column.other_name);
    }
    if (found == names.end()) {
      return column.is_optional && renamed == rules_.names.end()
                 ? std::nullopt
                 : std::optional(missing(column, name, names));
    }
    if (std::ranges::count(names, *found) > 1) {
      return data_error(DataErrorId::ColumnTwice, file_, here(), {*found});
    }
    int& taken = wanted_at_[static_cast<std::size_t>(found - names.begin())];
    if (taken >= 0) {
      return data_error(DataErrorId::ColumnTaken, file_, here(),
                        {*found, column.name, wanted_[static_cast<std::size_t>(taken)].name});
    }
    taken = static_cast<int>(i);
    table_.columns_[i].is_there = true;
    return std::nullopt;
  }

  [[nodiscard]] DataError missing(const WantedColumn& column, const std::string& name,
                                  const std::vector<std::string_view>& names) const {
    std::string list;
    for (const std::string_view there : names) {
      list += fmt::format("{}{}", list.empty() ? "" : ", ", as_field(there, ','));
    }
    const auto nearest = nearest_name(name, names);
    const std::string pair = fmt::format(
        "{}={}", column.name, nearest && !nearest->empty() ? *nearest : std::string_view("NAME"));
    const std::string word = as_field(pair, ',');
    return data_error(DataErrorId::MissingColumn, file_, here(), {name, list},
                      fmt::format("--columns {} says which column is {}{}{}",
                                  word == pair ? pair : fmt::format("'{}'", word), column.name,
                                  column.otherwise.empty() ? "" : "; ", column.otherwise));
  }

  std::optional<DataError> read_row() {
    const std::size_t columns = wanted_at_.size();
    std::size_t field = 0;
    for (std::size_t at = 0;; ++field) {
      const std::size_t end = field_end(line_, at, separator_);
      const std::string_view text = line_.substr(std::min(at, line_.size()), end - at);
      if (field < columns && wanted_at_[field] >= 0) {
        if (auto wrong = take(static_cast<std::size_t>(wanted_at_[field]), text)) {
          return wrong;
        }
      } else if (field >= columns && !bare(text).empty()) {
        return data_error(DataErrorId::LongRow, file_, here(at), {std::to_string(columns)});
      }
      if (end == line_.size()) {
        break;
      }
      at = end + 1;
    }
    if (field + 1 < columns) {
      return data_error(DataErrorId::ShortRow, file_, here(line_.size()),
                        {std::to_string(field + 1), std::to_string(columns)});
    }
    table_.lines_.push_back(number_);
    return std::nullopt;
  }

  /// Whether a number has the decimal mark of those before, if it has one.
  bool is_as_before(std::string_view number) {
    const std::size_t at = number.find_first_of(",.");
    if (at == number.npos) {
      return true;
    }
    decimal_mark_ = decimal_mark_ == '\0' ? number[at] : decimal_mark_;
    return number[at] == decimal_mark_;
  }

  std::optional<DataError> take(std::size_t i, std::string_view field) {
    const std::string_view text = bare(field);
    const WantedColumn& column = wanted_[i];
    if (column.kind == ColumnKind::Text) {
      table_.columns_[i].texts.emplace_back(text);
      return std::nullopt;
    }
    const bool may_have_comma = separator_ != ',' || is_quoted(field);
    const auto number = may_have_comma ? number_with_comma_in(text) : number_in(text);
    const auto where = [&] {
      const char* const begin = text.empty() ? field.data() : text.data();
      return here(static_cast<std::size_t>(begin - line_.data()));
    };
    if (!number || std::isnan(*number)) {
      return data_error(DataErrorId::NoNumber, file_, where(),
                        {column.name, text.empty() ? "there is nothing" : text});
    }
    if (!is_as_before(text)) {
      return data_error(DataErrorId::NoNumber, file_, where(),
                        {column.name, fmt::format("{} has another decimal mark than a number "
                                                  "before, and may mean a thousand times that",
                                                  text)});
    }
    const bool is_length = column.kind == ColumnKind::Length;
    const double value = is_length ? *number * rules_.mm_per_unit : *number;
    if (!(std::abs(value) <= (is_length ? kLargestLength : kLargestNumber))) {
      return data_error(DataErrorId::OutOfRange, file_, where(), {column.name, text});
    }
    DataTable::Column& target = table_.columns_[i];
    // Any row may be the first with as many digits: a record often begins with 0 or 50.0, standing.
    if (target.decimals < kMostDecimals) {
      target.decimals = std::max(target.decimals, decimals_in(text));
    }
    target.numbers.push_back(value);
    return std::nullopt;
  }

  const DataFile& file_;
  const std::vector<WantedColumn>& wanted_;
  const ColumnRules& rules_;
  char line_end_;
  DataTable table_;
  std::vector<int> wanted_at_;  // by column of the file: index of the wanted one, or -1
  char separator_ = ',';
  char decimal_mark_ = '\0';  // of the first number that has one
  DataPlace header_;          // of the line with the names
  std::size_t offset_ = 0;    // of the next line
  std::size_t begin_ = 0;     // of this line
  std::size_t number_ = 0;
  std::string_view line_;
};

const DataTable::Column& DataTable::column(std::string_view name) const {
  const auto found = std::ranges::find(columns_, name, &Column::name);
  G31_EXPECTS(found != columns_.end());
  return *found;
}

bool DataTable::has(std::string_view name) const {
  return column(name).is_there;
}

const std::vector<double>& DataTable::numbers(std::string_view name) const {
  return column(name).numbers;
}

double DataTable::resolution(std::string_view name) const {
  const Column& found = column(name);
  return found.unit * std::pow(10.0, -found.decimals);
}

const std::vector<std::string>& DataTable::texts(std::string_view name) const {
  return column(name).texts;
}

Result<DataTable, DataError> read_table(const DataFile& file,
                                        const std::vector<WantedColumn>& wanted,
                                        const ColumnRules& rules) {
  TableReader reader(file, wanted, rules);
  if (auto wrong = reader.read()) {
    return *wrong;
  }
  return reader.take_table();
}

}  // namespace g31::evaluate
