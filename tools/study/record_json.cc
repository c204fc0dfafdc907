#include "tools/study/record_json.h"

#include <nlohmann/json.hpp>

#include "machine/base/contract.h"
#include "machine/base/json_nesting.h"

namespace g31::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kWhole = "g31.study/1";
constexpr const char* kShard = "g31.study.shard/1";

constexpr const char* kUncertaintyContains =
    "of one reading: 2 standard deviations, and |bias| where a value is expected; the "
    "repeatability "
    "of the simulated probe and what the study varies; not the uncertainty of the expected value";

Json optional_json(const std::optional<double>& number) {
  return number ? Json(*number) : Json();
}

std::optional<double> optional_from(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

const char* name_of(TableForm form) {
  switch (form) {
    case TableForm::Summary:
      return "summary";
    case TableForm::Readings:
      return "readings";
    case TableForm::Comparison:
      return "comparison";
  }
  contract_violated("every table form has a name", __FILE__, __LINE__);
}

TableForm form_from(const std::string& name) {
  if (name == "readings") {
    return TableForm::Readings;
  }
  return name == "comparison" ? TableForm::Comparison : TableForm::Summary;
}

Json result_json(const ResultForm& result) {
  Json json = {{"name", result.name},
               {"unit", result.unit},
               {"expected", optional_json(result.expected)},
               {"resolution", optional_json(result.resolution)},
               {"nominal", result.nominal},
               {"tolerance", result.tolerance}};
  if (!result.published.empty()) {
    json["published"] = result.published;
  }
  return json;
}

ResultForm result_from(const Json& json) {
  return {json.at("name").get<std::string>(),
          json.at("unit").get<std::string>(),
          optional_from(json.at("expected")),
          optional_from(json.at("resolution")),
          json.at("nominal").get<std::string>(),
          json.at("tolerance").get<std::string>(),
          json.value("published", std::vector<double>())};
}

Json description_json(const Description& d) {
  Json json = {{"name", d.name},
               {"program", d.program},
               {"control", d.control},
               {"seed", d.seed},
               {"repeats", d.repeats},
               {"confidence_percent", d.confidence_percent},
               {"table", name_of(d.table)},
               {"assumes", d.assumes},
               {"inputs", d.inputs}};
  json["results"] = Json::array();
  for (const ResultForm& result : d.results) {
    json["results"].push_back(result_json(result));
  }
  json["listed"] = d.listed;
  json["combinations"] = d.points;
  json["drawn"] = d.drawn;
  return json;
}

Description description_from(const Json& json) {
  Description d;
  d.name = json.at("name").get<std::string>();
  d.program = json.at("program").get<std::string>();
  d.control = json.at("control").get<std::string>();
  d.seed = json.at("seed").get<std::uint64_t>();
  d.repeats = json.at("repeats").get<std::size_t>();
  d.confidence_percent = json.at("confidence_percent").get<double>();
  d.table = form_from(json.at("table").get<std::string>());
  d.assumes = json.at("assumes").get<std::vector<std::string>>();
  d.inputs = json.at("inputs").get<std::string>();
  for (const Json& result : json.at("results")) {
    d.results.push_back(result_from(result));
  }
  d.listed = json.at("listed").get<std::vector<std::string>>();
  d.points = json.at("combinations").get<std::vector<std::vector<std::string>>>();
  d.drawn = json.at("drawn").get<std::vector<std::string>>();
  return d;
}

Json row_json(const Row& row) {
  Json json = {
      {"run", row.run + 1}, {"seed", row.seed}, {"status", row.status}, {"exit", row.exit_code}};
  if (!row.drawn.empty()) {
    json["drawn"] = row.drawn;
  }
  json["results"] = Json::array();
  for (const auto& result : row.results) {
    json["results"].push_back(optional_json(result));
  }
  if (!row.note.empty()) {
    json["note"] = row.note;
  }
  return json;
}

Row row_from(const Json& json) {
  Row row;
  row.run = json.at("run").get<std::size_t>() - 1;
  row.seed = json.at("seed").get<std::uint64_t>();
  row.status = json.at("status").get<std::string>();
  row.exit_code = json.at("exit").get<int>();
  row.drawn = json.value("drawn", std::vector<double>());
  for (const Json& result : json.at("results")) {
    row.results.push_back(optional_from(result));
  }
  row.note = json.value("note", std::string());
  return row;
}

Json summary_json(const Summary& summary) {
  Json interval;
  if (summary.mean_confidence) {
    interval = {summary.mean_confidence->low, summary.mean_confidence->high};
  }
  return {{"n", summary.n},
          {"mean", optional_json(summary.mean)},
          {"standard_deviation", optional_json(summary.standard_deviation)},
          {"mean_confidence", interval},
          {"expanded_uncertainty", optional_json(summary.expanded_uncertainty)},
          {"min", optional_json(summary.min)},
          {"max", optional_json(summary.max)},
          {"bias", optional_json(summary.bias)}};
}

Json point_json(const Record& record, std::size_t point) {
  const Description& d = record.description;
  Json json = {{"values", Json::object()}, {"results", Json::object()}};
  for (std::size_t i = 0; i < d.listed.size(); ++i) {
    json["values"][d.listed[i]] = d.points[point][i];
  }
  for (std::size_t i = 0; i < d.results.size(); ++i) {
    const Summary summary = summary_of(record, point, i);
    Json& result = json["results"][d.results[i].name];
    result = summary_json(summary);
    for (const double value : d.results[i].published) {
      result["published"].push_back(
          {{"value", value}, {"z", optional_json(z_score(value, summary))}});
    }
  }
  return json;
}

/// Why the parts of a document that was read do not fit each other; "" when they do.
std::string why_crooked(const Record& record) {
  const Description& d = record.description;
  for (const auto& point : d.points) {
    if (point.size() != d.listed.size()) {
      return "a combination does not have one value for each list";
    }
  }
  if (d.repeats == 0 || d.points.empty() || !(d.confidence_percent > 0.0) ||
      !(d.confidence_percent < 100.0)) {
    return "repeats, combinations or confidence do not make up a study";
  }
  for (const Row& row : record.rows) {
    const bool fits = row.results.size() == d.results.size() &&
                      row.drawn.size() == d.drawn.size() && row.run / d.repeats < d.points.size();
    if (!fits) {
      return "a row does not fit the study it stands in";
    }
  }
  return {};
}

}  // namespace

