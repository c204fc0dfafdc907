#include "tools/plan/plan_sheet.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "tools/session/control.h"
#include "tools/setup/document.h"
#include "tools/setup/keys.h"
#include "tools/setup/setup_error.h"

namespace g31::plan {
namespace {

namespace fs = std::filesystem;
using setup::Member;
using setup::Table;

constexpr double kUsualBallMm = 6.0;
constexpr double kUsualLengthMm = 120.0;

/// A text as a TOML string.
std::string as_toml(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_control = byte < 0x20 || byte == 0x7F;
    result += is_control              ? fmt::format("\\u{:04X}", byte)
              : c == '"' || c == '\\' ? std::string("\\") + c
                                      : std::string(1, c);
  }
  return result + "\"";
}

std::string part_text(const SheetContents& contents) {
  return fmt::format("[[part]]\nname = \"product\"\nfile = {}\non = \"{}\"\n",
                     as_toml(contents.product_file), kProductOffset);
}

/// As calibrating leaves it for a probe without errors.
std::string calibration_text(bool is_sinumerik) {
  if (is_sinumerik) {
    return fmt::format(
        "# What CYCLE977 knows of the probe: record 1, as CYCLE976 calibrates it.\n"
        "[machine_data]\n\"$SNS_MEA_WP_BALL_DIAM[0]\" = {0:.1f}\n"
        "\"$SNS_MEA_WP_TRIG_MINUS_DIR_AX1[0]\" = -{1:.1f}\n"
        "\"$SNS_MEA_WP_TRIG_PLUS_DIR_AX1[0]\" = {1:.1f}\n"
        "\"$SNS_MEA_WP_TRIG_MINUS_DIR_AX2[0]\" = -{1:.1f}\n"
        "\"$SNS_MEA_WP_TRIG_PLUS_DIR_AX2[0]\" = {1:.1f}\n\n",
        kUsualBallMm, kUsualBallMm / 2);
  }
  return fmt::format(
      "# What O9010, the macro of G100, knows of the probe.\n"
      "[variables]\n\"#515\" = {:.1f}      # diameter of the ball\n"
      "\"#516\" = {:.1f}    # length to the ball's centre\n"
      "\"#517\" = 0.0      # overtravel in X, Y and Z, as O6001 and O6002 calibrate it\n"
      "\"#518\" = 0.0\n\"#519\" = 0.0\n"
      "\"#530\" = 0.0      # eccentricity of the ball in X and Y, as O6003 does\n"
      "\"#531\" = 0.0\n\n",
      kUsualBallMm, kUsualLengthMm);
}

const Member* find(const Table& table, std::string_view key) {
  const auto found = std::ranges::find(table, key, &Member::key);
  return found == table.end() ? nullptr : &*found;
}

const Table* table_in(const Table& table, std::string_view key) {
  const Member* const member = find(table, key);
  return member == nullptr ? nullptr : std::get_if<Table>(&member->node.value);
}

/// New texts for values of a document, by line (from 1) and column (from 1, in characters).
using Replacements = std::map<std::pair<int, int>, std::string>;

/// Writes the paths of a user's sheet anew and puts the product into it.
class SheetEditor {
 public:
  SheetEditor(const setup::Document& document, const std::string& folder,
              const SheetContents& contents)
      : document_(document), folder_(folder), contents_(contents) {}

  /// @returns what is wrong
  std::optional<std::string> edit(std::string& result) {
    for (const auto check : {&SheetEditor::take_control, &SheetEditor::take_parts,
                             &SheetEditor::take_probe_and_offset}) {
      if (auto wrong = (this->*check)()) {
        return wrong;
      }
    }
    take_paths(document_.root, "");
    result = replaced() + "\n" + control_text_ + part_text(contents_);
    return std::nullopt;
  }

 private:
  using Wrong = std::optional<std::string>;

  [[nodiscard]] std::string at(const Member& member, std::string_view what) const {
    return fmt::format("{}:{}:{}: error: {}", document_.path, member.line, member.column, what);
  }

  /// Whether a sheet names the control of the program: by its name, or as one of its models.
  [[nodiscard]] bool is_planned_for(const std::string& name) const {
    const auto named = session::control_named(name);
    return named && session::name_of(named.value()) == contents_.control;
  }

  Wrong take_control() {
    const Table* const control = table_in(document_.root, "control");
    const Member* const profile = control != nullptr ? find(*control, "profile") : nullptr;
    if (profile != nullptr) {
      const auto* const name = std::get_if<std::string>(&profile->node.value);
      if (name != nullptr && !is_planned_for(*name)) {
        return at(*profile,
                  fmt::format("the sheet is for {}, the program for {}; give --control {} "
                              "or another sheet",
                              *name, contents_.control, *name));
      }
    } else if (control != nullptr) {
      return at(
          *find(document_.root, "control"),
          fmt::format("[control] has no profile; expected profile = \"{}\"", contents_.control));
    } else {
      control_text_ = fmt::format("[control]\nprofile = \"{}\"\n\n", contents_.control);
    }
    return std::nullopt;
  }

  Wrong take_parts() {
    const Member* const parts = find(document_.root, "part");
    const auto* const list =
        parts != nullptr ? std::get_if<setup::Array>(&parts->node.value) : nullptr;
    for (const setup::Node& node : list != nullptr ? *list : setup::Array()) {
      const auto* const part = std::get_if<Table>(&node.value);
      const Member* const fixture = part != nullptr ? find(*part, "fixture") : nullptr;
      const auto* const flag =
          fixture != nullptr ? std::get_if<bool>(&fixture->node.value) : nullptr;
      const bool is_fixture = flag != nullptr && *flag;
      if (!is_fixture) {
        return fmt::format(
            "{}:{}:{}: error: the sheet has a part of its own; the product is put "
            "there by g31 plan: expected fixture = true, or no [[part]]",
            document_.path, node.line, node.column);
      }
    }
    return std::nullopt;
  }

