#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "parts/artefacts/part_setup.h"
#include "tools/expect/characteristic.h"
#include "tools/setup/setup_error.h"
#include "tools/setup/sheet.h"

namespace g31::setup {

/// A row of true_places.def.
struct TruePlace {
  std::string_view key;
  int axis;  ///< of PartSetup::p_M_at, of an angle of rotate_deg
  expect::Quantity quantity;
  std::string_view text;
};

/// What `true` may name of any part.
std::span<const TruePlace> true_places();

/// Finds what PART.KEY names: a size of the part's shape, what the shape works out from its sizes,
/// or where the part is and how it is turned.
class TrueSizes {
 public:
  /// Both must outlive this object.
  TrueSizes(std::span<const parts::PartSetup> parts, ErrorList& errors)
      : parts_(parts), errors_(errors) {}

  /// @param entry  holds a text.  nullopt: what is wrong with it is told
  [[nodiscard]] std::optional<expect::TrueSize> find(const Entry& entry) const;

 private:
  std::optional<expect::TrueSize> refuse(const Entry& entry, const std::string& should_be) const;

  std::span<const parts::PartSetup> parts_;
  ErrorList& errors_;
};

}  // namespace g31::setup
