#include "tools/evaluate/evaluation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "machine/base/contract.h"
#include "tools/evaluate/document_writer.h"

namespace g31::evaluate {
namespace {

using Json = nlohmann::ordered_json;

constexpr KindRow kKindRows[] = {
#define EVALUATION_KIND(name, word, columns, leads, text) {Kind::name, word, columns, leads, text},
#include "tools/evaluate/evaluation_kinds.def"
#undef EVALUATION_KIND
};

constexpr OptionRow kOptionRows[] = {
#define EVALUATION_OPTION(name, option, value, kinds, text) \
  {OptionId::name, option, value, kinds, text},
#include "tools/evaluate/evaluation_options.def"
#undef EVALUATION_OPTION
};

constexpr ResultRow kResultRows[] = {
#define EVALUATION_RESULT(kinds, name, unit, text) {kinds, name, unit, text},
#include "tools/evaluate/evaluation_results.def"
#undef EVALUATION_RESULT
};

/// @param words  blanks between them
bool holds(std::string_view words, Kind kind) {
  return fmt::format(" {} ", words).find(fmt::format(" {} ", info(kind).word)) != std::string::npos;
}

bool has_row(const Quantity& quantity, Kind kind) {
  return std::ranges::any_of(kResultRows, [&](const ResultRow& row) {
    return belongs_to(row, kind) && names(row, quantity.name) && row.unit == quantity.unit;
  });
}

/// Adding 0 makes a zero of -0.
Json number_or_null(const std::optional<double>& value) {
  return value ? Json(*value + 0.0) : Json(nullptr);
}

void write_results(DocumentWriter& writer, const Evaluation& evaluation) {
  writer.begin_object();
  for (const Quantity& quantity : evaluation.results) {
    G31_EXPECTS(has_row(quantity, evaluation.kind));
    Json result = {{"value", number_or_null(quantity.value)}, {"unit", quantity.unit}};
    if (quantity.u) {
      result["u"] = *quantity.u;
    }
    writer.name(quantity.name);
    writer.value(result);
  }
  if (evaluation.dips) {
    writer.name("dips");
    writer.begin_list();
    for (const Dip& dip : *evaluation.dips) {
      writer.value({{"time", dip.time_s}, {"speed", dip.speed_mm_min}, {"width", dip.width_s}});
    }
    writer.end();
  }
  writer.end();
}

void write_curves(DocumentWriter& writer, const std::vector<Curve>& curves) {
  writer.begin_object();
  for (const Curve& curve : curves) {
    writer.name(curve.name);
    writer.begin_list();
    for (const auto& point : curve.points) {
      writer.value(point);
    }
    writer.end();
  }
  writer.end();
}

std::string with_digits(double value) {
  return fmt::format("{:.6g}", value + 0.0);
}

/// The same, but lengths in mm to the nanometre, however long: a centre may lie a metre away.
std::string with_digits(double value, std::string_view unit) {
  if (unit != "mm" || std::abs(value) < 1.0) {
    return with_digits(value);
  }
  std::string text = fmt::format("{:.6f}", value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') {
    text.pop_back();
  }
  return text;
}

}  // namespace

std::span<const OptionRow> options() {
  return kOptionRows;
}

bool belongs_to(const OptionRow& option, Kind kind) {
  return holds(option.kinds, kind);
}

std::span<const ResultRow> results() {
  return kResultRows;
}

bool belongs_to(const ResultRow& result, Kind kind) {
  return holds(result.kinds, kind);
}

bool names(const ResultRow& result, std::string_view name) {
  return std::ranges::equal(result.name, name, [](char row, char c) {
    const bool is_one = (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
    return row == '*' ? is_one : row == c;
  });
}

std::span<const KindRow> kinds() {
  return kKindRows;
}

const KindRow& info(Kind kind) {
  return *std::ranges::find(kKindRows, kind, &KindRow::kind);
}

std::optional<int> decimals_by_u(const Quantity& quantity) {
  constexpr double kSmallest = 1e-9;
  if (!quantity.u || *quantity.u < kSmallest || *quantity.u >= 1.0) {
    return std::nullopt;
  }
  return 1 - static_cast<int>(std::floor(std::log10(*quantity.u)));
}

std::vector<const Quantity*> leading(const Evaluation& evaluation) {
  std::vector<const Quantity*> found;
  std::string_view leads = info(evaluation.kind).leads;
  while (!leads.empty()) {
    const std::size_t end = std::min(leads.find(' '), leads.size());
    const ResultRow lead{"", leads.substr(0, end), "", ""};
    leads.remove_prefix(std::min(end + 1, leads.size()));
    const Quantity* largest = nullptr;
    for (const Quantity& quantity : evaluation.results) {
      if (quantity.value && names(lead, quantity.name) &&
          (!largest || std::abs(*quantity.value) > std::abs(*largest->value))) {
        largest = &quantity;
      }
    }
    if (largest) {
      found.push_back(largest);
    }
  }
  if (found.empty() && !evaluation.results.empty()) {
    found.push_back(&evaluation.results.front());
  }
  return found;
}

std::string lower(std::string_view axis) {
  return {static_cast<char>(axis.front() - 'A' + 'a')};
}

std::string evaluation_document(const Evaluation& evaluation, bool with_curves,
                                const plot::Growth& growth) {
  DocumentWriter writer(growth);
  writer.begin_object();
  writer.name("schema");
  writer.value("g31.evaluation/1");
  writer.name("kind");
  writer.value(info(evaluation.kind).word);
  writer.name("samples");
  writer.value(evaluation.samples);
  writer.name("results");
  write_results(writer, evaluation);
  if (with_curves) {
    writer.name("curves");
    write_curves(writer, evaluation.curves);
  }
  writer.name("notes");
  writer.value(evaluation.notes);
  writer.end();
  return writer.finish();
}

std::string evaluation_table(const Evaluation& evaluation, const plot::Growth& growth) {
  std::string text =
      fmt::format("{}, {} samples\n", info(evaluation.kind).word, evaluation.samples);
  for (const Quantity& quantity : evaluation.results) {
    const std::string u =
        quantity.u ? fmt::format("  u {}", with_digits(*quantity.u, quantity.unit)) : "";
    text += fmt::format("  {:<32} {:>12} {:<6}{}\n", quantity.name,
                        quantity.value ? with_digits(*quantity.value, quantity.unit) : "-",
                        quantity.unit, u);
  }
  if (evaluation.dips) {
    std::size_t told = 0;
    for (const Dip& dip : *evaluation.dips) {
      text += fmt::format("  dip at {} s: {} mm/min, {} s wide\n", with_digits(dip.time_s),
                          with_digits(dip.speed_mm_min), with_digits(dip.width_s));
      if (growth) {
        growth(text.size() - std::exchange(told, text.size()));
      }
    }
  }
  for (const std::string& note : evaluation.notes) {
    text += fmt::format("note: {}\n", note);
  }
  return text;
}

}  // namespace g31::evaluate
