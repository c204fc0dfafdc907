#include "tools/coverage/coverage.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace g31::coverage {
namespace {

struct CountedFile {
  std::string name;
  std::map<std::uint64_t, const CountedBlock*> blocks;  ///< by where they begin
};

/// The files by name.
std::vector<CountedFile> files_of(const BlockCounts& counts, const source::SourceMap& sources) {
  std::map<source::FileId, CountedFile> files;
  for (const CountedBlock& block : counts.blocks()) {
    CountedFile& file = files[block.where.file];
    if (file.blocks.empty()) {
      file.name = sources.show(block.where).file;
    }
    file.blocks.emplace(block.where.begin, &block);
  }
  std::vector<CountedFile> list;
  for (auto& [id, file] : files) {
    list.push_back(std::move(file));
  }
  std::ranges::sort(list, {}, &CountedFile::name);
  return list;
}

/// O9010(NAME) or <BORE>: where a program begins, nothing that runs.
bool is_program_head(std::string_view text) {
  std::size_t end = 0;
  if (text.starts_with('O') || text.starts_with(':')) {
    end = text.find_first_not_of("0123456789", 1);
  } else if (text.starts_with('<')) {
    end = text.find('>') + 1;
  }
  const std::size_t behind = text.find_first_not_of(" \t", end);
  return end > 1 && (behind == std::string_view::npos || text[behind] == '(');
}

/// How often a block ran.  The statement of a THEN begins where its IF does, and was counted, too.
std::uint64_t runs_of(const CountedBlock& counted, bool has_then) {
  return has_then ? counted.conditions[0] + counted.conditions[1] : counted.runs;
}

/// Blocks that never ran are there, too.
void add_lines(const analysis::Flow& flow, const CountedFile& file, const source::SourceMap& texts,
               FileCoverage& coverage) {
  for (std::size_t i = 0; i < flow.blocks.size(); ++i) {
    const analysis::Block& block = flow.blocks[i];
    const std::size_t length = block.span.end - block.span.begin;
    // The end of a SINUMERIK text is a block of its own, and of no line.
    if (length == 0 || is_program_head(flow.file->text().substr(block.span.begin, length))) {
      continue;
    }
    const source::Location where = flow.file->at(block.span.widened());
    const int line = texts.show(where).line;
    const auto ran = file.blocks.find(where.begin);
    if (ran == file.blocks.end()) {
      coverage.lines.try_emplace(line, 0);
      continue;
    }
    const CountedBlock& counted = *ran->second;
    const bool has_then =
        i + 1 < flow.blocks.size() && flow.blocks[i + 1].span.begin == block.span.begin;
    coverage.lines.try_emplace(line, runs_of(counted, has_then));
    if (counted.conditions[0] + counted.conditions[1] > 0) {
      coverage.conditions.try_emplace(line, counted.conditions);
    }
  }
}

}  // namespace

std::vector<FileCoverage> coverage_of(const BlockCounts& counts, const source::SourceMap& sources,
                                      analysis::ProgramSet& programs,
                                      const source::SourceMap& texts) {
  std::vector<CountedFile> files = files_of(counts, sources);
  std::erase_if(files, [&](const CountedFile& file) { return !programs.add_file(file.name); });
  std::vector<FileCoverage> all;
  for (const CountedFile& file : files) {
    all.push_back({file.name, {}, {}});
    for (const analysis::Flow& flow : programs.flows(file.name)) {
      add_lines(flow, file, texts, all.back());
    }
  }
  return all;
}

}  // namespace g31::coverage
