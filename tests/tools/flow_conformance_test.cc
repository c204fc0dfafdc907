// Every conformance case goes along the edges of its flow.

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "interpreter/analysis/program_set.h"
#include "interpreter/runtime/block_listener.h"
#include "interpreter/runtime/observer.h"
#include "tests/support/conformance_run.h"
#include "tests/support/effort.h"
#include "tests/support/temporary_folder.h"
#include "tools/disk/disk.h"
#include "tools/disk/shipped.h"
#include "tools/session/prepare.h"
#include "tools/session/run.h"
#include "tools/session/world.h"

namespace g31::flow_conformance_test {
namespace {

using analysis::Block;
using analysis::BlockIndex;
using analysis::Edge;
using analysis::Flow;
using testing::ConformanceCase;

constexpr std::uint64_t kMostBlocks = 60;

/// The first blocks of a run.
class FirstBlocks final : public runtime::BlockListener {
 public:
  runtime::Verdict on_block(const runtime::BlockPlace& place) override {
    places.push_back(place);
    return place.number < kMostBlocks ? runtime::Verdict::Run : runtime::Verdict::Stop;
  }
  std::vector<runtime::BlockPlace> places;
};

/// Blocks of one flow that begin at one place: an IF with THEN and its statement are two.
struct Standing {
  const Flow* flow = nullptr;
  std::vector<BlockIndex> blocks;
};

bool is_label(const Flow& flow, BlockIndex block) {
  return std::ranges::find(flow.labels, block, &analysis::Label::block) != flow.labels.end();
}

bool has_edge(const Flow& flow, BlockIndex from, BlockIndex to) {
  const auto edges = flow.edges_of(flow.blocks[from]);
  return std::ranges::find(edges, to, &Edge::to) != edges.end();
}

/// Whether the flow has a way from one block to another.  The head of a SINUMERIK loop is asked
/// again without counting as a block.  A repeated call starts again where it began: at the first
/// block of a program, at the label of M97.
bool leads(const Flow& flow, BlockIndex from, BlockIndex to) {
  const Block& block = flow.blocks[from];
  const bool restarts =
      (block.leaves.by_return || block.leaves.by_end) && (to == 0 || is_label(flow, to));
  if (from == to || has_edge(flow, from, to) || restarts ||
      (block.to_any_label && is_label(flow, to))) {
    return true;
  }
  return std::ranges::any_of(flow.edges_of(block), [&](const Edge& edge) {
    return edge.kind == analysis::EdgeKind::Jump && edge.to <= from && has_edge(flow, edge.to, to);
  });
}

bool leads(const Standing& from, const Standing& to) {
  return from.flow == to.flow && std::ranges::any_of(from.blocks, [&](BlockIndex a) {
           return std::ranges::any_of(to.blocks,
                                      [&](BlockIndex b) { return leads(*from.flow, a, b); });
         });
}

/// One case: its flows, and runs of it.
class Walked {
 public:
  Walked(const ConformanceCase& test, const std::string& control, const std::string& file) {
    session::Request request;
    path_ = folder_.write(file, test.program);
    request.programs = {path_};
    request.setups = {folder_.write("sheet.toml", testing::sheet_of(test))};
    request.control = control;
    const auto prepared = session::prepare(request, disk_);
    if (!prepared) {
      return;
    }
    prepared_ = std::make_unique<session::Prepared>(prepared.value());
    const auto opened =
        session::open_programs(prepared_->control, request, disk_, prepared_->job.control);
    programs_ = opened ? opened.value() : nullptr;
    const auto* const fanuc = std::get_if<session::FanucControl>(&prepared_->control);
    set_ = fanuc != nullptr ? analysis::fanuc_programs(fanuc->profile, sources_)
                            : analysis::sinumerik_programs(sources_, prepared_->job.control);
    set_->add_file(path_);
    // Definition files among the shipped programs define names for all.
    const auto shipped =
        disk::shipped_folder(fanuc != nullptr ? "macros/fanuc" : "macros/sinumerik");
    if (shipped) {
      set_->add_folder(*shipped);
    }
    flows_ = set_->flows(path_);
  }

  /// "ALARM 12340 AT 1" for each call whose arguments are wrong, in the words of an expectation.
  [[nodiscard]] std::vector<std::string> wrong_calls() const {
    std::vector<std::string> found;
    for (const Flow& flow : flows_) {
      for (const analysis::Call& call : flow.calls) {
        if (const auto fault = set_->wrong_arguments(flow, call)) {
          const auto place = sources_.show(flow.file->at(fault->where.widened()));
          found.push_back(fmt::format("ALARM {} AT {}", fault->alarm, place.line));
        }
      }
    }
    return found;
  }

