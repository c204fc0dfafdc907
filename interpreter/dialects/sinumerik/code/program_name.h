#pragma once

#include <string>
#include <string_view>

namespace g31::sinumerik {

/// What a program name says: "_N_PART_SPF", "PART.SPF", "//NC/SPF.DIR/PART", "part" are all PART.
struct ProgramName {
  std::string stem;    ///< upper case
  std::string suffix;  ///< "MPF", "SPF", "DEF", "INI"; empty: not said
  std::string folder;  ///< the last one of its path, "SPF_DIR"; empty: not said
};
ProgramName program_name(std::string_view written);

/// The name of a text: that of its header or of its file.  Only texts have the suffix INI: a
/// program to call may well be named SETUP_INI.
/// @param before_suffix  "_" in headers, "." in names of files
ProgramName name_of_text(std::string_view written, std::string_view before_suffix);

/// What a control makes of the name of a file (NC programming 12/2019, 3.4.1.3): "_N_LOG_MPF",
/// "LOG.MPF", "LOG_MPF" and, as no type is said, "log" are all "LOG_MPF", "LOG.TXT" is "LOG_TXT".
std::string file_name_on_control(std::string_view written);

/// The last folder of a path: "/_N_WKS_DIR/_N_PART_WPD" and "//NC:/WKS.DIR/PART.WPD" are PART_WPD.
std::string folder_name(std::string_view path);

/// Data that loading runs: INI files.
bool is_data(const ProgramName& name);
/// Definition files.
bool is_definition(const ProgramName& name);
/// Of them those whose name a control keeps for definitions, MGUD or UMAC, or whose text has some:
/// other software has files .def, too.
bool holds_definitions(const ProgramName& name, std::string_view text);
/// What runs when it is called, not when its turn comes.
bool is_callable(const ProgramName& name);

}  // namespace g31::sinumerik
