#pragma once

#include <cstdint>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>

namespace g31::fuzz {

/// How many of the counted changes a process tries: `times` as many as in every test run, and of
/// those the numbers `first`, `first` + `apart` and so on.
struct Effort {
  std::uint64_t times = 1;
  std::uint64_t first = 0;
  std::uint64_t apart = 1;
};

/// @param times  "85"; null: once
/// @param share  "2/3" is the second of three processes; null: one process tries them all
/// nullopt: one of them is wrong
inline std::optional<Effort> effort_of(const char* times, const char* share) {
  Effort effort;
  if (times != nullptr) {
    std::istringstream in(times);
    if (!(in >> effort.times) || !in.eof() || effort.times < 1 || effort.times > 100'000) {
      return std::nullopt;
    }
  }
  if (share != nullptr) {
    std::istringstream in(share);
    char slash = 0;
    if (!(in >> effort.first >> slash >> effort.apart) || !in.eof() || slash != '/' ||
        effort.first < 1 || effort.first > effort.apart) {
      return std::nullopt;
    }
    --effort.first;
  }
  return effort;
}

/// As the environment has it.
inline std::optional<Effort> effort() {
  return effort_of(std::getenv("G31_FUZZ_EFFORT"), std::getenv("G31_FUZZ_SHARE"));
}

}  // namespace g31::fuzz
