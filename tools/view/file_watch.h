#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

namespace g31::view {

/// What a file or a folder is at a time, as far as a look at it tells.
struct Stamp {
  bool is_there = false;
  std::uint64_t size = 0;    ///< bytes; of a folder, what the names in it hash to
  std::int64_t time_ns = 0;  ///< of its last change; 0 for a folder
  std::uint64_t inode = 0;
  friend bool operator==(const Stamp&, const Stamp&) = default;
};

Stamp stamp_of(const std::string& path);

/// Files and folders that work depends on, those included that it looked for in vain.
///
/// Any thread may call it.
class FileWatch {
 public:
  /// Work begins: from now on a change is one against what is there now.
  void begin();
  /// The work is about to read this file, or to list this folder ("": the one that it
  /// stands in).  Standard input is not watched.
  void add(const std::string& path);
  /// Whether something is other than the work may have read it.
  [[nodiscard]] bool has_changed() const;
  /// Returns when nothing has changed for a while: an editor that truncates a file and writes it
  /// is done with it then.  It waits for a bounded time.
  void wait_for_rest() const;

 private:
  using Stamps = std::map<std::string, Stamp>;
  [[nodiscard]] Stamps now() const;
  [[nodiscard]] Stamps known() const;

  mutable std::mutex mutex_;
  Stamps stamps_;
};

}  // namespace g31::view
