#pragma once

#include <string>
#include <vector>

#include "tools/evaluate/evaluation.h"
#include "tools/page/report.h"
#include "tools/plan/judgement.h"
#include "tools/plan/planned_part.h"
#include "tools/study/record.h"

namespace g31::page {

/// Where a page comes from: what made it, of which inputs.
struct PageOrigin {
  std::string version;  ///< of g31
  std::string command;  ///< that repeats it
  std::vector<Input> inputs;
  Language language = Language::English;
  int exit_code = 0;
};

/// @param file      that was evaluated, without its folder
/// @param document  of the evaluation
Report report_of(const evaluate::Evaluation& evaluation, const std::string& file,
                 const std::string& document, const PageOrigin& origin);

/// Of each result at each point a histogram, a run chart and its statistics, beside them what is
/// known and what was published.  The first kMostCharts of them are drawn; the table has all.
/// @param document  of the study
Report report_of(const study::Record& record, const std::string& document,
                 const PageOrigin& origin);

/// Which files a judgement is of, without their folders.
struct JudgedFiles {
  std::string plan;
  std::string results;
};

/// What was printed beside what the plan wants: each measure that is not good is a finding, and so
/// is each line that has to be spoken of.
Report report_of(const plan::Judgement& judgement, const JudgedFiles& files,
                 const PageOrigin& origin);

/// The command that makes a plan, and how it ends.
struct PlanCommand {
  std::string line;  ///< that repeats it
  int exit_code = 0;
};

/// Makes the page of a plan from that of the run that proved it.
void add_plan(const plan::PlannedPart& planned, const PlanCommand& command, Report& report);

inline constexpr std::size_t kMostCharts = 24;

}  // namespace g31::page
