// The same for tests.
#include <gtest/gtest.h>

#include "tools/cmake/g31_prelude.h"
