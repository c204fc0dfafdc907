#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "interpreter/source/location.h"

namespace g31::coverage {

/// A block that has run.
struct CountedBlock {
  source::Location where;
  std::uint64_t runs = 0;
  std::array<std::uint64_t, 2> conditions = {0, 0};  ///< how often one was not met, and met
};

/// How often the blocks of a run have run, and how often their conditions held.
class BlockCounts {
 public:
  void add(const source::Location& where) { ++at(where).runs; }
  void add_condition(const source::Location& where, bool is_met) {
    ++at(where).conditions[is_met ? 1 : 0];
  }

  /// In the order in which they first ran.
  [[nodiscard]] std::span<const CountedBlock> blocks() const { return blocks_; }

 private:
  struct Place {
    source::FileId file = source::FileId::None;
    std::uint64_t begin = 0;
    friend bool operator==(const Place&, const Place&) = default;
  };
  struct Hash {
    std::size_t operator()(const Place& place) const {
      constexpr std::uint64_t kOdd = 0x9E3779B97F4A7C15;
      return static_cast<std::size_t>(
          (place.begin + (static_cast<std::uint64_t>(place.file) << 40U)) * kOdd);
    }
  };

  CountedBlock& at(const source::Location& where) {
    const auto [found, is_new] = known_.try_emplace({where.file, where.begin}, blocks_.size());
    if (is_new) {
      blocks_.push_back({where});
    }
    return blocks_[found->second];
  }

  std::vector<CountedBlock> blocks_;
  std::unordered_map<Place, std::size_t, Hash> known_;
};

}  // namespace g31::coverage
