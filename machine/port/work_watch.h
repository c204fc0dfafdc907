#pragma once

namespace g31::machine {

/// Stands beside work that one call may make long.  The work looks at it in each of its steps; it
/// throws where there is to be no more of it, and the machine is left in the middle of its motion.
class WorkWatch {
 public:
  WorkWatch() = default;
  WorkWatch(const WorkWatch&) = delete;
  WorkWatch& operator=(const WorkWatch&) = delete;
  virtual ~WorkWatch() = default;

  /// Costs next to nothing.
  virtual void look() = 0;
};

}  // namespace g31::machine
