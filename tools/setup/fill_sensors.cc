#include "tools/setup/fill_sensors.h"

#include <map>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "tools/setup/table_keys.h"

namespace g31::setup {
namespace {

constexpr int kFirstWord = 1132;
constexpr int kLastWord = 1135;
constexpr int kInputs = 8;
constexpr double kUsualCountMm = 1e-4;
/// What a word of 32 bits counts to.
constexpr double kMostCounts = 2147483647.0;

std::vector<SheetTable> sensor_tables(const Sheet& sheet) {
  const auto list = sheet.lists.find(SectionId::Sensor);
  return list != sheet.lists.end() ? list->second : std::vector<SheetTable>();
}

/// The number of a key, else the usual one, which is taken in turn.
int number_or(const TableKeys& keys, KeyId id, std::size_t usual) {
  return static_cast<int>(keys.get(id, static_cast<double>(usual)));
}

Location place_of(const SheetTable& table, KeyId id) {
  const Entry* const entry = TableKeys(table).find(id);
  return entry != nullptr ? entry->where : table.where;
}

/// A sensor that reaches farther than any part is a mistake, and its numbers might not be numbers.
void check_lengths(const SheetTable& table, ErrorList& errors) {
  constexpr double kFarthestMm = 1e6;
  const TableKeys keys(table);
  for (const auto& [id, key] :
       {std::pair(KeyId::SensorRange, "range"), std::pair(KeyId::SensorSpot, "spot"),
        std::pair(KeyId::SensorNoise, "noise"), std::pair(KeyId::SensorResolution, "resolution")}) {
    const Entry* const entry = keys.find(id);
    if (entry != nullptr && number_of(*entry) > kFarthestMm) {
      errors.add(SetupErrorId::OutOfRange, entry->where,
                 {fmt::format("sensor.{}", key), fmt::format("{}", number_of(*entry)),
                  "1000000 mm at most"});
    }
  }
  const Point at = point_from(keys, KeyId::SensorAt);
  if (at.cwiseAbs().maxCoeff() > kFarthestMm) {
    errors.add(
        SetupErrorId::OutOfRange, place_of(table, KeyId::SensorAt),
        {"sensor.at", fmt::format("[{}, {}, {}]", at.x(), at.y(), at.z()), "1000000 mm at most"});
  }
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

}  // namespace

std::vector<probe::DisplacementSetup> sensors_from(const Sheet& sheet, ErrorList& errors) {
  std::vector<probe::DisplacementSetup> sensors;
  Taken<std::string> names(errors);
  Taken<int> inputs(errors);
  for (const SheetTable& table : sensor_tables(sheet)) {
    check_lengths(table, errors);
    const probe::DisplacementSetup sensor = sensor_from(table, sensors.size() + 1);
    if (sensor.input > kInputs) {
      errors.add(SetupErrorId::TooManySensors, table.where, {std::to_string(kInputs)});
      break;
    }
    names.take(sensor.name, "name", sensor.name, place_of(table, KeyId::SensorName));
    inputs.take(sensor.input, "input", sensor.name, place_of(table, KeyId::SensorInput));
    if (sensor.resolution_mm > 0.0 && sensor.range_mm / sensor.resolution_mm > kMostCounts) {
      errors.add(SetupErrorId::OutOfRange, place_of(table, KeyId::SensorResolution),
                 {"sensor.resolution", fmt::format("{}", sensor.resolution_mm),
                  "so much that the range is 2147483647 counts at most"});
    }
    sensors.push_back(sensor);
  }
  return sensors;
}

std::vector<runtime::SensorWord> sensor_words_from(const Sheet& sheet, ErrorList& errors) {
  std::vector<runtime::SensorWord> words;
  Taken<int> taken(errors);
  std::size_t order = 0;
  for (const SheetTable& table : sensor_tables(sheet)) {
    const TableKeys keys(table);
    const probe::DisplacementSetup sensor = sensor_from(table, ++order);
    int word = number_or(keys, KeyId::SensorWord, kFirstWord - 1 + order);
    if (word > kLastWord) {
      continue;  // the words are used up; SINUMERIK has more inputs
    }
    word += word < 1000 ? 1000 : 0;
    taken.take(word, "word", sensor.name, place_of(table, KeyId::SensorWord));
    words.push_back(
        {word, sensor.input, sensor.resolution_mm > 0.0 ? sensor.resolution_mm : kUsualCountMm});
  }
  return words;
}

}  // namespace g31::setup
