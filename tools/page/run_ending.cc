#include <fmt/format.h>

#include "interpreter/source/readable_text.h"
#include "tools/page/html.h"
#include "tools/page/run_parts.h"

namespace g31::page {
namespace {

std::string place_text(const AxisPositions& q) {
  return fmt::format("X {} Y {} Z {}", number(q[0], 3), number(q[1], 3), number(q[2], 3));
}

/// Shows frames of a run.
struct Frames {
  const source::SourceMap& sources;
  const FileNames& names;

  [[nodiscard]] Frame at(const std::string& program, const source::Location& where) const {
    const source::ShownPlace place = sources.show(where);
    return {program, names.at(place), source::readable_text(place.text)};
  }

  /// The innermost frame and those that called it.
  [[nodiscard]] std::vector<Frame> stack(const source::Location& where,
                                         const std::vector<runtime::CallSite>& calls) const {
    std::vector<Frame> stack = {at("", where)};
    for (const runtime::CallSite& call : calls) {
      stack.push_back(at(call.program, call.where));
    }
    return stack;
  }
};

void add_fault(const runtime::FaultEvent& fault, Language language, Ending& ending) {
  const auto fact = [&](Word name, std::string value) {
    ending.facts.emplace_back(text_of(name, language), std::move(value));
  };
  fact(Word::InMachineCoordinates, place_text(fault.q_M_at));
  fact(Word::InWorkCoordinates, place_text(fault.view.q_L));
  if (fault.contact) {
    const Point& p = fault.contact->p_M_point;
    fact(Word::Part, fault.contact->part);
    fact(Word::Contact,
         fmt::format("X {} Y {} Z {}", number(p.x(), 3), number(p.y(), 3), number(p.z(), 3)));
  }
  if (fault.move) {
    fact(Word::Commanded, place_text(fault.move->q_M_to));
    fact(Word::Feed, fault.move->feed_mm_min > 0.0 ? number(fault.move->feed_mm_min, 0) + " mm/min"
                                                   : std::string(text_of(Word::Rapid, language)));
  }
}

}  // namespace

std::optional<Ending> ending_of(const RunPage& run, const FileNames& names, Language language) {
  const runtime::Outcome& outcome = run.result.outcome;
  const Frames frames{run.sources, names};
  Ending ending;
  if (const auto& fault = run.recorder.fault()) {
    ending.title = fault->what;
    ending.stack = frames.stack(fault->where, fault->view.calls);
    add_fault(*fault, language, ending);
  } else if (outcome.alarm) {
    ending.title = fmt::format("{} {}", outcome.alarm->number, outcome.alarm->text);
    ending.stack = frames.stack(outcome.alarm->where, outcome.alarm->calls);
    if (!outcome.alarm->detail.empty()) {
      ending.facts.emplace_back(text_of(Word::Detail, language), outcome.alarm->detail);
    }
  } else {
    return std::nullopt;
  }
  for (const auto& [name, value] : run.result.locals) {
    ending.variables.emplace_back(name, shown_value(value));
  }
  return ending;
}

}  // namespace g31::page
