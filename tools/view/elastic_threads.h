#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>

#include <httplib.h>

namespace g31::view {

/// A thread for each connection that is there: one that says nothing keeps nobody else waiting.
/// Threads without work end after a while.
class ElasticThreads final : public httplib::TaskQueue {
 public:
  void enqueue(std::function<void()> job) override;
  /// Does what is still to be done, and waits until the last thread has ended.
  void shutdown() override;

 private:
  static constexpr std::size_t kMost = 512;

  void work();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> jobs_;
  std::size_t threads_ = 0;
  std::size_t idle_ = 0;
  bool ends_ = false;
};

}  // namespace g31::view