  /// Follows the run block by block.  @returns how many ways were held against the flow
  int follow(const std::string& place) {
    int held = 0;
    for (const runtime::BlockPlace& block : programs_ != nullptr ? first_blocks() : Places()) {
      const bool is_here = programs_->sources().show(block.where).file == path_;
      const Standing now = is_here ? standing_at(block.where.begin) : Standing();
      if (now.flow != nullptr) {
        held += held_against(block.depth, now, place);
      }
    }
    return held;
  }

 private:
  using Places = std::vector<runtime::BlockPlace>;

  int held_against(std::size_t depth, const Standing& now, const std::string& place) {
    const bool is_entered = depth > depth_;
    const bool has_returned = depth < depth_;
    std::optional<Standing>& last = last_[depth];
    const bool is_known = last && !is_entered;
    if (is_known) {
      // A called program may send its caller to a label, or behind it.
      const bool may_be_sent = has_returned || had_returned_;
      const bool sent =
          may_be_sent && std::ranges::any_of(now.blocks, [&](BlockIndex block) {
            return is_label(*now.flow, block) || (block > 0 && is_label(*now.flow, block - 1));
          });
      EXPECT_TRUE(sent || leads(*last, now))
          << place << ": no way from block " << last->blocks.front() << " to " << now.blocks.front()
          << " of " << now.flow->program;
    }
    // On entering, a Fanuc shows the first block before it knows where it begins.
    last = is_entered ? std::nullopt : std::optional(now);
    depth_ = depth;
    had_returned_ = has_returned;
    return is_known ? 1 : 0;
  }

  Places first_blocks() {
    FirstBlocks heard;
    const auto world = session::build_world(prepared_->job, 0);
    runtime::Observer nobody;
    if (!world) {
      return {};
    }
    const auto run = session::Run::open(prepared_->job, *programs_, *world.value().machine, nobody);
    if (run) {
      run.value()->session().begin({kMostBlocks, 20.0}, &heard);
      run.value()->session().advance();
      run.value()->session().finish();
    }
    return heard.places;
  }

  Standing standing_at(std::size_t offset) const {
    for (const Flow& flow : flows_) {
      Standing found{&flow, {}};
      for (BlockIndex i = 0; i < flow.blocks.size(); ++i) {
        if (flow.blocks[i].span.begin == offset) {
          found.blocks.push_back(i);
        }
      }
      if (!found.blocks.empty()) {
        return found;
      }
    }
    return {};
  }

  testing::TemporaryFolder folder_;
  disk::Disk disk_;
  source::SourceMap sources_{disk_};
  std::string path_;
  std::unique_ptr<session::Prepared> prepared_;
  std::shared_ptr<session::Programs> programs_;
  std::unique_ptr<analysis::ProgramSet> set_;
  std::vector<Flow> flows_;
  std::map<std::size_t, std::optional<Standing>> last_;
  std::size_t depth_ = 0;
  bool had_returned_ = false;  ///< a Fanuc shows the block of the call before it goes on
};

/// What was held against flows.
struct Held {
  int ways = 0;
  int wrong_calls = 0;
};

/// Also: wrong arguments of calls are those that a run refuses.
void follow_file(const std::string& path, const std::string& control, const std::string& file,
                 Held& held) {
  const auto cases = testing::read_conformance_file(path);
  ASSERT_TRUE(cases) << cases.error();
  for (const ConformanceCase& test : cases.value()) {
    const std::string on = control.empty() ? test.controls.front() : control;
    const std::string place = fmt::format("{}:{}: {}", path, test.title.line, test.title.text);
    Walked walked(test, on, file);
    held.ways += walked.follow(place);
    for (const std::string& told : walked.wrong_calls()) {
      EXPECT_NE(std::ranges::find(test.expectations, told, &ConformanceCase::Row::text),
                test.expectations.end())
          << place << ": " << told;
      ++held.wrong_calls;
    }
  }
}

TEST(FlowConformance, FanucRunsGoAlongTheEdges) {
  Held held;
  for (const std::string& name : testing::case_files("tests/conformance/fanuc")) {
    follow_file("tests/conformance/fanuc/" + name + ".nc", "", "case.nc", held);
  }
  EXPECT_GT(held.ways, 1000);
  RecordProperty("ways", held.ways);
}

TEST(FlowConformance, SinumerikRunsGoAlongTheEdges) {
  Held held;
  for (const std::string& name :
       testing::some_of(testing::case_files("tests/conformance/sinumerik"))) {
    follow_file("tests/conformance/sinumerik/" + name + ".mpf", "sinumerik-828d", "case.mpf", held);
  }
  EXPECT_GT(held.ways, testing::of_many(1000));
  if (!testing::under_sanitizers()) {
    EXPECT_EQ(held.wrong_calls, 8);  // alarms 12210 to 14510 of subprograms.mpf, texts.mpf
  }
  RecordProperty("ways", held.ways);
}

}  // namespace
}  // namespace g31::flow_conformance_test
