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

/// Tells each measure that is not good as a finding and, where there are any, makes them the
/// verdict: its sign, state and headline.
/// @param report  its results are those of the measures
void add_not_good(const plan::Judgement& judgement, const JudgedWords& words, Report& report);

}  // namespace g31::page
