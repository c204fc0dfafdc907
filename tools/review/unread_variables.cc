#include "tools/review/unread_variables.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>
#include <set>
#include <string>

#include <fmt/format.h>

#include "interpreter/analysis/program_set.h"
#include "machine/base/letters.h"
#include "tools/disk/disk.h"
#include "tools/disk/shipped.h"
#include "tools/review/setup_rules.h"
#include "tools/session/analysed_programs.h"
#include "tools/session/library_folders.h"

namespace g31::review {
namespace {

namespace fs = std::filesystem;

/// The files of a user's programs: those of the request, those beside them, those of the libraries.
std::set<std::string> own_files(const session::Request& request) {
  std::set<std::string> files(request.programs.begin(), request.programs.end());
  std::set<std::string> endings = {".nc", ".NC", ".spf", ".SPF", ".mpf", ".MPF"};
  disk::Disk disk;
  const auto libraries = session::library_folders(request.libraries, disk);
  std::vector<std::string> folders = libraries ? libraries.value() : std::vector<std::string>();
  for (const std::string& program : request.programs) {
    endings.insert(fs::path(program).extension().string());
    folders.push_back(fs::path(program).parent_path().string());
  }
  for (const std::string& folder : folders) {
    for (const std::string& name : disk.list(folder)) {
      if (endings.contains(fs::path(name).extension().string())) {
        files.insert((fs::path(folder) / name).string());
      }
    }
  }
  return files;
}

std::set<std::string> shipped_files(const session::Control& control) {
  const bool is_fanuc = std::holds_alternative<session::FanucControl>(control);
  const auto folder = disk::shipped_folder(is_fanuc ? "macros/fanuc" : "macros/sinumerik");
  std::set<std::string> files;
  disk::Disk disk;
  for (const std::string& name : folder ? disk.list(*folder) : std::vector<std::string>()) {
    const std::string ending = fs::path(name).extension().string();
    if (ending == ".nc" || ending == ".SPF") {
      files.insert((fs::path(*folder) / name).string());
    }
  }
  return files;
}

/// What programs read.
class ReadVariables {
 public:
  void add(const analysis::Flow& flow) {
    for (const analysis::Access& access : flow.accesses) {
      if (access.kind == analysis::Access::Kind::Write) {
        continue;
      }
      const analysis::Variable& variable = flow.variables.at(access.variable);
      is_computed_ = is_computed_ || variable.scope == analysis::Variable::Scope::Computed;
      names_.insert(variable.name);
      elements_.insert({variable.name, access.element});
    }
  }

  /// @param written  as sheets have it: "#500", "R5", "_OVR[4]"
  [[nodiscard]] bool has(const std::string& written) const {
    if (is_computed_) {
      return true;
    }
    const std::string name = in_capitals(written);
    int number = 0;
    const auto end = std::from_chars(name.data() + 1, name.data() + name.size(), number);
    if (name.starts_with('R') && end.ec == std::errc() && end.ptr == name.data() + name.size()) {
      return elements_.contains({"R", number}) ||
             elements_.contains({"R", analysis::kWholeVariable});
    }
    return names_.contains(name.substr(0, name.find('[')));
  }

 private:
  bool is_computed_ = false;
  std::set<std::string> names_;
  std::set<std::pair<std::string, std::int32_t>> elements_;
};

using Flows = std::vector<analysis::Flow>;

Flows flows_of(analysis::ProgramSet& programs, const std::set<std::string>& files) {
  std::vector<std::string> readable;
  std::ranges::copy_if(files, std::back_inserter(readable),
                       [&](const std::string& file) { return programs.add_file(file); });
  Flows flows;
  for (const std::string& file : readable) {
    std::ranges::move(programs.flows(file), std::back_inserter(flows));
  }
  return flows;
}

/// Programs that may be called, by their names.
class Called {
 public:
  /// Codes of the sheets call programs, too; which one a parameter makes call what is not followed.
  explicit Called(const runtime::ControlSetup& control) {
    for (const auto& [code, number] : control.macro_calls) {
      names_.insert(fmt::format("O{:04}", number));
    }
    is_any_ = std::ranges::any_of(control.parameters,
                                  [](const auto& row) { return row.first.starts_with("60"); });
  }
  void add(const analysis::Flow& flow) {
    for (const analysis::Call& call : flow.calls) {
      is_any_ = is_any_ || call.target.empty();
      names_.insert(call.target);
    }
  }
  [[nodiscard]] bool has(const analysis::Flow& flow) const {
    return is_any_ || names_.contains(flow.program);
  }

 private:
  std::set<std::string> names_;
  bool is_any_ = false;
};

/// What a user's programs read, and those of g31 that they call.
ReadVariables read_by(const session::Request& request, const session::Prepared& prepared) {
  disk::Disk disk;
  source::SourceMap sources(disk);
  const auto programs = session::analysed_programs(prepared.control, sources, prepared.job.control);
  ReadVariables read;
  Called called(prepared.job.control);
  for (const analysis::Flow& flow : flows_of(*programs, own_files(request))) {
    read.add(flow);
    called.add(flow);
  }
  Flows waiting = flows_of(*programs, shipped_files(prepared.control));
  while (true) {
    const auto found =
        std::ranges::find_if(waiting, [&](const analysis::Flow& flow) { return called.has(flow); });
    if (found == waiting.end()) {
      return read;
    }
    read.add(*found);
    called.add(*found);
    waiting.erase(found);
  }
}

}  // namespace

void judge_variables(const session::Request& request, const session::Prepared& prepared,
                     std::vector<source::Diagnostic>& findings) {
  const setup::Job& job = prepared.job;
  if (job.control.variables.empty()) {
    return;
  }
  const ReadVariables read = read_by(request, prepared);
  std::set<std::string> wanted;
  for (const expect::Expectation& row : job.expectations.rows) {
    if (const auto* const variable = std::get_if<expect::Variable>(&row.what)) {
      wanted.insert(variable->name);
    }
  }
  for (const expect::Characteristic& row : job.expectations.characteristics) {
    wanted.insert(row.variable);
  }
  for (const auto& [name, value] : job.control.variables) {
    const auto place = job.places.find("variables." + name);
    // What a variables file kept, and data of the machine, are there whoever reads them.
    const bool is_of_sheet = place != job.places.end() && !name.starts_with('$') &&
                             std::ranges::find(job.sheets, place->second.file) != job.sheets.end();
    if (is_of_sheet && !read.has(name) && !wanted.contains(name)) {
      findings.push_back(finding_of(SetupRuleId::Unread, name));
      findings.back().in_sheet = place->second;
    }
  }
}

}  // namespace g31::review
