#include "tests/support/effort.h"

namespace g31::testing {

bool under_sanitizers() {
#if defined(G31_UNDER_SANITIZERS)
  return true;
#else
  return false;
#endif
}

int one_case_of() {
  return under_sanitizers() ? 8 : 1;
}

}  // namespace g31::testing
