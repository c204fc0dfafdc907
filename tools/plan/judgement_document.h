#pragma once

#include <string>

#include "tools/plan/judgement.h"

namespace g31::plan {

/// The document g31.judgement/1: null for what has not come.
std::string judgement_document(const Judgement& judgement);

/// The measures for a person.
std::string measures_table(const Judgement& judgement);

/// The same, and how many of each verdict.
std::string judgement_table(const Judgement& judgement);

}  // namespace g31::plan
