#include "interpreter/dialects/fanuc/parameters.h"

#include <charconv>

namespace g31::fanuc {

Result<Parameters, std::string> Parameters::from(const std::map<std::string, double>& entries) {
  Parameters parameters;
  for (const auto& [name, value] : entries) {
    const char* const end = name.data() + name.size();
    int number = 0;
    const auto after = std::from_chars(name.data(), end, number);
    if (after.ec != std::errc() || number <= 0) {
      return name;
    }
    if (after.ptr == end) {
      parameters.values_[number] = value;
      continue;
    }
    int bit = -1;
    const auto last = std::from_chars(after.ptr + 1, end, bit);
    if (*after.ptr != '.' || last.ptr != end || last.ec != std::errc() || bit < 0 || bit > 7) {
      return name;
    }
    parameters.bits_[{number, bit}] = value != 0.0;
  }
  return parameters;
}

double Parameters::value(int number, double otherwise) const {
  const auto found = values_.find(number);
  return found != values_.end() ? found->second : otherwise;
}

bool Parameters::bit(int number, int bit) const {
  const auto found = bits_.find({number, bit});
  return found != bits_.end() && found->second;
}

}  // namespace g31::fanuc
