#pragma once

#include <map>
#include <string>
#include <vector>

#include "machine/base/result.h"

namespace g31::testing {

/// One case of a conformance file: a program, its set-up and what must come of it.
///
/// A file is NC text with lines of their own for the test, each one comment; in SINUMERIK files
/// they begin with a semicolon and a blank instead of standing in brackets:
///
///   (CASE MB-086 null equals null, not zero)   begins a case; the program is what follows
///   (SOURCE manual, chapter)         where the expectations are from, until the next such line
///   (CONTROL fanuc-30i)              controls to run it on, by default fanuc-16i and fanuc-30i
///   (PARAMETER 6006.0 = 1)           a control parameter before the start
///   (SET #500 = 2.5)                 a variable before the start
///   (SETTING block_skip = [1])       a key of the sheet's [control]
///   (START X = 10)                   a machine position before the start
///   (SIGNAL X12.5)  (SIGNAL NONE)    the skip signal of the next G31: where it rises
///   (SHEET [tools.5])                a line of the set-up sheet as it is
///
/// and expectations, one or more in each case:
///
///   (EXPECT COMPLETED)               needed only where nothing else is expected
///   (EXPECT #101 = 7.5)              (EXPECT #102 = VACANT)    (EXPECT #103 = 1.2 WITHIN 0.01)
///   (EXPECT ALARM 112 AT 4)          AT counts lines from the CASE line and may be left out
///   (EXPECT ALARM FORMAT AT 4)       any alarm of malformed text
///   (EXPECT MESSAGE "NO TOUCH")      the text of the alarm
///   (EXPECT NAME = "TEXT")           a variable that holds a text
///   (EXPECT OUTPUT "A 1.\n")         with \n, \r and \xNN
///   (EXPECT STOP "TURN")             a stop with this text
///   (EXPECT WARNING PRB301 AT 3)
///   (EXPECT NO WARNING PRB305)
///   (EXPECT MOVES 2)                 (EXPECT MOVE 2 G31 X12.345 Z-5)  machine coordinates;
///                                    T is the seconds of a G4, F the feed
///
/// A case without an alarm expected must run without one.  What stands before the first CASE
/// counts for every case of the file.
struct ConformanceCase {
  struct Row {
    int line = 0;  ///< of the file, from 1
    std::string text;
  };
  Row title;
  std::vector<std::string> controls;
  std::map<std::string, std::string> sheet;  ///< section to its lines
  std::string sheet_lines;
  std::vector<Row> expectations;
  std::string program;
};

/// Reads a conformance file.  @returns the cases, or what is wrong with the file
Result<std::vector<ConformanceCase>, std::string> read_conformance_file(const std::string& path);

/// The set-up sheet of a case.
std::string sheet_of(const ConformanceCase& test);

}  // namespace g31::testing
