#pragma once

#include <string>

#include "tools/study/record.h"

namespace g31::study {

/// One line for each run under one line of names, as RFC 4180 wants it: run, seed, status, exit,
/// the listed values in words, the drawn ones, the results, the note.
std::string record_csv(const Record& record);

}  // namespace g31::study
