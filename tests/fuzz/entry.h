#pragma once

#include <cstdint>
#include <string_view>

namespace g31::fuzz {

/// Reads a text as a program file and as a later piece of one, compiles every program of it for
/// every Fanuc control and renders every message.  Whatever the bytes are, no more than that
/// happens.
void read_fanuc_text(std::string_view bytes);

/// The same of the SINUMERIK language: as a program, as definitions, as one expression; every step
/// stands in the text and goes where there are steps.
void read_sinumerik_text(std::string_view bytes);

/// Runs the main program of a text on a Fanuc control for at most kBlocks blocks, as the letters
/// behind its `%` say (TapeChoices).  Nothing is read or written outside the text.  Every number
/// that a result document would show must be one.
void run_fanuc_text(std::string_view bytes);

/// The same on the SINUMERIK control.
void run_sinumerik_text(std::string_view bytes);

/// Reads a text as a set-up sheet, renders what is wrong with it, and sets up a machine, the shapes
/// and a control of either dialect by it, which run a program of two blocks.
void read_sheet_text(std::string_view bytes);

/// Reads a text as a study file and renders what is wrong with it.
void read_study_text(std::string_view bytes);

/// Reads bytes behind a first line that is a file ending (stl, ply, off, obj, 3mf) as a mesh: what
/// comes is whole, and judged.
void read_mesh_bytes(std::string_view bytes);

/// Reads a first line as a serial line, and what follows as what goes to the printer there and
/// comes from it.
void read_printer_line(std::string_view bytes);

inline constexpr std::uint64_t kBlocks = 2000;

}  // namespace g31::fuzz
