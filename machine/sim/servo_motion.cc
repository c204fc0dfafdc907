#include "machine/sim/servo_motion.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "machine/base/contract.h"

namespace g31::machine {
namespace {

/// How exactly the places are found where what was left of the move before turns an axis back, mm.
constexpr double kTurnErrorMm = 1e-4;
constexpr int kMostPiecesOfPhase = 20'000;

/// Differences of places round, by e: in a piece of duration h the n-th power of the command is
/// wrong by e / h^n, and the lag takes it times T^n.  So a piece that is a smaller part of T than
/// these has no third, or no second power, which in so short a time makes no difference (under
/// 1e-11 mm).  A phase that rounding has left, of 1e-17 s, is such a piece.
constexpr double kLeastPartOfCubic = 1e-5;
constexpr double kLeastPartOfParabola = 1e-9;
constexpr double kLeastTimeConstant_s = 1e-3;  // axes that do not lag, too, divide by h^n

AxisPositions value_of(const std::array<AxisPositions, 4>& cubic, double t) {
  return cubic[0] + t * (cubic[1] + t * (cubic[2] + t * cubic[3]));
}

AxisPositions point_at(const CommandedPath& path, double fraction) {
  return std::visit([&](const auto& p) { return p.at(fraction); }, path);
}

const AxisPositions& start_of(const CommandedPath& path) {
  return std::visit([](const auto& p) -> const AxisPositions& { return p.from(); }, path);
}

double length_of(const CommandedPath& path) {
  return std::visit([](const auto& p) { return p.length(); }, path);
}

std::vector<MotionPhases> drives_of(const CommandedPath& path, const MotionPhases& phases) {
  const auto* const independent = std::get_if<IndependentPath>(&path);
  if (independent == nullptr) {
    return {phases};
  }
  std::vector<MotionPhases> drives;
  for (const auto& profile : independent->profiles()) {
    if (profile) {
      drives.push_back(profile->phases());
    }
  }
  return drives;
}

/// Times at which a phase of any of them ends, rising.
std::vector<double> boundaries(std::span<const MotionPhases> drives) {
  std::vector<double> marks;
  for (const MotionPhases& drive : drives) {
    double end_s = 0.0;
    for (const MotionPhase& phase : drive.phases()) {
      marks.push_back(end_s += phase.duration_s);
    }
  }
  std::ranges::sort(marks);
  return marks;
}

/// The phase in which a time lies, and when it begins; nullptr behind the last one.
std::pair<const MotionPhase*, double> phase_at(const MotionPhases& drive, double time_s) {
  double begin_s = 0.0;
  for (const MotionPhase& phase : drive.phases()) {
    if (time_s < begin_s + phase.duration_s) {
      return {&phase, begin_s};
    }
    begin_s += phase.duration_s;
  }
  return {nullptr, begin_s};
}

/// The command between two times with no boundary between them.
std::array<AxisPositions, 4> command_between(const IndependentPath& path,
                                             std::span<const MotionPhases> drives, double from_s,
                                             double to_s) {
  const AxisPositions none = AxisPositions::Zero();
  std::array<AxisPositions, 4> command = {path.to(), none, none, none};
  std::size_t next = 0;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    if (!path.profiles()[i]) {
      continue;
    }
    const auto [phase, begin_s] = phase_at(drives[next++], 0.5 * (from_s + to_s));
    if (phase == nullptr) {
      continue;
    }
    const auto axis = static_cast<Eigen::Index>(i);
    const double sign = path.to()[axis] > path.from()[axis] ? 1.0 : -1.0;
    const double t = from_s - begin_s;
    command[0][axis] = path.from()[axis] + sign * phase->distance_after(t);
    command[1][axis] = sign * phase->speed_after(t);
    command[2][axis] = sign * phase->acceleration_after(t) / 2.0;
    command[3][axis] = sign * phase->jerk / 6.0;
  }
  return command;
}

/// When a piece of a phase is, since the phase began, and how many powers its command has.
struct PieceTime {
  double from_s = 0.0;
  double duration_s = 0.0;
  int powers = 3;
};

/// A piece of a phase on a led way as a cubic of the time since its beginning.
struct LedPiece {
  std::array<AxisPositions, 4> command;
  AxisPositions end;
  bool is_close = false;  ///< within kLedErrorMm of the way
};

/// Through points of the way at equal times, one more than it has powers, and compared with the way
/// between them.
LedPiece led_piece(const LedPath& path, const MotionPhase& phase, const PieceTime& time) {
  const double duration_s = time.duration_s;
  const auto place = [&](double part) {
    const double distance = phase.distance_after(time.from_s + part * duration_s);
    return path.at(std::clamp(distance / path.length(), 0.0, 1.0));
  };
  const AxisPositions none = AxisPositions::Zero();
  const AxisPositions begin = place(0.0);
  const AxisPositions end = place(1.0);
  LedPiece piece{{begin, end - begin, none, none}, end, true};
  if (time.powers == 2) {
    const AxisPositions bend = 2.0 * (begin + end) - 4.0 * place(0.5);
    piece.command[1] -= bend;
    piece.command[2] = bend;
  } else if (time.powers == 3) {
    piece.command = cubic_through({begin, place(1.0 / 3.0), place(2.0 / 3.0), end});
  }
  double scale = 1.0;
  for (int power = 1; power <= time.powers; ++power) {
    scale /= duration_s;
    piece.command[static_cast<std::size_t>(power)] *= scale;
  }
  for (const double part : kFurthestFromQuartic) {
    const AxisPositions off = value_of(piece.command, part * duration_s) - place(part);
    piece.is_close = piece.is_close && off.cwiseAbs().maxCoeff() <= kLedErrorMm;
  }
  return piece;
}

/// Into how many pieces a phase on an arc is cut, so that a cubic through the ends of each, with
/// their speeds, stays within kArcCommandErrorMm: h^4 / 384 times the fourth derivative by time.
int pieces_of(const ArcPath& arc, const MotionPhase& phase) {
  const double radius = std::max(arc.radius(), kFullCircleGapMm);
  const double speed = std::max(phase.speed, phase.speed_after(phase.duration_s));
  const double acceleration =
      std::max(std::abs(phase.acceleration), std::abs(phase.acceleration_after(phase.duration_s)));
  const double w = speed / radius;
  const double dw = acceleration / radius;
  const double ddw = std::abs(phase.jerk) / radius;
  const double fourth = radius * (w * w * w * w + 6.0 * w * w * dw + 3.0 * dw * dw + 4.0 * w * ddw);
  const double h = std::pow(384.0 * kArcCommandErrorMm / std::max(fourth, 1e-30), 0.25);
  return std::clamp(static_cast<int>(std::min(phase.duration_s / h, 1e9)) + 1, 1,
                    kMostPiecesOfPhase);
}

}  // namespace

