#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tools/plan/measures.h"

namespace g31::plan {

enum class Verdict { Good, Bad, Missing };

/// "good"
std::string_view word_of(Verdict verdict);

/// A measure and what was printed for it.
struct JudgedMeasure {
  Measure measure;
  std::optional<double> actual;     ///< mm; nothing: it has not come, or its line is not readable
  std::optional<double> deviation;  ///< actual less nominal, to 1e-9 mm
  Verdict verdict = Verdict::Missing;
};

/// What has to be said of a printed line.
struct Remark {
  std::size_t line = 0;  ///< from 1
  std::string text;
};

struct Judgement {
  std::vector<JudgedMeasure> measures;  ///< in the order of the plan
  std::vector<Remark> remarks;          ///< in the order of their lines
};

/// Compares printed text with the design.  A limit of the tolerance itself is good.  A line that
/// does not read as pairs of name and value makes every measure that it names missing and is
/// quoted; of a measure that comes twice the last line counts and the first is named.
/// @param text  lines end with LF, CR LF or CR
Judgement judged(const std::vector<Measure>& measures, std::string_view text);

std::size_t count(const Judgement& judgement, Verdict verdict);

/// Good because the plan has no tolerance for it: the value is only reported.
bool is_only_reported(const JudgedMeasure& row);

}  // namespace g31::plan
