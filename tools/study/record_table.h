#pragma once

#include <string>

#include "tools/study/record.h"

namespace g31::study {

/// The study as a table for people, in the form it asks for, with what it assumes below.
std::string record_table(const Record& record);

/// What is left out of the statistics, one line each; "" when nothing is.
std::string record_warnings(const Record& record);

}  // namespace g31::study
