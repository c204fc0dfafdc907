#include "interpreter/dialects/sinumerik/state/compensation_data.h"

#include <cmath>

#include <fmt/format.h>

#include "machine/units/axis_positions.h"

namespace g31::sinumerik {
namespace {

double kept(const ChannelState& state, SystemId id, std::vector<int> indices) {
  const auto found = state.kept_data.find({id, 0, std::move(indices)});
  return found != state.kept_data.end() ? found->second : 0.0;
}

/// Where the points of a table are.
struct Range {
  double first = 0.0;
  double last = 0.0;
  double step = 0.0;
  bool goes_round = false;

  /// Of the points; 0: there is no table.
  [[nodiscard]] double count() const {
    constexpr double kRounding = 1e-6;
    return step > 0.0 && last >= first ? std::floor((last - first) / step + kRounding) + 1.0 : 0.0;
  }
};

/// A positive value of a table moves its axis in the negative direction.
constexpr double kSense = -1.0;

/// @param value  of point n
template <typename Value>
machine::CompensationTable::Factor factor_of(const Range& range, int moving, const Value& value) {
  machine::CompensationTable::Factor factor;
  factor.axis = moving;
  const int count = static_cast<int>(range.count());
  for (int n = 0; n < count; ++n) {
    factor.points.emplace_back(range.first + n * range.step, value(n));
  }
  factor.period = range.goes_round ? range.last - range.first : 0.0;
  return factor;
}

/// Of an axis.
constexpr int kEncoders = 2;

bool is_of_machine(double axis) {
  return axis >= 0.0 && axis < static_cast<double>(kAxisCount);
}

}  // namespace

CompensationData::CompensationData(const Globals& globals)
    : encoder_enable_(globals.place("$MA_ENC_COMP_ENABLE")),
      sag_enable_(globals.place("$MA_CEC_ENABLE")),
      table_enable_(globals.place("$SN_CEC_TABLE_ENABLE")),
      table_weight_(globals.place("$SN_CEC_TABLE_WEIGHT")),
      most_points_(globals.place("$MN_MM_CEC_MAX_POINTS")),
      activated_((kEncoders + 1) * kAxisCount) {}

bool CompensationData::is_of_encoder(SystemId id) {
  return id == SystemId::EncoderTable || id == SystemId::EncoderTableStep ||
         id == SystemId::EncoderTableBegin || id == SystemId::EncoderTableEnd ||
         id == SystemId::EncoderTableModulo;
}

void CompensationData::activate(const ChannelState& state) {
  const auto from = [&](std::size_t place) {
    return state.numbers.begin() + static_cast<std::ptrdiff_t>(place);
  };
  activated_.assign(from(encoder_enable_), from(encoder_enable_) + kEncoders * kAxisCount);
  activated_.insert(activated_.end(), from(sag_enable_), from(sag_enable_) + kAxisCount);
}

bool CompensationData::is_protected(const ChannelState& state, SystemId id,
                                    const std::vector<int>& indices) const {
  const auto is_on = [&](std::size_t place, std::size_t among_activated) {
    return state.numbers[place] != 0.0 && activated_[among_activated] != 0.0;
  };
  if (is_of_encoder(id)) {
    const int encoder = indices.front();
    const int axis = indices.back();
    const std::size_t datum =
        static_cast<std::size_t>(encoder) * kAxisCount + static_cast<std::size_t>(axis);
    return encoder < kEncoders && is_of_machine(axis) && is_on(encoder_enable_ + datum, datum);
  }
  const auto output = state.kept_data.find({SystemId::SagTableOutput, 0, {indices.front()}});
  if (output == state.kept_data.end() || !is_of_machine(output->second)) {
    return false;
  }
  const auto axis = static_cast<std::size_t>(output->second);
  return is_on(sag_enable_ + axis, kEncoders * kAxisCount + axis);
}

int CompensationData::most_points(const ChannelState& state, int table) const {
  return static_cast<int>(state.numbers[most_points_ + static_cast<std::size_t>(table)]);
}

bool CompensationData::enabling_changed(const ChannelState& state) {
  enabling_.resize(2 * kAxisCount + 2 * kSagTables);
  bool is_other = false;
  auto seen = enabling_.begin();
  const auto look = [&](std::size_t place, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i, ++seen) {
      is_other = is_other || *seen != state.numbers[place + i];
      *seen = state.numbers[place + i];
    }
  };
  look(encoder_enable_, kAxisCount);
  look(sag_enable_, kAxisCount);
  look(table_enable_, kSagTables);
  look(table_weight_, kSagTables);
  return is_other;
}

