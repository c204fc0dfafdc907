#pragma once

#include "interpreter/source/source_file.h"

namespace g31::source {

/// A place in one of the files of a run.  The file outlives the location.
struct Location {
  const SourceFile* file = nullptr;
  Span span;
};

}  // namespace g31::source