ServoMotion::ServoMotion(const CommandedPath& path, const MotionPhases& phases,
                         const ServoState& state, const ServoLoops& loops)
    : drives_(drives_of(path, phases)),
      time_constants_s_(loops.time_constants_s),
      feed_forward_s_(loops.feed_forward.cwiseProduct(loops.time_constants_s)),
      q_M_end_(start_of(path)),
      q_M_commanded_(q_M_end_),
      smoothing_(loops.smoothing),
      filter_(state.filter),
      lag_(state.lag),
      watch_(loops.watch) {
  G31_EXPECTS((time_constants_s_.array() >= 0.0).all());
  start_velocity_loops(loops, state);
  const double left = lag_.cwiseAbs().maxCoeff();
  if (left > kTurnErrorMm) {
    // It dies away as exp(-t / T), which bends by left / 8 (step / T)^2 in a step.
    const double t = time_constants_s_.maxCoeff();
    transient_s_ = t * std::log(left / kTurnErrorMm);
    transient_step_s_ = t * std::sqrt(8.0 * kTurnErrorMm / left);
  }
  const double length = length_of(path);
  for (const MotionPhase& phase : phases.phases()) {
    std::visit([&](const auto& p) { add_phase(p, phase); }, path);
  }
  // The sum of the phases rounds; the end of the path does not.
  constexpr double kRounding = 1e-12;
  if (length > 0.0) {
    const double fraction = phases.length() / length;
    q_M_end_ = point_at(path, fraction > 1.0 - kRounding ? 1.0 : std::max(0.0, fraction));
  }
  rest_filter();
  for (std::size_t i = 0; has_velocity_loops_ && i < kAxisCount; ++i) {
    if (velocity_loops_[i]) {
      velocity_loops_[i]->rest_at(q_M_commanded_[static_cast<Eigen::Index>(i)]);
    }
  }
}

void ServoMotion::start_velocity_loops(const ServoLoops& loops, const ServoState& state) {
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    if (loops.velocity[i].is_there() && time_constants_s_[axis] > 0.0) {
      velocity_loops_[i].emplace(LoopMotion::Setup{loops.velocity[i], 1.0 / time_constants_s_[axis],
                                                   loops.feed_forward[axis], loops.watch},
                                 q_M_end_[axis] - lag_[axis], state.velocity[i]);
      has_velocity_loops_ = true;
    }
  }
}

void ServoMotion::follow_in_velocity_loops(const Cubic& command, double duration_s) {
  for (std::size_t i = 0; has_velocity_loops_ && i < kAxisCount; ++i) {
    if (velocity_loops_[i]) {
      const auto axis = static_cast<Eigen::Index>(i);
      velocity_loops_[i]->follow(
          {command[0][axis], command[1][axis], command[2][axis], command[3][axis]}, duration_s);
    }
  }
}

