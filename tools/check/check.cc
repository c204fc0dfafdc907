#include "tools/check/check.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <string_view>
#include <utility>

#include "interpreter/analysis/program_set.h"
#include "interpreter/analysis/static_findings.h"
#include "machine/base/letters.h"
#include "tools/check/disabled_findings.h"
#include "tools/disk/shipped.h"
#include "tools/session/analysed_programs.h"
#include "tools/session/message_comments.h"

namespace g31::check {
namespace {

using session::Control;

/// The control that a file speaks for; definition files are none but SINUMERIK's.
Control control_of(const std::string& path, source::FileSystem& files) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".DEF" || ending == ".def" || ending == ".INI" || ending == ".ini") {
    return session::SinumerikControl{};
  }
  return session::control_of_program(
      path, files.read_part(path, 0, session::kProgramBeginning).value_or(""));
}

std::string shipped_for(const Control& control) {
  const bool is_fanuc = std::holds_alternative<session::FanucControl>(control);
  const std::string folder = is_fanuc ? "macros/fanuc" : "macros/sinumerik";
  return disk::shipped_folder(folder) ? disk::shipped_name(folder) : "";
}

/// Files of one folder for one control: they share what they can call.
struct Group {
  Control control;
  std::string folder;
  std::vector<std::string> files;
  std::vector<std::string> named;  ///< of them those that are named themselves
};

std::vector<Group> groups_of(const Request& request, source::FileSystem& files) {
  std::vector<Group> groups;
  const std::set<std::string_view> named(request.paths.named.begin(), request.paths.named.end());
  std::map<std::pair<std::string, std::string>, std::size_t> known;
  for (const std::string& path : request.paths.files) {
    const Control control = request.control ? *request.control : control_of(path, files);
    const std::string folder = std::filesystem::path(path).parent_path().string();
    const auto [place, is_new] =
        known.try_emplace({std::string(session::name_of(control)), folder}, groups.size());
    if (is_new) {
      groups.push_back({control, folder, {}, {}});
    }
    groups[place->second].files.push_back(path);
    if (named.contains(path)) {
      groups[place->second].named.push_back(path);
    }
  }
  return groups;
}

/// Whether a group may call what another one holds, as far as the control goes.
bool is_beside(const Group& group, const Group& other) {
  return other.folder != group.folder &&
         session::name_of(other.control) == session::name_of(group.control);
}

/// Files or folders by how many folders they have in common with a group, the nearest first.
using ByNearness = std::map<std::ptrdiff_t, std::vector<std::string>, std::greater<>>;

/// How many folders two paths have in common from the start.
std::ptrdiff_t common_folders(const std::string& a, const std::string& b) {
  const std::filesystem::path first = std::filesystem::path(a).lexically_normal();
  const std::filesystem::path second = std::filesystem::path(b).lexically_normal();
  return std::distance(first.begin(), std::ranges::mismatch(first, second).in1);
}

bool is_definition_file(const std::string& path) {
  return in_small_letters(std::filesystem::path(path).extension().string()) == ".def";
}

bool lies_in(const std::string& folder, const std::string& tree) {
  const std::filesystem::path way = std::filesystem::path(folder).lexically_relative(tree);
  return !way.empty() && *way.begin() != "..";
}

/// Whether somebody who names a folder that holds both means that programs of one may call those of
/// the other.  Other workpieces of a SINUMERIK are not looked into by the control either.
bool are_of_one_tree(const std::string& a, const std::string& b, const ProgramPaths& paths) {
  const std::string ending = in_small_letters(std::filesystem::path(b).extension().string());
  return ending != ".wpd" && std::ranges::any_of(paths.trees, [&](const std::string& tree) {
           return lies_in(a, tree) && lies_in(b, tree);
         });
}

