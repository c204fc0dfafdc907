#include <algorithm>

#include "tools/manual/markdown.h"
#include "tools/manual/pages.h"
#include "tools/session/manual.h"

namespace g31::manual {
namespace {

constexpr std::string_view kAboutTheWorld =
    R"(g31 runs measuring programs.  What it does not run or model is told here, and by the run itself: a block that
cannot be run ends it with an alarm at its place, one that is passed over is a warning (PRB304), and `g31 check`
finds codes, functions and cycles of both kinds before (NC007).  A SINUMERIK's addresses and SETPIECE, below, are taken
without a word: what they say has nothing to act on here.

## The world

* Nothing is cut: parts keep their shape whatever tool goes through them.
* Parts, clamps, machine and tools are rigid; of bending there is the stem's (`probe.stem_stiffness`) and the
  deflection of the probe until its signal.
* A part has one temperature (`temperature`, `expansion`), the scale of each axis one of its own; heat does not flow.
* Surfaces are the mesh, but for a sphere by its shape: no roughness, no dirt and no oil; `sagitta` and `step_sagitta`
  say how fine.
* Positioning errors, squareness, backlash, friction and lag are those of the sheet; nothing vibrates, nothing wears.
* Compensation tables move the axes as their values say, without a limit of their sum: $AA_ENC_COMP, $AN_CEC, a
  Fanuc's pitch errors and straightness of linear axes.
* Axes stand where they are told to, to the last digit: SINUMERIK's MD10200 and MD10210 (increments a millimetre, a
  degree) and the detection unit of a Fanuc round nothing.
* A probe fails as `probe.state` says; radio or optical transmission and its range are not there.
* Doors, pallets, tool changers, coolant, chips and bar feeders are not there: M codes that g31 does not know do nothing.
* Nobody is there: what waits for an operator goes on (stops are listed), or ends the run: on a SINUMERIK where it waits
  again and again (PRB604), else by the limit of blocks (PRB601).  Inputs come from `[[input]]`, keys that M109 of a Haas
  asks for from `control.keys` (PRB607).
* Under G96 the feed of a block is the mean over its way: its time is right, its speed in between is not.  Where a
  chamfer or a rounding cuts the way, that is the mean of the whole.  Rapids change the speed as feeds do.  A thread (G33) begins at once, wherever the spindle
  stands.
* A skip move of a machine whose axes lag ends at once where they come to rest: a trace steps there by what is left of
  the lag, the in-position window at most.
* A Fanuc tapping cycle (G74, G84) goes in and out once, whatever its Q: pecks of rigid tapping are passed over (PRB304).
* Where axes lag, or moves pass on into each other, a collision is found when the axes come to it, behind blocks that
  have been read ahead: what these have set, printed and counted stays, with the times at which it would have been.
* There is one channel: programs of several channels wait for nobody.
* A Fanuc main program of more than 1 MiB is read while it runs: a block that cannot be understood ends the run where it
  comes there (exit code 2); with a shorter one nothing moves then.  `g31 check` reads the whole of both.
* SINUMERIK, five axes: TRAORI, tool carriers and CYCLE800 run by the data `$TC_CARR`, TRAORI also by machine data 24100
  to 24682 (types 24, 40, 56, 72 of two transformations); the radius is compensated in the plane (CUT2D), CUTMOD is not
  there: an aligned turning tool keeps its edge position.  MEAW along a great circle (A3 with ORIVECT) is refused.  Kinematic chains
  (`$NK_`, `$NT_`) have offsets, rotary, linear and fixed turned elements: a slide on a rotary axis and SWITCH are refused.  What
  compile cycles do with files of interpolation points and of directions is not there.  The shaft of a probe senses nothing:
  CYCLE995 needs a further ball in its place.
* SINUMERIK: G641 to G645 round corners between lines in the plane of G17 to G19.  Corners that leave it stay sharp, and
  so do all of a plane that is tilted or scaled unequally and those beside radius compensation: such a path takes longer
  than on the control.
* Fanuc: the machine has axes X, Y, Z, A, B and C.  U, V and W of a mill (a quill, a boring head, a pallet) are not
  there: the sheet's [machine.axes.W] is a warning (PRB506), a block that moves W is alarm 9.  Programs of the T series,
  for lathes, are refused where they show what they are (PRB003).
* Fanuc, five axes: tilted planes and tool centre point control run; the radius is not compensated in space, and without
  parameter 1422 an axis that would be too fast slows the move instead of alarm 5422.
* Mazak EIA: data of MAZATROL and the variables that show them or the tool data (#3020 and on, #5501 and on, #40000 to
  #69999), IF .. THEN over several blocks with ELSE and ENDIF, and the M codes of its measuring are not there.
)";

/// Controls that have a part of the page, and what it is called.
struct TitledControl {
  std::string_view control;
  std::string_view title;
};
constexpr TitledControl kTitles[] = {
    {"fanuc-30i", "Fanuc"}, {"meldas", "MELDAS"},   {"mazatrol-iso", "Mazak EIA/ISO"},
    {"haas", "Haas"},       {"brother", "Brother"}, {"sinumerik-828d", "SINUMERIK 828D"}};

bool is_not_simulated(const runtime::Entry& entry) {
  const auto says_so = [](const std::string& text) {
    return text.find("not simulated") != std::string::npos ||
           text.find("not yet: alarm") != std::string::npos;
  };
  return says_so(entry.text) || std::ranges::any_of(entry.facts, [&](const runtime::Fact& fact) {
           return says_so(fact.value);
         });
}

void add_control(std::string& page, std::string_view title, const session::Control& control) {
  page += "\n## " + std::string(title) + "\n\n" + table_head({"name", "what it is", "text"});
  for (const runtime::Entry& entry : session::everything(control)) {
    if (entry.kind != "control" && is_not_simulated(entry)) {
      page += table_row({entry.name, entry.kind, entry.text});
    }
  }
}

}  // namespace

std::string not_simulated_page() {
  std::string page = page_head("What is not simulated", "not-simulated.md");
  page += kAboutTheWorld;
  for (const session::Control& control : session::all_controls()) {
    const std::string_view name = session::name_of(control);
    const auto* const titled = std::ranges::find(kTitles, name, &TitledControl::control);
    if (titled != std::end(kTitles)) {
      add_control(page, titled->title, control);
    }
  }
  return page;
}

}  // namespace g31::manual
