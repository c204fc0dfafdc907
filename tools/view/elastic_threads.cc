#include "tools/view/elastic_threads.h"

#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

namespace g31::view {

void ElasticThreads::enqueue(std::function<void()> job) {
  const std::scoped_lock lock(mutex_);
  jobs_.push_back(std::move(job));
  if (jobs_.size() > idle_ && threads_ < kMost) {
    try {
      std::thread([this] { work(); }).detach();
      ++threads_;
    } catch (const std::system_error&) {
      // The system has no more threads: the job waits for one of those that there are.
    }
  }
  changed_.notify_all();
}

void ElasticThreads::shutdown() {
  std::unique_lock lock(mutex_);
  ends_ = true;
  changed_.notify_all();
  changed_.wait(lock, [this] { return threads_ == 0; });
}

void ElasticThreads::work() {
  constexpr std::chrono::seconds kPatience(5);
  std::unique_lock lock(mutex_);
  while (true) {
    ++idle_;
    changed_.wait_for(lock, kPatience, [this] { return ends_ || !jobs_.empty(); });
    --idle_;
    if (jobs_.empty()) {
      break;
    }
    const std::function<void()> job = std::move(jobs_.front());
    jobs_.pop_front();
    lock.unlock();
    job();
    lock.lock();
  }
  --threads_;
  changed_.notify_all();  // under the lock: behind it the queue may be gone
}

}  // namespace g31::view
