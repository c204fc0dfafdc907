#include <fmt/format.h>

#include "parts/artefacts/artefact.h"
#include "tools/manual/entries.h"

namespace g31::manual {
namespace {

using runtime::Entries;
using runtime::Entry;

std::string size_text(const parts::ShapeSize& size) {
  return size.default_mm ? fmt::format("{}; {} if not given", size.text, *size.default_mm)
                         : std::string(size.text);
}

Entry entry_of_shape(const parts::Shape& shape) {
  Entry entry{"shape of a part", std::string(shape.name), std::string(shape.text), {}};
  for (const parts::ShapeSize& size : parts::shape_sizes()) {
    if (size.shape == shape.name) {
      entry.facts.push_back({std::string(size.name), size_text(size)});
    }
  }
  entry.facts.push_back({"for example", fmt::format("[[part]] shape = \"{}\"", shape.name)});
  return entry;
}

Entry entry_of_size(const parts::ShapeSize& size) {
  return {"size of a shape",
          fmt::format("{} of shape {}", size.name, size.shape),
          size_text(size),
          {{"unit", "mm, where the text says nothing else"}}};
}

}  // namespace

Entries shape_entries(std::string_view topic) {
  Entries found;
  for (const parts::Shape& shape : parts::shapes()) {
    if (shape.name == topic) {
      found.push_back(entry_of_shape(shape));
    }
  }
  for (const parts::ShapeSize& size : parts::shape_sizes()) {
    if (size.name == topic || topic == fmt::format("{}.{}", size.shape, size.name)) {
      found.push_back(entry_of_size(size));
    }
  }
  return found;
}

Entries all_shape_entries() {
  Entries all;
  for (const parts::Shape& shape : parts::shapes()) {
    all.push_back(entry_of_shape(shape));
  }
  for (const parts::ShapeSize& size : parts::shape_sizes()) {
    all.push_back(entry_of_size(size));
  }
  return all;
}

}  // namespace g31::manual
