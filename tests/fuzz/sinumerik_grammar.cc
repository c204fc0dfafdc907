#include "tests/fuzz/sinumerik_grammar.h"

#include <array>
#include <string_view>

#include <fmt/format.h>

#include "tests/fuzz/draws.h"

namespace g31::fuzz {
namespace {

constexpr std::array<std::string_view, 22> kNumbers = {
    "0",       "1",       "-1",     "2",     "0.5",        "10",         "-12.345", "90",
    "359.999", "1EX-10",  "1EX-9",  "1EX9",  "-1EX9",      "1EX155",     "-1EX155", "1EX-300",
    "1EX308",  "1EX-308", "'B101'", "'HFF'", "2147483647", "-2147483648"};
constexpr std::array<std::string_view, 14> kNames = {
    "R1",   "R2",   "R[A]",      "R[B+1]",    "A",          "B",        "C",
    "D[1]", "D[A]", "$AA_IW[X]", "$AA_MW[Y]", "$AC_MEA[1]", "$P_EP[Z]", "$AC_TIME"};
constexpr std::array<std::string_view, 7> kTargets = {"R1", "R2", "A", "B", "C", "D[1]", "D[A]"};
constexpr std::array<std::string_view, 14> kOperators = {
    "+",    "-",     "*",  "/", " DIV ", " MOD ", " AND ",
    " OR ", " XOR ", "==", "<", ">=",    "<>",    " B_AND "};
constexpr std::array<std::string_view, 14> kFunctions = {"SIN",  "COS", "TAN",  "ASIN",  "ACOS",
                                                         "SQRT", "ABS", "POT",  "TRUNC", "ROUND",
                                                         "LN",   "EXP", "NOT ", "B_NOT "};
constexpr std::array<std::string_view, 30> kModes = {
    "G0",  "G1",   "G90",   "G91",  "G17",    "G18",    "G19",  "G40",     "G41 D1", "G42",
    "G54", "G500", "G60",   "G64",  "G641",   "G70",    "G71",  "G700",    "G710",   "G93",
    "G94", "G95",  "BRISK", "SOFT", "COMPON", "COMPOF", "CFIN", "TRAFOOF", "SUPA",   "DIAMON"};
constexpr std::array<std::string_view, 9> kFrames = {"TRANS X{0} Y{1}",
                                                     "ATRANS Z{0}",
                                                     "ROT Z{0}",
                                                     "AROT X{0} Y{1}",
                                                     "SCALE X{0}",
                                                     "ASCALE Y{0}",
                                                     "MIRROR X{0}",
                                                     "$P_UIFR[1]=CTRANS(X,{0}):CROT(Z,{1})",
                                                     "$P_PFRAME=CSCALE(Y,{0})"};
constexpr std::array<std::string_view, 6> kCycles = {"CYCLE976", "CYCLE977", "CYCLE978",
                                                     "CYCLE979", "CYCLE961", "CYCLE998"};

class Grammar {
 public:
  explicit Grammar(std::uint64_t number) : draws_(number, 1) {}

  std::string program() {
    text_ = "DEF INT A,B\nDEF REAL C,D[3]\nDEF STRING[40] S\nG54 G90 G1 F1000\n";
    for (std::size_t count = 3 + draws_.below(12); count > 0; --count) {
      statement(0);
    }
    return text_ + "M30\n";
  }

 private:
  static constexpr int kDeepest = 3;

  std::string number() {
    return draws_.once_in(3) ? std::string(draws_.of(kNumbers))
                             : fmt::format("{}", static_cast<int>(draws_.below(400)) - 100);
  }

  std::string expression(int depth) {
    switch (depth > kDeepest ? draws_.below(2) : draws_.below(6)) {
      case 0:
        return number();
      case 1:
        return std::string(draws_.of(kNames));
      case 2:
        return fmt::format("{}({})", draws_.of(kFunctions), expression(depth + 1));
      case 3:
        return fmt::format("({})", expression(depth + 1));
      default:
        return fmt::format("{}{}{}", expression(depth + 1), draws_.of(kOperators),
                           expression(depth + 1));
    }
  }

  /// What an address takes: a number, or =(an expression).
  std::string value() {
    return draws_.once_in(4) ? fmt::format("=({})", expression(2)) : fmt::format("={}", number());
  }

  void line(const std::string& text) { text_ += text + '\n'; }

  void body(int depth) {
    for (std::size_t count = 1 + draws_.below(3); count > 0; --count) {
      statement(depth + 1);
    }
  }

  void statement(int depth) {
    switch (depth > 2 ? draws_.below(8) : draws_.below(12)) {
      case 0:
      case 1:
        return line(fmt::format("{}={}", draws_.of(kTargets), expression(0)));
      case 2:
        return line(std::string(draws_.of(kModes)));
      case 3:
      case 4:
        return motion();
      case 5:
        return line(fmt::format(fmt::runtime(draws_.of(kFrames)), number(), number()));
      case 6:
        return line(fmt::format("S=\"T\"<<({})\nMSG(S<<({}))", expression(2), expression(2)));
      case 7:
        return draws_.once_in(4) ? call() : line(std::string(draws_.of(kModes)));
      default:
        return structure(depth);
    }
  }

  void motion() {
    const std::string end = fmt::format("X{} Y{}", value(), value());
    switch (draws_.below(6)) {
      case 0:
        return line(fmt::format("G{} {} I{} J{}", 2 + draws_.below(2), end, value(), value()));
      case 1:
        return line(fmt::format("CIP {} I1{} J1{}", end, value(), value()));
      case 2:
        return line(fmt::format("MEAS={} G1 {} F{}", draws_.below(3), end, number()));
      case 3:
        return line(fmt::format("G4 F{}", number()));
      default:
        return line(fmt::format("G{} {} Z{} F{}", draws_.below(2), end, value(), number()));
    }
  }

  void call() {
    std::string arguments;
    for (std::size_t count = draws_.below(27); count > 0; --count) {
      arguments += draws_.once_in(4) ? "" : number();
      arguments += count > 1 ? "," : "";
    }
    line(fmt::format("{}({})", draws_.of(kCycles), arguments));
  }

  void structure(int depth) {
    switch (draws_.below(5)) {
      case 0:
        line(fmt::format("IF {}", expression(1)));
        body(depth);
        if (draws_.once_in(2)) {
          line("ELSE");
          body(depth);
        }
        return line("ENDIF");
      case 1:
        line(fmt::format("FOR A={} TO {}", number(), number()));
        body(depth);
        return line("ENDFOR");
      case 2:
        line(fmt::format("WHILE {}", expression(1)));
        body(depth);
        return line("ENDWHILE");
      case 3:
        line("REPEAT");
        body(depth);
        return line(fmt::format("UNTIL {}", expression(1)));
      default:
        line(fmt::format("CASE {} OF {} GOTOF L{} DEFAULT GOTOF L{}", expression(1),
                         draws_.below(3), labels_, labels_));
        body(depth);
        return line(fmt::format("L{}: R3={}", labels_++, number()));
    }
  }

  Draws draws_;
  std::string text_;
  int labels_ = 1;
};

}  // namespace

std::string sinumerik_program(std::uint64_t number) {
  return Grammar(number).program();
}

}  // namespace g31::fuzz
