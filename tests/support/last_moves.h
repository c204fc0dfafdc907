#pragma once

#include <span>

#include <gtest/gtest.h>

#include "tests/support/control_run.h"

namespace g31::testing {

/// A program for a FANUC 16i.
struct LastMove {
  const char* name;
  const char* program;
  const char* last;  ///< that the machine was asked for
};

/// One for any control.
struct LastMoveOn {
  const char* name;
  const char* control;
  const char* program;
  const char* last;  ///< that the machine was asked for
};

inline void expect_last_moves(std::span<const LastMoveOn> cases,
                              const runtime::ControlSetup& setup = {}) {
  for (const LastMoveOn& c : cases) {
    SCOPED_TRACE(c.name);
    ControlRun run(c.control, c.program, setup);
    EXPECT_EQ(run.alarm(), 0);
    ASSERT_FALSE(run.machine().log().empty());
    EXPECT_EQ(run.machine().log().back(), c.last);
  }
}

inline void expect_last_moves(std::span<const LastMove> cases,
                              const runtime::ControlSetup& setup = {}) {
  for (const LastMove& c : cases) {
    const LastMoveOn on_16i[] = {{c.name, "fanuc-16i", c.program, c.last}};
    expect_last_moves(on_16i, setup);
  }
}

}  // namespace g31::testing
