#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "tools/page/report.h"
#include "tools/plan/judgement.h"

namespace g31::page {

/// A measure as a row of results.
Characteristic characteristic_of(const plan::JudgedMeasure& judged);

/// What a page says of measures that are not good.
struct JudgedWords {
  Word bad;      ///< name, deviation, lower, upper
  Word missing;  ///< name
  Word one;      ///< names, of a single one
  Word several;  ///< names
};

/// The names of what is not good as a headline has them: the first few, and how many there are.
std::string named(const std::vector<std::string>& names);

/// Tells each measure that is not good as a finding and, where there are any, makes them the
/// verdict: its sign, state and headline.
void add_not_good(const plan::Judgement& judgement, const JudgedWords& words, Report& report);

}  // namespace g31::page
