// Positions: between work coordinates, those of paths and the axes, with TRAORI and without.

#include <memory>

#include "interpreter/dialects/sinumerik/state/channel.h"
#include "interpreter/path/chain_transform.h"

namespace g31::sinumerik {
namespace {

/// How far rounding leaves a rotation off one.
constexpr double kSameTurn = 1e-12;

}  // namespace

const machine::Transformation* Channel::transformation() const {
  if (!orientation.chain) {
    return nullptr;
  }
  if (!transformation_) {
    transformation_.emplace(*orientation.chain, -linear_axes(edge_offset()));
  }
  return &*transformation_;
}

const machine::AxisTransformPtr& Channel::leads() const {
  const machine::Transformation* const by = transformation();
  const Eigen::Matrix3d& turn = path_turn();
  if (by != nullptr && !leads_) {
    leads_ = std::make_shared<path::ChainTransform>(*by, turn);
  }
  return leads_;
}

const Eigen::Matrix3d& Channel::path_turn() const {
  // Any turn serves a block that leaves frames out: the next one has them again.
  if (!path_turn_is_old_ || holds_path() || suppression != 0) {
    return path_turn_;
  }
  path_turn_is_old_ = false;
  const Eigen::Matrix3d turn =
      orientation.chain ? active_frame().turn() : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  // Unequal scales make of a frame in a turned one what no rotation is.
  const bool is_rotation = turn.isUnitary(kSameTurn);
  path_turn_ = is_rotation ? turn : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
  leads_.reset();
  q_M_of_path_.reset();
  return path_turn_;
}

std::array<double, 2> Channel::angles_of(const AxisPositions& q_M) const {
  std::array<double, 2> deg = {};
  for (std::size_t i = 0; i < 2; ++i) {
    const int axis = orientation.traori_vectors.axes.at(i);
    deg.at(i) = axis >= 0 ? q_M[axis] - orientation.traori_basic_deg.at(i) : 0.0;
  }
  return deg;
}

Eigen::Matrix3d Channel::turn_of_part(const AxisPositions& q_M) const {
  return orientation.chain
             ? Eigen::Matrix3d(orientation.traori_vectors.part_motion(angles_of(q_M)).linear())
             : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
}

Eigen::Vector3d Channel::tool_direction(const AxisPositions& q_M) const {
  return tool_turned(q_M, orientation.upright(plane().normal));
}

Eigen::Vector3d Channel::tool_side(const AxisPositions& q_M) const {
  return tool_turned(q_M, Eigen::Vector3d::Unit(plane().first));
}

Eigen::Vector3d Channel::tool_turned(const AxisPositions& q_M,
                                     const Eigen::Vector3d& upright) const {
  if (orientation.chain) {
    return turn_of_part(q_M).transpose() *
           (orientation.traori_vectors.tool_turn(angles_of(q_M)) * upright);
  }
  return orientation.carrier != 0
             ? Eigen::Vector3d(orientation.vectors.tool_turn(orientation.deg) * upright)
             : upright;
}

AxisPositions Channel::to_machine(const AxisPositions& q_W) const {
  const machine::Transformation* const by = transformation();
  const auto placed = [&](const Placement& placement) -> AxisPositions {
    const AxisPositions q = placement.frame.apply(q_W);
    return by == nullptr ? AxisPositions(q + placement.offset)
                         : by->axes_for(linear_axes(q), q).value();
  };
  return suppression != 0 ? placed({active_frame(), tool_offset()}) : placed(placement());
}

const Channel::Placement& Channel::placement() const {
  if (!placement_) {
    placement_ = {active_frame(), tool_offset()};
  }
  return *placement_;
}

AxisPositions Channel::to_path(const AxisPositions& q_W) const {
  if (!orientation.chain) {
    return to_machine(q_W);
  }
  AxisPositions q_P = suppression != 0 ? active_frame().apply(q_W) : placement().frame.apply(q_W);
  q_P.head<kLinearAxisCount>() = (path_turn().transpose() * linear_axes(q_P)).eval();
  return q_P;
}

AxisPositions Channel::path_to_basic(const AxisPositions& q_P) const {
  if (!orientation.chain) {
    return q_P - tool_offset();
  }
  AxisPositions q = q_P;
  q.head<kLinearAxisCount>() = path_turn() * linear_axes(q_P);
  return q;
}

AxisPositions Channel::path_to_work(const AxisPositions& q_P) const {
  return active_frame().undo(path_to_basic(q_P));
}

AxisPositions Channel::machine_to_path(const AxisPositions& q_M) const {
  return orientation.chain ? leads()->base_at(q_M) : q_M;
}

AxisPositions Channel::path_to_machine(const AxisPositions& q_P) const {
  return orientation.chain ? leads()->axes_at(q_P).value() : q_P;
}

AxisPositions Channel::to_basic(const AxisPositions& q_M) const {
  const machine::Transformation* const by = transformation();
  if (by == nullptr) {
    return q_M - tool_offset();
  }
  AxisPositions q = q_M;
  q.head<kLinearAxisCount>() = by->tip_for(q_M);
  return q;
}

AxisPositions Channel::to_work(const AxisPositions& q_M) const {
  return active_frame().undo(to_basic(q_M));
}

AxisPositions Channel::present() {
  return programmed_place.is_stale ? to_work(machine_position()) : programmed_place.q_W;
}

AxisPositions Channel::machine_position() const {
  return holds_path() ? path_to_machine(programmed_place.q_P) : port.position();
}

AxisPositions Channel::path_position() const {
  if (holds_path()) {
    return programmed_place.q_P;
  }
  const AxisPositions q_M = port.position();
  if (!orientation.chain) {
    return q_M;
  }
  if (path_turn_is_old_ || q_M_of_path_ != q_M) {
    q_P_here_ = machine_to_path(q_M);
    q_M_of_path_ = q_M;
  }
  return q_P_here_;
}

void Channel::arrived_at_programmed(const AxisPositions& q_W, const AxisPositions& q_P) {
  programmed_place = {q_W, q_P, suppression != 0};
  q_M_of_path_.reset();
  if (orientation.chain && !holds_path()) {
    q_P_here_ = q_P;
    q_M_of_path_ = port.position();
  }
}

void Channel::arrived_at_machine() {
  const AxisPositions q_M = port.position();
  programmed_place = {to_work(q_M), machine_to_path(q_M), suppression != 0};
  q_M_of_path_.reset();
}

}  // namespace g31::sinumerik
