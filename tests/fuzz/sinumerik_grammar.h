#pragma once

#include <cstdint>
#include <string>

namespace g31::fuzz {

/// A SINUMERIK program by the rules of the language: definitions, expressions, structures inside
/// each other, motion, frames, measuring, calls of measuring cycles; with numbers as people write
/// them and with the largest and smallest.  Most of such programs are compiled whole and run until
/// an alarm, which mutations of texts seldom are.
///
/// The same number gives the same program on every computer.
std::string sinumerik_program(std::uint64_t number);

}  // namespace g31::fuzz
