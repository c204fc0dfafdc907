#include "tools/evaluate/manual.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "tools/evaluate/evaluation.h"

namespace g31::evaluate {
namespace {

runtime::Entry entry_of(const KindRow& kind) {
  runtime::Entry entry{"evaluation", std::string(kind.word), std::string(kind.text), {}};
  entry.facts.push_back({"command", fmt::format("g31 evaluate {} FILE.csv", kind.word)});
  entry.facts.push_back({"columns", std::string(kind.columns)});
  for (const OptionRow& option : options()) {
    if (belongs_to(option, kind.kind)) {
      entry.facts.push_back(
          {fmt::format("{} {}", option.option, option.value), std::string(option.text)});
    }
  }
  for (const ResultRow& result : results()) {
    if (belongs_to(result, kind.kind)) {
      entry.facts.push_back({std::string(result.name), std::string(result.text)});
    }
  }
  return entry;
}

runtime::Entry entry_of(const ResultRow& result) {
  return {"result of an evaluation",
          std::string(result.name),
          std::string(result.text),
          {{"of", std::string(result.kinds)}}};
}

}  // namespace

runtime::Entries explain(std::string_view topic) {
  runtime::Entries found;
  for (const KindRow& kind : kinds()) {
    if (kind.word == topic) {
      found.push_back(entry_of(kind));
    }
  }
  for (const ResultRow& result : results()) {
    if (topic.size() > 1 && names(result, topic)) {
      found.push_back(entry_of(result));
    }
  }
  return found;
}

runtime::Entries everything() {
  runtime::Entries all;
  for (const KindRow& kind : kinds()) {
    all.push_back(entry_of(kind));
  }
  return all;
}

}  // namespace g31::evaluate
