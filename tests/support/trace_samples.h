#pragma once

#include <vector>

#include "machine/port/trace.h"

namespace g31::testing {

/// Keeps the samples of a trace, in order.
class TraceSamples final : public machine::TraceSink {
 public:
  void on_sample(const machine::TraceSample& sample) override { list.push_back(sample); }
  std::vector<machine::TraceSample> list;
};

}  // namespace g31::testing
