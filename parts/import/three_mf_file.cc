#include "parts/import/three_mf_file.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "parts/import/mesh_limits.h"
#include "parts/import/mesh_unit.h"
#include "parts/import/text_lines.h"
#include "parts/import/zip_archive.h"

namespace g31::parts {
namespace {

/// The start tag of the model, without its brackets; "" where there is none.
std::string_view model_tag(std::string_view xml) {
  for (std::size_t at = xml.find('<'); at != std::string_view::npos; at = xml.find('<', at + 1)) {
    const std::string_view tag = xml.substr(at + 1, xml.find('>', at) - at - 1);
    std::string_view words = tag;
    const std::string_view name = take_word(words);
    if (name == "model" || name.ends_with(":model")) {
      return tag;
    }
  }
  return {};
}

/// The value of ` unit="..."`; mm where it is not given, as the format says.
std::string_view unit_in(std::string_view tag) {
  for (std::size_t at = tag.find("unit"); at != std::string_view::npos;
       at = tag.find("unit", at + 1)) {
    std::string_view rest = tag.substr(at + 4);
    rest.remove_prefix(std::min(rest.size(), rest.find_first_not_of(" \t\r\n")));
    if (at == 0 || !is_blank(tag[at - 1]) || !rest.starts_with('=')) {
      continue;
    }
    rest.remove_prefix(std::min(rest.size(), rest.find_first_of("\"'")));
    return rest.empty() ? rest : rest.substr(1, rest.find(rest.front(), 1) - 1);
  }
  return "millimeter";
}

Result<double, std::string> unit_of_model(const ZipEntry& entry) {
  const auto model = unpacked(entry);
  if (!model) {
    return model.error();
  }
  const std::string_view xml = model.value().bytes;
  const std::string_view tag = model_tag(xml);
  const std::size_t last = xml.rfind("</");
  const std::string_view end = last == std::string_view::npos ? "" : xml.substr(last);
  if (tag.empty() || end.find("model") == std::string_view::npos ||
      end.find('>') == std::string_view::npos) {
    return fmt::format("'{}' in it is no whole model: it was cut off", entry.name);
  }
  const std::string_view name = unit_in(tag);
  const auto* const unit = std::ranges::find(kMeshUnits, name, &MeshUnit::name_in_3mf);
  if (unit == std::end(kMeshUnits)) {
    return fmt::format("its unit is '{}', which is none of 3MF", name.substr(0, 40));
  }
  return unit->mm;
}

/// The model that the relationships of the package lead to and that is not in it; "": none.  assimp
/// stops the process where it looks for one.
std::string missing_model(std::string_view relationships, const std::vector<ZipEntry>& entries) {
  constexpr std::string_view kTarget = "Target=\"";
  for (std::size_t at = relationships.find(kTarget); at != std::string_view::npos;
       at = relationships.find(kTarget, at + 1)) {
    std::string_view name = relationships.substr(at + kTarget.size());
    name = name.substr(0, name.find('"'));
    name.remove_prefix(name.starts_with('/') ? 1 : 0);
    const bool is_there =
        std::ranges::any_of(entries, [&](const ZipEntry& entry) { return entry.name == name; });
    if (name.ends_with(".model") && !is_there) {
      return std::string(name);
    }
  }
  return {};
}

}  // namespace

Result<double, std::string> unit_of_3mf(std::string_view bytes) {
  const auto entries = zip_directory(bytes);
  if (!entries) {
    return entries.error();
  }
  std::uint64_t size = 0;
  for (const ZipEntry& entry : entries.value()) {
    size += entry.unpacked_size;
  }
  if (size > kMostBytesReadWhole) {
    return fmt::format("unpacked it has {} bytes; {} are the most", size, kMostBytesReadWhole);
  }
  std::optional<double> unit;
  for (const ZipEntry& entry : entries.value()) {
    if (!entry.name.ends_with(".model")) {
      // assimp stops the process where it meets a file whose checksum is wrong.
      if (const auto whole = unpacked(entry); !whole) {
        return whole.error();
      } else if (entry.name == "_rels/.rels") {
        if (const auto name = missing_model(whole.value().bytes, entries.value()); !name.empty()) {
          return fmt::format("'{}', its model, is not in it", name);
        }
      }
      continue;
    }
    const auto one = unit_of_model(entry);
    if (!one) {
      return one.error();
    }
    if (unit && *unit != one.value()) {
      return std::string("its models have different units; write them in one");
    }
    unit = one.value();
  }
  return unit ? Result<double, std::string>(*unit)
              : std::string("it holds no model, as a 3MF file does");
}

}  // namespace g31::parts
