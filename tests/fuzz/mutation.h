#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace g31::fuzz {

/// A changed copy of one of the texts: one to four changes, each a byte replaced, a piece left out
/// or written twice, a word put in, or a piece of another text put in.
///
/// The same number, texts and words give the same bytes on every computer.
/// @param texts, words  not empty
std::string mutation(std::uint64_t number, std::span<const std::string> texts,
                     std::span<const std::string> words);

}  // namespace g31::fuzz