  Wrong take_probe_and_offset() {
    if (table_in(document_.root, "probe") == nullptr) {
      return document_.path + ": error: the sheet has no [probe], which is to measure the product";
    }
    const Table* const offsets = table_in(document_.root, "work_offsets");
    if (offsets == nullptr || table_in(*offsets, kProductOffset) == nullptr) {
      return fmt::format(
          "{}: error: the sheet has no [work_offsets.{}], in which the product's "
          "origin is to lie",
          document_.path, kProductOffset);
    }
    return std::nullopt;
  }

  /// Notes every relative path of a table and of those within it.
  void take_paths(const Table& table, const std::string& section) {
    const setup::SectionRow* const row = setup::find_section(section);
    for (const Member& member : table) {
      if (const auto* const inner = std::get_if<Table>(&member.node.value)) {
        take_paths(*inner, section.empty() ? member.key : section + "." + member.key);
      } else if (const auto* const list = std::get_if<setup::Array>(&member.node.value)) {
        for (const setup::Node& node : *list) {
          if (const auto* const element = std::get_if<Table>(&node.value)) {
            take_paths(*element, section.empty() ? member.key : section + "." + member.key);
          }
        }
      } else if (row != nullptr) {
        take_path(member, row->id);
      }
    }
  }

  void take_path(const Member& member, setup::SectionId section) {
    const auto* const text = std::get_if<std::string>(&member.node.value);
    const auto key = setup::find_key(section, member.key);
    if (text == nullptr || !key || key->row->type != setup::ValueType::Path ||
        fs::path(*text).is_absolute()) {
      return;
    }
    const fs::path from = fs::absolute(fs::path(document_.path)).parent_path() / *text;
    std::error_code unknown;
    if (member.key == "file" && !fs::exists(from, unknown)) {
      return;  // a machine that comes with g31
    }
    const fs::path to =
        from.lexically_normal().lexically_relative(fs::absolute(folder_).lexically_normal());
    replacements_[{member.node.line, member.node.column}] = as_toml(to.string());
  }

  /// The text with the noted values; a value is a string of one line, in quotes of one kind.
  [[nodiscard]] std::string replaced() const {
    std::string text;
    int number = 0;
    for (std::size_t begin = 0; begin < document_.text.size();) {
      const std::size_t end = std::min(document_.text.find('\n', begin), document_.text.size());
      text += line_with_new_values(++number, document_.text.substr(begin, end - begin)) + "\n";
      begin = end + 1;
    }
    return text;
  }

  [[nodiscard]] std::string line_with_new_values(int number, std::string line) const {
    for (auto it = replacements_.rbegin(); it != replacements_.rend(); ++it) {
      if (it->first.first != number) {
        continue;
      }
      const std::size_t begin = byte_of_character(line, it->first.second);
      const char quote = begin < line.size() ? line[begin] : '"';
      std::size_t end = begin + 1;
      while (end < line.size() && line[end] != quote) {
        end += quote == '"' && line[end] == '\\' ? 2U : 1U;
      }
      line.replace(begin, std::min(end + 1, line.size()) - begin, it->second);
    }
    return line;
  }

  static std::size_t byte_of_character(std::string_view line, int column) {
    std::size_t byte = 0;
    const auto is_inside = [&](std::size_t i) {
      return i < line.size() && (static_cast<unsigned char>(line[i]) & 0xC0U) == 0x80U;
    };
    for (int character = 1; character < column && byte < line.size(); ++character) {
      do {
        ++byte;
      } while (is_inside(byte));
    }
    return byte;
  }

  const setup::Document& document_;
  std::string folder_;
  const SheetContents& contents_;
  std::string control_text_;
  Replacements replacements_;
};

}  // namespace

std::string usual_sheet(const SheetContents& contents) {
  // The ball begins well above the part, with the spindle's gauge line at machine Z 0.
  constexpr double kAboveMm = 150.0;
  constexpr double kStepMm = 10.0;
  const double origin_z =
      -kStepMm * std::ceil((kUsualLengthMm + kAboveMm + contents.top_z_P) / kStepMm);
  return fmt::format(
             "# The product as g31 plan measures it: {0} is its own frame.\n"
             "# g31 run {1} -s setup.toml\n\n"
             "[control]\nprofile = \"{2}\"\n\n"
             "[work_offsets.{0}]\nX = 0.0\nY = 0.0\nZ = {3:.1f}\n\n"
             "[tools.1]\nname = \"3D_PROBE\"\ntype = 710.0\nlength = {4:.1f}    # to the ball's "
             "centre\n"
             "radius = {5:.1f}\n\n"
             "[probe]\nball_diameter = {6:.1f}\nlength = {4:.1f}    # to the ball's centre\n\n",
             kProductOffset, contents.program, contents.control, origin_z, kUsualLengthMm,
             kUsualBallMm / 2, kUsualBallMm) +
         calibration_text(contents.is_sinumerik) + part_text(contents);
}

Result<std::string, session::Refusal> sheet_with_product(const std::string& path,
                                                         const std::string& folder,
                                                         const SheetContents& contents) {
  const auto document = setup::read_document(path, 0);
  if (!document) {
    return session::refusal_of({document.error()});
  }
  SheetEditor editor(*document.value(), folder, contents);
  std::string text;
  const auto wrong = editor.edit(text);
  return wrong ? Result<std::string, session::Refusal>(session::bad_input(*wrong)) : text;
}

}  // namespace g31::plan
