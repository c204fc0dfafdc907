#pragma once

#include <gtest/gtest.h>

#include "tests/tools/setup_sheets.h"

namespace g31::setup {

/// A sheet and everything that is said about it.
struct ErrorCase {
  const char* name;
  const char* sheet;
  const char* text;
};

class SetupErrorText : public SetupSheets {
 protected:
  SetupErrorText() { static_cast<void>(write("ring.stl", "")); }

  void expect_text(const ErrorCase& c) const {
    SCOPED_TRACE(c.name);
    EXPECT_EQ(errors_of(read({c.sheet})), c.text);
  }
};

}  // namespace g31::setup
