#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tools/study/study.h"

namespace g31::study {

/// How many combinations of listed values there are; 1 without lists.
std::size_t point_count(const Study& study);

/// repeats for each combination.
std::size_t run_count(const Study& study);

/// The listed values of a combination, one for each list; the last list changes first.
std::vector<const ListedValue*> values_at(const Study& study, std::size_t point);

/// What a seed is for: each use has random streams of its own.
enum class SeedUse : std::uint32_t { Run = 1, BeforeAll = 2, BeforeRun = 3 };

/// The seed that one program runs with, below 2^53, so that any reader of JSON keeps it.
///
/// Counter-based: it depends on these numbers alone, so runs may be shared out among threads and
/// machines.
/// @param event    the number of the run, or of the combination for BeforeAll
/// @param program  which of the programs that run before; 0 for the main one
std::uint64_t seed_of(std::uint64_t study_seed, SeedUse use, std::uint64_t event,
                      std::uint32_t program = 0);

/// The value of a drawn axis for a run.
/// @param which  of the study's drawn axes: each has a stream of its own
double drawn_value(const DrawnAxis& axis, std::uint64_t study_seed, std::size_t which,
                   std::uint64_t run);

}  // namespace g31::study
