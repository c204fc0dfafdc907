#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "interpreter/dialects/fanuc/vocabulary/profile.h"
#include "machine/base/result.h"

namespace g31::session {

/// A control of the Fanuc dialect.
struct FanucControl {
  std::reference_wrapper<const fanuc::Profile> profile;
};

/// The SINUMERIK 828D.
struct SinumerikControl {};

/// A control that programs are written for.  What differs between dialects is a visitor, so that a
/// further dialect does not compile until each of them knows it.
using Control = std::variant<FanucControl, SinumerikControl>;

/// What --control calls it.
std::string_view name_of(const Control& control);

/// The control of this name, in letters of any case, or of a model that runs as one does: "0i-MF"
/// is fanuc-30i (control_models.def); else one line that names the nearest and all known ones.
Result<Control, std::string> control_named(std::string_view name);

/// All controls, those of the Fanuc dialect first.
std::vector<Control> all_controls();

/// What --control calls each of them.
std::vector<std::string> control_names();

/// The models that run as this control does, as control_models.def has them.
std::vector<std::string_view> models_of(const Control& control);

/// The control where nothing names one.
Control default_control();

/// The control that a program's file ending speaks for (.MPF, .SPF and .ARC are SINUMERIK), else
/// the first line of its text (%_N_NAME_MPF), else words in it that no Fanuc program has.
/// @param text  the first kProgramBeginning bytes are enough
Control control_of_program(const std::string& path, std::string_view text);
inline constexpr std::size_t kProgramBeginning = 4096;

/// Whether a file .DEF defines data of a SINUMERIK: other software has such files, too.
/// @param text  all of it
bool defines_data(const std::string& path, std::string_view text);

}  // namespace g31::session