/// The other folders of the control in which a group may look for what it calls, the nearest first.
ByNearness folders_around(const Group& group, const std::vector<Group>& groups,
                          const ProgramPaths& paths) {
  ByNearness around;
  for (const Group& other : groups) {
    if (is_beside(group, other) && are_of_one_tree(group.folder, other.folder, paths)) {
      around[common_folders(group.folder, other.folder)].push_back(other.folder);
    }
  }
  return around;
}

/// All definition files that are checked hold for all programs, as in the memory of a control;
/// those that lie nearest come first.
void add_definitions(analysis::ProgramSet& programs, const Group& group,
                     const std::vector<Group>& groups) {
  ByNearness by_nearness;
  for (const Group& other : groups) {
    if (is_beside(group, other)) {
      std::ranges::copy_if(
          other.files, std::back_inserter(by_nearness[common_folders(group.folder, other.folder)]),
          is_definition_file);
    }
  }
  for (const auto& [common, files] : by_nearness) {
    programs.add_definitions(files);
  }
}

/// What programs of the group can call beside their own files.
void add_callable(analysis::ProgramSet& programs, const Group& group,
                  const std::vector<Group>& groups, const Request& request) {
  for (const Group& other : groups) {
    if (is_beside(group, other)) {
      for (const std::string& path : other.named) {
        (void)programs.add_file(path);  // unreadable ones are told with their own group
      }
    }
  }
  programs.add_folder(group.folder);
  for (const std::string& folder : request.libraries) {
    programs.add_folder(folder);
  }
  add_definitions(programs, group, groups);
  for (const auto& [common, folders] : folders_around(group, groups, request.paths)) {
    std::ranges::for_each(folders, [&](const std::string& folder) { programs.add_folder(folder); });
  }
  if (const std::string shipped = shipped_for(group.control); !shipped.empty()) {
    programs.add_shipped_folder(shipped);
  }
}

std::vector<analysis::Finding> without_disabled_ones(std::vector<analysis::Finding> found,
                                                     const Group& group,
                                                     const source::SourceFile& file,
                                                     const source::SourceMap& sources) {
  return without_disabled(
      std::move(found), file,
      session::message_comments(file.text(), session::comment_form(group.control)), sources);
}

}  // namespace

Findings check(const Request& request, source::SourceMap& sources) {
  Findings all;
  std::map<std::string, std::vector<analysis::Finding>> by_file;
  std::map<std::string, std::vector<analysis::Finding>> definitions;  ///< of files beside those
  const std::vector<Group> groups = groups_of(request, sources.files());
  std::map<std::string, std::unique_ptr<analysis::ProgramSet>> by_control;
  for (const Group& group : groups) {
    auto& programs = by_control[std::string(session::name_of(group.control))];
    if (programs == nullptr) {
      programs = session::analysed_programs(group.control, sources, request.setup);
    } else {
      programs->start_over();
    }
    std::vector<std::string> readable;
    for (const std::string& path : group.files) {
      const bool is_readable = programs->add_file(path);
      (is_readable ? readable : all.unreadable).push_back(path);
      if (!is_readable) {
        request.file_done();
      }
    }
    add_callable(*programs, group, groups, request);
    for (const std::string& path : readable) {
      if (runtime::is_interrupted(request.interruption)) {
        return all;
      }
      const source::SourceFile& file = programs->text(path);
      by_file[path] =
          without_disabled_ones(analysis::static_findings(*programs, path), group, file, sources);
      request.file_done();
    }
    for (auto& [path, found] : analysis::definition_findings(*programs)) {
      definitions.try_emplace(
          path, without_disabled_ones(std::move(found), group, programs->text(path), sources));
    }
  }
  for (const std::string& path : request.paths.files) {
    std::ranges::move(by_file[path], std::back_inserter(all.found));
    definitions.erase(path);
  }
  for (auto& [path, found] : definitions) {
    std::ranges::move(found, std::back_inserter(all.found));
  }
  return all;
}

}  // namespace g31::check
