#include "tools/setup/value_words.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

#include "machine/base/contract.h"

namespace g31::setup {
namespace {

constexpr auto kBoundedUnits = std::to_array<UnitBounds>({
#define UNIT(name, least, most) {name, least, most},
#include "tools/setup/units.def"
#undef UNIT
});

constexpr std::string_view kProgramSwitch =
    "an M code like \"M80\", or an output \"#1100\" to \"#1115\" or \"$A_OUT[1]\" to "
    "\"$A_OUT[64]\"";

/// What a value of each limit should be; Any asks for nothing.
struct LimitWords {
  Limit of;
  std::string_view words;
};
constexpr LimitWords kLimitWords[] = {
    {Limit::Any, ""},
    {Limit::IncrementSystem, "\"IS-A\", \"IS-B\" or \"IS-C\""},
    {Limit::RapidPath, "\"straight\" or \"independent\""},
    {Limit::OffsetMemory, "\"A\", \"B\" or \"C\""},
    {Limit::StoppingKind, "\"braking\" or \"ideal\""},
    {Limit::ProbeType, "\"3D\" or \"mono\""},
    {Limit::SeatKind, "\"even\" or \"tripod\""},
    {Limit::ProbeState, "\"ready\", \"dead\", \"low_battery\" or \"double_trigger\""},
    {Limit::ToolKind,
     "\"mill\", \"ball_mill\", \"bull_mill\", \"drill\", \"turning\", \"calibration\" or "
     "\"probe\""},
    {Limit::ToolProbeShape, "\"cube\", \"disc\" or \"laser\""},
    {Limit::ToolProbeSide, "\"bed\" or \"table\""},
    {Limit::MeshUnit, "\"um\", \"mm\", \"cm\", \"m\", \"inch\" or \"foot\""},
    {Limit::Positive, "greater than 0"},
    {Limit::Resolution, "1e-9 to 1e9"},
    {Limit::NotNegative, "0 or more"},
    {Limit::Share, "0 to 1"},
    {Limit::Bit, "0 or 1"},
    {Limit::SwitchNumber, "a list of numbers 1 to 9"},
    {Limit::ProgramNumber, "1 to 99999999"},
    {Limit::ToolOfProbe, "1 to 99999999"},
    {Limit::EdgePosition, "1 to 9"},
    {Limit::TipAngle, "above 0 and 180 at most"},
    {Limit::BlockCount, "0 to 9999"},
    {Limit::Rising, "two numbers, the first below the second"},
    {Limit::NotEmpty, "a string that is not empty"},
    {Limit::MeasuringInput, "1 to 8"},
    {Limit::DigitalInput,
     "1 to 64 for $A_IN, 1000 to 1015 for #1000 to #1015, or 11016 to 11255 for those of a "
     "Haas"},
    {Limit::SensorWord, "1032 to 1035 or 1132 to 1135"},
    {Limit::ColumnName, "a name of letters, digits, _, ., - and +"},
    {Limit::MachineCode, "M and a number of one to eight digits"},
    {Limit::ProgramSwitch, kProgramSwitch},
    {Limit::AxisLetter, "\"X\", \"Y\", \"Z\", \"A\", \"B\" or \"C\""},
    {Limit::WorkOffsetName, "a work offset: G54 to G59, EXT, G54.1 Pn, G154 Pn or G505 to G599"},
    {Limit::AxisLetters, "letters of X, Y, Z, A, B and C, none twice"},
    {Limit::NotAllZero, "three numbers, not all 0"},
    {Limit::NoneZero, "three numbers, none of them 0"},
    {Limit::RunStatus,
     "\"completed\", \"alarm\", \"collision\", \"setup\", \"budget\" or \"usage\""},
    {Limit::RisingPlaces, "pairs with rising places"},
    {Limit::VariableName, "a variable like #500, R1 or _OVR[0]"},
    {Limit::ResultUnit, "\"mm\", \"um\", \"inch\", \"deg\" or \"none\""},
    {Limit::KeyPresses, "letters, digits and signs of ASCII, one for each key"},
    {Limit::Tolerance, "0 or more, or [lower, upper] with the lower below the upper"},
};
static_assert(std::size(kLimitWords) == static_cast<std::size_t>(Limit::Tolerance) + 1,
              "every Limit has words");

constexpr double kEndless = std::numeric_limits<double>::infinity();

constexpr auto kNumberRanges = std::to_array<NumberRange>({
    {.of = Limit::Positive, .least = 0.0, .most = kEndless, .without_least = true},
    {.of = Limit::Resolution, .least = 1e-9, .most = 1e9},
    {.of = Limit::NotNegative, .least = 0.0, .most = kEndless},
    {.of = Limit::Share, .least = 0.0, .most = 1.0},
    {.of = Limit::Bit, .least = 0.0, .most = 0.0},
    {.of = Limit::Bit, .least = 1.0, .most = 1.0},
    {.of = Limit::SwitchNumber, .least = 1.0, .most = 9.0},
    {.of = Limit::ProgramNumber, .least = 1.0, .most = 99999999.0},
    {.of = Limit::ToolOfProbe, .least = 1.0, .most = 99999999.0},
    {.of = Limit::EdgePosition, .least = 1.0, .most = 9.0},
    {.of = Limit::TipAngle, .least = 0.0, .most = 180.0, .without_least = true},
    {.of = Limit::BlockCount, .least = 0.0, .most = 9999.0},
    {.of = Limit::MeasuringInput, .least = 1.0, .most = 8.0},
    {.of = Limit::DigitalInput, .least = 1.0, .most = 64.0},
    {.of = Limit::DigitalInput, .least = 1000.0, .most = 1015.0},
    {.of = Limit::DigitalInput, .least = 11016.0, .most = 11255.0},
    {.of = Limit::SensorWord, .least = 32.0, .most = 35.0},
    {.of = Limit::SensorWord, .least = 132.0, .most = 135.0},
    {.of = Limit::SensorWord, .least = 1032.0, .most = 1035.0},
    {.of = Limit::SensorWord, .least = 1132.0, .most = 1135.0},
});

}  // namespace

std::span<const UnitBounds> bounded_units() {
  return kBoundedUnits;
}

const UnitBounds* find_unit(std::string_view name) {
  const auto* const row = std::ranges::find(kBoundedUnits, name, &UnitBounds::name);
  return row != kBoundedUnits.end() ? row : nullptr;
}

std::vector<NumberRange> ranges_of(Limit limit) {
  std::vector<NumberRange> ranges;
  std::ranges::copy_if(kNumberRanges, std::back_inserter(ranges),
                       [&](const NumberRange& range) { return range.of == limit; });
  return ranges;
}

bool number_within(Limit limit, double number) {
  bool is_ranged = false;
  for (const NumberRange& range : kNumberRanges) {
    if (range.of == limit) {
      is_ranged = true;
      const bool is_above = range.without_least ? number > range.least : number >= range.least;
      if (is_above && number <= range.most) {
        return true;
      }
    }
  }
  return !is_ranged;
}

std::string_view words_for(ValueType type) {
  switch (type) {
    case ValueType::Text:
    case ValueType::Path:
      return "a string";
    case ValueType::Number:
      return "a number";
    case ValueType::NumberOrFlag:
      return "a number, true or false";
    case ValueType::NumberOrVacant:
      return "a number, or \"\" for vacant";
    case ValueType::WholeNumber:
      return "a whole number";
    case ValueType::WholeNumbers:
      return "an array of whole numbers";
    case ValueType::TwoNumbers:
      return "an array of two numbers";
    case ValueType::ThreeNumbers:
      return "an array of three numbers";
    case ValueType::NumberOrNumbers:
      return "a number or an array of numbers";
    case ValueType::NumberOrTable:
      return "a number or an array of [place, error]";
    case ValueType::Datum:
      return "a number, true or false, a string or an array of numbers";
    case ValueType::ExpectedNumber:
      return "a number or [value, tolerance]";
    case ValueType::ExpectedValue:
      return "a number, [value, tolerance], \"vacant\" or another string";
  }
  contract_violated("every ValueType has words", __FILE__, __LINE__);
}

std::string_view words_for(Limit limit) {
  const auto* const row = std::ranges::find(kLimitWords, limit, &LimitWords::of);
  G31_EXPECTS(row != std::end(kLimitWords));
  return row->words;
}

std::vector<std::string> choices_of(Limit limit) {
  std::vector<std::string> choices;
  std::string_view rest = words_for(limit);
  if (!rest.starts_with('"')) {
    return choices;
  }
  for (std::size_t open = 0; open != std::string_view::npos; open = rest.find('"')) {
    rest.remove_prefix(open + 1);
    const std::size_t close = rest.find('"');
    G31_EXPECTS(close != std::string_view::npos);
    choices.emplace_back(rest.substr(0, close));
    rest.remove_prefix(close + 1);
  }
  return choices;
}

}  // namespace g31::setup