void ServoMotion::take_velocity_loops(AxisPositions& q_M, double time_s) const {
  for (std::size_t i = 0; has_velocity_loops_ && i < kAxisCount; ++i) {
    if (velocity_loops_[i]) {
      q_M[static_cast<Eigen::Index>(i)] = velocity_loops_[i]->at(time_s).position;
    }
  }
}

void ServoMotion::add_phase(const StraightPath& line, const MotionPhase& phase) {
  const AxisPositions along = line.displacement() / line.length();
  add_piece({line.from() + phase.distance * along, phase.speed * along,
             phase.acceleration / 2.0 * along, phase.jerk / 6.0 * along},
            phase.duration_s);
}

void ServoMotion::add_phase(const IndependentPath& path, const MotionPhase& phase) {
  G31_EXPECTS(phase.speed == 1.0 && phase.acceleration == 0.0 && phase.jerk == 0.0);
  const double end_s = phase.distance + phase.duration_s;
  double from_s = phase.distance;
  for (const double mark_s : boundaries(drives_)) {
    const double to_s = std::min(mark_s, end_s);
    if (to_s > from_s) {
      add_piece(command_between(path, drives_, from_s, to_s), to_s - from_s);
      from_s = to_s;
    }
  }
}

int ServoMotion::powers_of(double duration_s) const {
  const double part = duration_s / std::max(time_constants_s_.maxCoeff(), kLeastTimeConstant_s);
  return part < kLeastPartOfParabola ? 1 : part < kLeastPartOfCubic ? 2 : 3;
}

void ServoMotion::add_phase(const ArcPath& arc, const MotionPhase& phase) {
  const AxisPositions none = AxisPositions::Zero();
  const double length = arc.length();
  const int count = pieces_of(arc, phase);
  const double h = phase.duration_s / count;
  const int powers = powers_of(h);
  const auto fraction = [&](int i) {
    return std::clamp(phase.distance_after(i * h) / length, 0.0, 1.0);
  };
  for (int i = 0; i < count; ++i) {
    const AxisPositions q_from = arc.at(fraction(i));
    const AxisPositions way = arc.at(fraction(i + 1)) - q_from;
    const AxisPositions v_from = phase.speed_after(i * h) / length * h * arc.slope_at(fraction(i));
    const AxisPositions v_to =
        phase.speed_after((i + 1) * h) / length * h * arc.slope_at(fraction(i + 1));
    Cubic command = {q_from, v_from / h, none, none};
    if (powers == 2) {
      command[2] = (way - v_from) / (h * h);
    } else if (powers == 3) {
      command[2] = (3.0 * way - 2.0 * v_from - v_to) / (h * h);
      command[3] = (v_from + v_to - 2.0 * way) / (h * h * h);
    }
    add_piece(command, h);
  }
}

void ServoMotion::add_phase(const LedPath& path, const MotionPhase& phase) {
  constexpr double kShortestPart = 1.0 / kMostPiecesOfPhase;
  double from_s = 0.0;
  double step_s = phase.duration_s;
  AxisPositions way_before = AxisPositions::Zero();
  while (from_s < phase.duration_s) {
    look();
    // What is left is not cut so that next to nothing remains.
    const double left_s = phase.duration_s - from_s;
    const bool is_last = left_s <= 1.01 * step_s;
    const double to_s = is_last ? phase.duration_s : from_s + step_s;
    const double duration_s = to_s - from_s;
    const LedPiece piece = led_piece(path, phase, {from_s, duration_s, powers_of(duration_s)});
    if (piece.is_close || duration_s <= kShortestPart * phase.duration_s) {
      const AxisPositions way = piece.end - piece.command[0];
      add_piece(piece.command, duration_s);
      pieces_.back().turns_back =
          !path.is_short() || from_s == 0.0 || (way.array() * way_before.array() < 0.0).any();
      way_before = way;
      from_s = to_s;
      step_s *= 1.5;
    } else {
      step_s = 0.5 * duration_s;
    }
  }
}

void ServoMotion::rest_filter() {
  const bool comes_to_rest = smoothing_ == Smoothing::ToRest;
  if (comes_to_rest && filter_.rest_s() > 0.0) {
    const AxisPositions none = AxisPositions::Zero();
    add_piece({q_M_end_, none, none, none}, filter_.rest_s());
  }
  if (smoothing_ != Smoothing::On) {
    q_M_commanded_ = q_M_end_;
    filter_ = {};
  }
}

void ServoMotion::add_piece(const Cubic& command, double duration_s) {
  if (smoothing_ == Smoothing::Off) {
    follow_piece(command, duration_s);
    return;
  }
  std::vector<CommandPiece> smoothed;
  filter_.take({command, duration_s}, smoothed);
  for (const CommandPiece& piece : smoothed) {
    look();
    follow_piece(piece.command, piece.duration_s);
  }
}

