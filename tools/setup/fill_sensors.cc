#include "tools/setup/fill_sensors.h"

#include <map>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "tools/setup/table_keys.h"

namespace g31::setup {
namespace {

constexpr int kFirstWord = 1132;
constexpr int kLastWord = 1135;
constexpr int kShortWords = 1000;  // 132 is 1132
constexpr int kInputs = 8;
constexpr double kUsualCountMm = 1e-4;
/// What a word of 32 bits counts to.
constexpr double kMostCounts = 2147483647.0;

/// The number of a key, else the usual one, which is taken in turn.
int number_or(const TableKeys& keys, KeyId id, std::size_t usual) {
  return static_cast<int>(keys.get(id, static_cast<double>(usual)));
}

Location place_of(const SheetTable& table, KeyId id) {
  const Entry* const entry = TableKeys(table).find(id);
  return entry != nullptr ? entry->where : table.where;
}

/// Values that each sensor has for itself.
template <typename Value>
class Taken {
 public:
  explicit Taken(ErrorList& errors) : errors_(errors) {}

  void take(const Value& value, const char* key, const std::string& sensor, const Location& where) {
    const auto [first, is_free] = by_.try_emplace(value, sensor);
    if (!is_free) {
      errors_.add(SetupErrorId::SensorTwice, where, {key, fmt::format("{}", value), first->second},
                  "each sensor takes its own");
    }
  }

 private:
  ErrorList& errors_;
  std::map<Value, std::string> by_;
};

probe::DisplacementSetup sensor_from(const SheetTable& table, std::size_t order) {
  const TableKeys keys(table);
  probe::DisplacementSetup sensor;
  sensor.name = keys.get(KeyId::SensorName, fmt::format("sensor{}", order));
  sensor.input = number_or(keys, KeyId::SensorInput, order);
  sensor.p_T_at = point_from(keys, KeyId::SensorAt);
  if (keys.find(KeyId::SensorDirection) != nullptr) {
    const Point along = point_from(keys, KeyId::SensorDirection);
    // First to a size whose square is a number.
    sensor.along_T = (along / along.cwiseAbs().maxCoeff()).normalized();
  }
  sensor.range_mm = keys.get(KeyId::SensorRange, sensor.range_mm);
  sensor.resolution_mm = keys.get(KeyId::SensorResolution, sensor.resolution_mm);
  sensor.spot_mm = keys.get(KeyId::SensorSpot, sensor.spot_mm);
  sensor.noise_mm = keys.get(KeyId::SensorNoise, sensor.noise_mm);
  return sensor;
}

void check_resolution(const SheetTable& table, const probe::DisplacementSetup& sensor,
                      ErrorList& errors) {
  if (sensor.resolution_mm > 0.0 && sensor.range_mm / sensor.resolution_mm > kMostCounts) {
    errors.add(SetupErrorId::OutOfRange, place_of(table, KeyId::SensorResolution),
               {"sensor.resolution", fmt::format("{}", sensor.resolution_mm),
                "so large that the range is at most 2147483647 counts"});
  }
}

/// nullopt: the words are used up; SINUMERIK has more inputs.
std::optional<runtime::SensorWord> word_of(const SheetTable& table,
                                           const probe::DisplacementSetup& sensor,
                                           std::size_t order) {
  const int word = number_or(TableKeys(table), KeyId::SensorWord, kFirstWord - 1 + order);
  if (word > kLastWord) {
    return std::nullopt;
  }
  return runtime::SensorWord{word < kShortWords ? word + kShortWords : word, sensor.input,
                             sensor.resolution_mm > 0.0 ? sensor.resolution_mm : kUsualCountMm};
}

}  // namespace

void fill_sensors(Job& job, const Sheet& sheet, ErrorList& errors) {
  Taken<std::string> names(errors);
  Taken<int> inputs(errors);
  Taken<int> words(errors);
  for (const SheetTable& table : list_of(sheet, SectionId::Sensor)) {
    const std::size_t order = job.sensors.size() + 1;
    const probe::DisplacementSetup sensor = sensor_from(table, order);
    if (sensor.input > kInputs) {
      errors.add(SetupErrorId::TooManySensors, table.where, {std::to_string(kInputs)});
      return;
    }
    check_resolution(table, sensor, errors);
    names.take(sensor.name, "name", sensor.name, place_of(table, KeyId::SensorName));
    inputs.take(sensor.input, "input", sensor.name, place_of(table, KeyId::SensorInput));
    if (const auto word = word_of(table, sensor, order)) {
      words.take(word->number, "word", sensor.name, place_of(table, KeyId::SensorWord));
      job.control.sensor_words.push_back(*word);
    }
    job.sensors.push_back(sensor);
  }
}

}  // namespace g31::setup
