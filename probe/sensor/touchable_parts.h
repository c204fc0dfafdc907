#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "probe/collision/collision_mesh.h"
#include "probe/contact/contact_mesh.h"
#include "probe/contact/sweep_mesh.h"
#include "probe/sensor/bodies.h"

namespace g31::probe {

/// Parts with the trees that a probe asks: what takes long to make.  Immutable, so any number of
/// probes on any number of threads may share one.
class TouchableParts {
 public:
  struct Part {
    std::string name;
    bool is_solid = true;
    // What it means that a sensing tip touches it.
    Encounter on_moves = Encounter::Obstacle;
    Encounter on_skip_moves = Encounter::Signal;
    std::shared_ptr<const ContactMesh> mesh;
    std::vector<MeshSweeper> sweepers;  ///< one for each size of ball
  };

  /// @param setup  of its bodies only the sizes of balls count, and whether there are others
  /// @param parts  on the work's side
  /// @throws parts::BrokenOff  as `goes_on` has it
  TouchableParts(const ProbeSetup& setup, const std::vector<ProbedPart>& parts,
                 const parts::GoesOn& goes_on = {});

  [[nodiscard]] const std::vector<Part>& parts() const { return parts_; }

  /// For stem and bodies; empty without them.
  [[nodiscard]] const std::vector<CollisionMesh>& solids() const { return solids_; }

  /// Which of the sweepers a ball takes.  @pre one of the balls these parts were made for
  [[nodiscard]] std::size_t size_of(double radius) const;

 private:
  void add_radius(double radius);

  std::vector<double> radii_;
  std::vector<Part> parts_;
  std::vector<CollisionMesh> solids_;
};

}  // namespace g31::probe
