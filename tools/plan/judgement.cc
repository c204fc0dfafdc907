#include "tools/plan/judgement.h"

#include <algorithm>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "machine/base/utf_8.h"
#include "machine/units/rounded_length.h"
#include "tools/plan/printed_line.h"

namespace g31::plan {
namespace {

/// A line as a message shows it: nothing in it moves a terminal's cursor.
std::string quoted(std::string_view line) {
  constexpr std::size_t kLongest = 80;
  std::string text;
  for (const char c : line.substr(0, kLongest)) {
    const auto byte = static_cast<unsigned char>(c);
    text += c >= ' ' && c <= '~' ? std::string(1, c) : fmt::format("\\x{:02X}", byte);
  }
  return fmt::format("\"{}{}\"", text, line.size() > kLongest ? "..." : "");
}

/// Reads lines into the measures that they name.
class Sheet {
 public:
  explicit Sheet(const std::vector<Measure>& measures) {
    for (const Measure& measure : measures) {
      by_name_[measure.id] = by_name_[measure.printed] = judgement_.measures.size();
      judgement_.measures.push_back({measure, {}, {}, Verdict::Missing});
    }
    came_.resize(measures.size());
  }

  void take(std::string_view line) {
    ++line_;
    if (is_passed_over(line)) {
      return;
    }
    const auto values = printed_values(line);
    if (!values) {
      lose(line);
      return;
    }
    for (const PrintedValue& printed : *values) {
      if (const auto found = by_name_.find(printed.name); found != by_name_.end()) {
        begin(found->second);
        judgement_.measures[found->second].actual = printed.value;
      } else {
        remark(line_,
               fmt::format("the plan has no measure {}: {}", quoted(printed.name), quoted(line)));
      }
    }
  }

  Judgement judgement() && {
    for (JudgedMeasure& row : judgement_.measures) {
      judge(row);
    }
    std::ranges::stable_sort(judgement_.remarks, {}, &Remark::line);
    return std::move(judgement_);
  }

 private:
  void remark(std::size_t line, std::string text) {
    judgement_.remarks.push_back({line, std::move(text)});
  }

  /// From here on this line is the one that counts for a measure.
  void begin(std::size_t measure) {
    if (came_[measure] != 0) {
      remark(came_[measure], fmt::format("{} comes once more in line {}, which counts",
                                         judgement_.measures[measure].measure.id, line_));
    }
    came_[measure] = line_;
    judgement_.measures[measure].actual.reset();
  }

  void lose(std::string_view line) {
    remark(line_, fmt::format("not readable as names and values: {}", quoted(line)));
    for (const std::string_view word : words_of(line)) {
      if (const auto found = by_name_.find(word); found != by_name_.end()) {
        begin(found->second);
      }
    }
  }

  static void judge(JudgedMeasure& row) {
    if (!row.actual) {
      return;
    }
    row.deviation = rounded_length(*row.actual - row.measure.nominal);
    const auto& tolerance = row.measure.tolerance;
    const bool is_good = !tolerance || (*row.deviation >= rounded_length(tolerance->lower) &&
                                        *row.deviation <= rounded_length(tolerance->upper));
    row.verdict = is_good ? Verdict::Good : Verdict::Bad;
  }

  Judgement judgement_;
  std::map<std::string, std::size_t, std::less<>> by_name_;
  std::vector<std::size_t> came_;  // the line that counts, for each measure; 0: none so far
  std::size_t line_ = 0;
};

}  // namespace

std::string_view word_of(Verdict verdict) {
  constexpr std::string_view kVerdictWords[] = {"good", "bad", "missing"};
  return kVerdictWords[static_cast<std::size_t>(verdict)];
}

Judgement judged(const std::vector<Measure>& measures, std::string_view text) {
  text.remove_prefix(text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0);
  Sheet sheet(measures);
  std::string line;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_pair = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if (text[i] == '\n' || (text[i] == '\r' && !is_pair)) {
      sheet.take(line);
      line.clear();
    } else if (!is_pair) {
      line += text[i];
    }
  }
  sheet.take(line);
  return std::move(sheet).judgement();
}

std::size_t count(const Judgement& judgement, Verdict verdict) {
  return static_cast<std::size_t>(
      std::ranges::count(judgement.measures, verdict, &JudgedMeasure::verdict));
}

bool is_only_reported(const JudgedMeasure& row) {
  return row.verdict == Verdict::Good && !row.measure.tolerance;
}

}  // namespace g31::plan
