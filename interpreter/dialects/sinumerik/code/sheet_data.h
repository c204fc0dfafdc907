#pragma once

#include <map>
#include <string>
#include <variant>
#include <vector>

#include "interpreter/dialects/sinumerik/code/globals.h"

namespace g31::sinumerik {

/// Machine data and user data as the set-up sheet has them: a number, a text, "axis X" or a list.
using SheetDatum = std::variant<double, std::string, std::vector<double>>;
using SheetData = std::map<std::string, SheetDatum>;

/// Defines what nobody has defined: a name is as large as its highest indices, one of $MA_ has an
/// element for each axis.
void define_missing(const SheetData& data, Globals& globals);

/// MD28254 and MD28256 of the sheet: how many $AC_PARAM and $AC_MARKER there are.
void shorten_memory(const SheetData& data, Globals& globals);

/// MD11120 of the sheet: whether subprograms see the variables of the main program (PUD).
bool are_main_variables_global(const SheetData& data);

/// `NAME=value`, one for each element, as a program would write it.
std::vector<std::string> assignments_of(const std::string& name, const SheetDatum& datum);

/// A number with every digit; the exponent as the language writes it.
std::string written_number(double value);

}  // namespace g31::sinumerik