void ServoMotion::follow_piece(const Cubic& command, double duration_s) {
  Piece piece;
  piece.begin_s = duration_s_;
  piece.duration_s = duration_s;
  piece.command = command;
  // T y' + y = u has the solution u - T u' + T^2 u'' - T^3 u''', and what dies away; u = c + a T
  // c'.
  const AxisPositions& t = time_constants_s_;
  const AxisPositions& ahead = feed_forward_s_;
  Cubic& y = piece.response;
  y[3] = command[3];
  y[2] = command[2] + 3.0 * (ahead - t).cwiseProduct(command[3]);
  y[1] = command[1] + 2.0 * (ahead.cwiseProduct(command[2]) - t.cwiseProduct(y[2]));
  y[0] = command[0] + ahead.cwiseProduct(command[1]) - t.cwiseProduct(y[1]);
  piece.dying = (command[0] - lag_) - y[0];
  pieces_.push_back(piece);
  follow_in_velocity_loops(command, duration_s);
  duration_s_ += duration_s;
  AxisPositions q_M_encoder = encoder_in(piece, duration_s);
  take_velocity_loops(q_M_encoder, duration_s_);
  q_M_commanded_ = value_of(command, duration_s);
  lag_ = q_M_commanded_ - q_M_encoder;
}

const ServoMotion::Piece& ServoMotion::piece_at(double time_s) const {
  const auto after = std::ranges::upper_bound(pieces_, time_s, {}, &Piece::begin_s);
  return *(after - 1);
}

AxisPositions ServoMotion::decay(double time_s) const {
  AxisPositions share = AxisPositions::Zero();
  for (Eigen::Index i = 0; i < share.size(); ++i) {
    if (time_constants_s_[i] > 0.0) {
      share[i] = std::exp(-time_s / time_constants_s_[i]);
    }
  }
  return share;
}

AxisPositions ServoMotion::encoder_in(const Piece& piece, double time_s) const {
  return value_of(piece.response, time_s) + piece.dying.cwiseProduct(decay(time_s));
}

AxisPositions ServoMotion::commanded_at(double time_s) const {
  G31_EXPECTS(time_s >= 0.0);
  if (time_s >= duration_s_) {
    return q_M_commanded_;
  }
  const Piece& piece = piece_at(time_s);
  return value_of(piece.command, time_s - piece.begin_s);
}

AxisPositions ServoMotion::encoder_at(double time_s) const {
  G31_EXPECTS(time_s >= 0.0);
  AxisPositions q_M;
  if (time_s >= duration_s_) {
    q_M = q_M_commanded_ - lag_.cwiseProduct(decay(time_s - duration_s_));
  } else {
    const Piece& piece = piece_at(time_s);
    q_M = encoder_in(piece, time_s - piece.begin_s);
  }
  take_velocity_loops(q_M, time_s);
  return q_M;
}

ServoState ServoMotion::state_at(double time_s) const {
  ServoState state{lag_at(time_s), {}, filter_};
  for (std::size_t i = 0; has_velocity_loops_ && i < kAxisCount; ++i) {
    if (velocity_loops_[i]) {
      state.velocity[i] = velocity_loops_[i]->at(time_s).state;
    }
  }
  return state;
}

double ServoMotion::in_position_s(const AxisPositions& widths) const {
  G31_EXPECTS((widths.array() > 0.0).all());
  double wait_s = 0.0;
  for (Eigen::Index i = 0; i < lag_.size(); ++i) {
    const double lag = std::abs(lag_[i]);
    const double width = widths[i];
    if (const auto& loop = velocity_loops_[static_cast<std::size_t>(i)]) {
      wait_s = std::max(wait_s, loop->within_s(width) - duration_s_);
    } else if (lag > width) {
      wait_s = std::max(wait_s, time_constants_s_[i] * std::log(lag / width));
    }
  }
  return duration_s_ + wait_s;
}

std::vector<double> ServoMotion::steps_until(double time_s) const {
  std::vector<double> steps = {0.0};
  for (const Piece& piece : pieces_) {
    if (piece.turns_back) {
      steps.push_back(std::min(time_s, piece.begin_s));
    }
  }
  const double transient_s = std::min(time_s, transient_s_);
  for (int i = 1; i * transient_step_s_ < transient_s; ++i) {
    steps.push_back(i * transient_step_s_);
  }
  steps.push_back(std::min(time_s, duration_s_));
  steps.push_back(time_s);
  std::ranges::sort(steps);
  steps.erase(std::unique(steps.begin(), steps.end()), steps.end());
  return steps;
}

}  // namespace g31::machine