MaybeFailure CompensationData::add_encoder_table(const ChannelState& state, int axis,
                                                 Tables& tables) const {
  const std::vector<int> first_encoder = {0, axis};
  const Range range{kept(state, SystemId::EncoderTableBegin, first_encoder),
                    kept(state, SystemId::EncoderTableEnd, first_encoder),
                    kept(state, SystemId::EncoderTableStep, first_encoder),
                    kept(state, SystemId::EncoderTableModulo, first_encoder) != 0.0};
  if (range.count() > kMostPoints) {
    return failure(
        AlarmId::ValueOutOfLimits,
        fmt::format("$AA_ENC_COMP of {}: {:g} points, {} at most",
                    kAxisLetters[static_cast<std::size_t>(axis)], range.count(), kMostPoints));
  }
  if (range.count() >= 1.0) {
    machine::CompensationTable table;
    table.compensated = axis;
    table.factors.push_back(factor_of(range, axis, [&](int n) {
      return kSense * kept(state, SystemId::EncoderTable, {0, n, axis});
    }));
    tables.push_back(std::move(table));
  }
  return std::nullopt;
}

Result<std::optional<CompensationData::Factor>, Failure> CompensationData::sag_factor(
    const ChannelState& state, int table, double weight) const {
  const auto input = state.kept_data.find({SystemId::SagTableInput, 0, {table}});
  const Range range{kept(state, SystemId::SagTableBegin, {table}),
                    kept(state, SystemId::SagTableEnd, {table}),
                    kept(state, SystemId::SagTableStep, {table}),
                    kept(state, SystemId::SagTableModulo, {table}) != 0.0};
  if (input == state.kept_data.end() || !is_of_machine(input->second) || range.count() < 1.0) {
    return std::optional<Factor>();
  }
  if (range.count() > most_points(state, table)) {
    return failure(AlarmId::ValueOutOfLimits,
                   fmt::format("$AN_CEC[{}]: {:g} points, $MN_MM_CEC_MAX_POINTS says {}", table,
                               range.count(), most_points(state, table)));
  }
  return std::optional(factor_of(range, static_cast<int>(input->second), [&](int n) {
    return weight * kept(state, SystemId::SagTable, {table, n});
  }));
}

MaybeFailure CompensationData::add_sag_table(const ChannelState& state, int table,
                                             Tables& tables) const {
  const auto output = state.kept_data.find({SystemId::SagTableOutput, 0, {table}});
  if (output == state.kept_data.end() || !is_of_machine(output->second) ||
      state.numbers[sag_enable_ + static_cast<std::size_t>(output->second)] == 0.0) {
    return std::nullopt;
  }
  const double weight = state.numbers[table_weight_ + static_cast<std::size_t>(table)];
  const auto own = sag_factor(state, table, kSense * weight);
  if (!own) {
    return own.error();
  }
  if (!own.value()) {
    return std::nullopt;
  }
  machine::CompensationTable made;
  made.compensated = static_cast<int>(output->second);
  made.direction = static_cast<int>(kept(state, SystemId::SagTableDirection, {table}));
  made.factors.push_back(*own.value());
  if (const double number = kept(state, SystemId::SagTableFactor, {table}); number != 0.0) {
    const auto other = sag_factor(state, static_cast<int>(number) - 1, 1.0);
    if (!other) {
      return other.error();
    }
    if (!other.value()) {
      return failure(AlarmId::ValueOutOfLimits,
                     fmt::format("$AN_CEC_MULT_BY_TABLE[{}]: there is no table of number {:g}",
                                 table, number));
    }
    made.factors.push_back(*other.value());
  }
  tables.push_back(std::move(made));
  return std::nullopt;
}

Result<std::optional<std::vector<machine::CompensationTable>>, Failure> CompensationData::changed(
    const ChannelState& state) {
  if (!has_tables_) {
    return std::optional<Tables>();
  }
  const bool is_other = enabling_changed(state);
  if (!is_other && !is_new_) {
    return std::optional<Tables>();
  }
  is_new_ = false;
  Tables tables;
  for (int axis = 0; axis < static_cast<int>(kAxisCount); ++axis) {
    if (state.numbers[encoder_enable_ + static_cast<std::size_t>(axis)] != 0.0) {
      if (MaybeFailure wrong = add_encoder_table(state, axis, tables)) {
        return *wrong;
      }
    }
  }
  for (int table = 0; table < kSagTables; ++table) {
    if (state.numbers[table_enable_ + static_cast<std::size_t>(table)] != 0.0) {
      if (MaybeFailure wrong = add_sag_table(state, table, tables)) {
        return *wrong;
      }
    }
  }
  return std::optional(std::move(tables));
}

}  // namespace g31::sinumerik
