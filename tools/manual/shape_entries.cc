#include <fmt/format.h>

#include "parts/artefacts/artefact.h"
#include "parts/artefacts/worked_out.h"
#include "tools/manual/entries.h"
#include "tools/setup/true_sizes.h"

namespace g31::manual {
namespace {

using runtime::Entries;
using runtime::Entry;

std::string size_text(const parts::ShapeSize& size) {
  return size.default_value ? fmt::format("{}; {} if not given", size.text, *size.default_value)
                            : std::string(size.text);
}

Entry entry_of_shape(const parts::Shape& shape) {
  Entry entry{"shape of a part", std::string(shape.name), std::string(shape.text), {}};
  for (const parts::ShapeSize& size : parts::shape_sizes()) {
    if (size.shape == shape.name) {
      entry.facts.push_back({std::string(size.name), size_text(size)});
    }
  }
  for (const parts::WorkedOut& result : parts::worked_out()) {
    if (result.shape == shape.name) {
      entry.facts.push_back({fmt::format("true = \"{}.{}\"", shape.name, result.name),
                             fmt::format("{}; worked out, for [[characteristic]]", result.text)});
    }
  }
  entry.facts.push_back({"for example", fmt::format("[[part]] shape = \"{}\"", shape.name)});
  return entry;
}

Entry entry_of_size(const parts::ShapeSize& size) {
  return {"size of a shape",
          fmt::format("{} of shape {}", size.name, size.shape),
          size_text(size),
          {{"unit", std::string(parts::unit_of(size.quantity))}}};
}

Entry entry_of_result(const parts::WorkedOut& result) {
  return {
      "what a shape works out",
      fmt::format("{} of shape {}", result.name, result.shape),
      std::string(result.text),
      {{"unit", std::string(parts::unit_of(result.quantity))},
       {"for example", fmt::format("[[characteristic]] true = \"{}.{}\", of a part of that name",
                                   result.shape, result.name)}}};
}

Entry entry_of_place(const setup::TruePlace& place) {
  return {
      "place of a part",
      fmt::format("{} of a part", place.key),
      std::string(place.text),
      {{"for example",
        fmt::format("[[characteristic]] true = \"ring.{}\", of a part of that name", place.key)}}};
}

/// What the rows are that a topic names.
template <typename Row>
bool is_named(const Row& row, std::string_view topic) {
  return row.name == topic || topic == fmt::format("{}.{}", row.shape, row.name);
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
    const bool is_key = topic == fmt::format("part.{}", size.name);  // as messages name it
    if (is_key || is_named(size, topic)) {
      found.push_back(entry_of_size(size));
    }
  }
  for (const parts::WorkedOut& result : parts::worked_out()) {
    if (is_named(result, topic)) {
      found.push_back(entry_of_result(result));
    }
  }
  for (const setup::TruePlace& place : setup::true_places()) {
    if (place.key == topic) {
      found.push_back(entry_of_place(place));
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
  for (const parts::WorkedOut& result : parts::worked_out()) {
    all.push_back(entry_of_result(result));
  }
  for (const setup::TruePlace& place : setup::true_places()) {
    all.push_back(entry_of_place(place));
  }
  return all;
}

}  // namespace g31::manual
