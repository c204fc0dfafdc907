#pragma once

#include <string>
#include <string_view>

#include "machine/base/result.h"
#include "tools/session/refusal.h"

namespace g31::plan {

/// The work offset whose frame is that of the product.
inline constexpr std::string_view kProductOffset = "G54";

/// The file of a plan that the sheet is.
inline constexpr std::string_view kSheetFile = "setup.toml";
/// Of the program, by its language.
inline constexpr std::string_view kFanucProgram = "inspect.nc";
inline constexpr std::string_view kSinumerikProgram = "INSPECT.MPF";

/// What a set-up sheet of a plan is made from.
struct SheetContents {
  std::string control;  ///< the profile's name
  std::string program;  ///< the file that runs under it, for the comment
  bool is_sinumerik = false;
  std::string product_file;  ///< as the sheet is to name it
  double top_z_P = 0.0;      ///< the highest point of product and stock, product frame
};

/// A sheet with a usual probe, a machine without limits and the product on kProductOffset.
std::string usual_sheet(const SheetContents& contents);

/// A sheet of the user's with the product on kProductOffset as its last part.  Relative paths in it
/// are written anew for a sheet in another folder.
/// @param path    of the sheet
/// @param folder  in which the new sheet is to lie
///
/// Error: one line, with the place in the sheet: no TOML, no probe, no such offset, a part of its
/// own that is no fixture, another control.
Result<std::string, session::Refusal> sheet_with_product(const std::string& path,
                                                         const std::string& folder,
                                                         const SheetContents& contents);

}  // namespace g31::plan
