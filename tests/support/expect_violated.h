#pragma once

#include <string>

#include <gtest/gtest.h>

#include "machine/base/contract.h"

namespace g31::testing {

/// Expects that some work violates the contract whose text holds `what`.
template <typename Work>
void expect_violated(const Work& work, const std::string& what) {
  try {
    work();
    ADD_FAILURE() << "no contract was violated, not: " << what;
  } catch (const ContractViolation& violation) {
    EXPECT_NE(std::string(violation.what()).find("contract violated: "), std::string::npos);
    EXPECT_NE(std::string(violation.what()).find(what), std::string::npos) << violation.what();
  }
}

}  // namespace g31::testing