std::string record_json(const Record& record) {
  Json json = {{"schema", record.shard ? kShard : kWhole},
               {"study", description_json(record.description)}};
  if (record.shard) {
    json["shard"] = {{"index", record.shard->index}, {"of", record.shard->of}};
  } else {
    json["coverage_factor"] = kCoverageFactor;
    json["expanded_uncertainty_contains"] = kUncertaintyContains;
    json["points"] = Json::array();
    for (std::size_t point = 0; point < record.description.points.size(); ++point) {
      json["points"].push_back(point_json(record, point));
    }
  }
  json["runs"] = Json::object();
  for (const auto& [status, count] : count_by_status(record)) {
    json["runs"][status] = count;
  }
  // One row a line: thousands of rows are to be read by people, too.
  std::string rows;
  for (const Row& row : record.rows) {
    rows += (rows.empty() ? "\n  " : ",\n  ") +
            row_json(row).dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  std::string text = json.dump(1, ' ', false, Json::error_handler_t::replace);
  text.resize(text.size() - 2);  // "\n}"
  return text + ",\n \"rows\": [" + rows + "\n ]\n}\n";
}

Result<Record, std::string> parse_record(std::string_view text) {
  if (nests_too_deep(text)) {
    return std::string("lists stand too deep inside one another in it");
  }
  try {
    const Json json = Json::parse(text);
    const auto schema = json.at("schema").get<std::string>();
    if (schema != kWhole && schema != kShard) {
      return "its schema is " + schema + ", not " + kShard;
    }
    Record record;
    record.description = description_from(json.at("study"));
    if (schema == kShard) {
      record.shard = Shard{json.at("shard").at("index").get<std::size_t>(),
                           json.at("shard").at("of").get<std::size_t>()};
    }
    for (const Json& row : json.at("rows")) {
      record.rows.push_back(row_from(row));
    }
    const std::string crooked = why_crooked(record);
    return crooked.empty() ? Result<Record, std::string>(std::move(record)) : crooked;
  } catch (const Json::parse_error&) {
    return std::string("it is no JSON document, or not all of one");
  } catch (const Json::exception&) {
    return std::string(
        "it is not as g31 study --shard K/N --json FILE has written it: write it anew");
  }
}

bool same_study(const Description& a, const Description& b) {
  return description_json(a) == description_json(b);
}

}  // namespace g31::study
