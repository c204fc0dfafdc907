#include "machine/sim/true_way.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace g31::machine {
namespace {

/// Between tables of errors nothing is finer than this without showing at a quarter of it.
constexpr double kFirstPieceMm = 5.0;
constexpr int kMostHalvings = 24;

class Subdivision {
 public:
  Subdivision(const TruePosition& start, const StraightPath& path, std::vector<Waypoint>& way)
      : start_(start), path_(path), way_(way) {}

  void add_pieces(double fraction_from, double fraction_to) {
    const int count = std::max(1, static_cast<int>(std::ceil(path_.length() / kFirstPieceMm)));
    fraction_from_ = fraction_from;
    fraction_span_ = fraction_to - fraction_from;
    Piece piece{0.0, 0.0, start_.after(path_.from()), {}};
    if (way_.empty()) {
      way_.push_back({fraction_from, piece.q_M_from});
    }
    for (int i = 1; i <= count; ++i) {
      piece.to = static_cast<double>(i) / count;
      piece.q_M_to = start_.after(path_.at(piece.to));
      add(piece, kMostHalvings);
      piece.from = piece.to;
      piece.q_M_from = piece.q_M_to;
    }
  }

 private:
  struct Piece {
    double from = 0.0;  // parts of the path
    double to = 0.0;
    AxisPositions q_M_from;
    AxisPositions q_M_to;
  };

  [[nodiscard]] AxisPositions inside(const Piece& piece, double part) const {
    return start_.after(path_.at(piece.from + part * (piece.to - piece.from)));
  }

  [[nodiscard]] bool is_straight(const Piece& piece, const AxisPositions& q_M_middle) const {
    const std::array<AxisPositions, 3> q_M = {inside(piece, 0.25), q_M_middle, inside(piece, 0.75)};
    for (std::size_t i = 0; i < q_M.size(); ++i) {
      const double part = 0.25 * static_cast<double>(i + 1);
      const AxisPositions off = q_M[i] - piece.q_M_from - part * (piece.q_M_to - piece.q_M_from);
      if (off.cwiseAbs().maxCoeff() > 0.5 * kTrueWayErrorMm) {
        return false;
      }
    }
    return true;
  }

  void add(const Piece& piece, int halvings) {
    const AxisPositions q_M_middle = inside(piece, 0.5);
    if (halvings == 0 || is_straight(piece, q_M_middle)) {
      way_.push_back({fraction_from_ + piece.to * fraction_span_, piece.q_M_to});
      return;
    }
    const double middle = 0.5 * (piece.from + piece.to);
    add({piece.from, middle, piece.q_M_from, q_M_middle}, halvings - 1);
    add({middle, piece.to, q_M_middle, piece.q_M_to}, halvings - 1);
  }

  const TruePosition& start_;
  const StraightPath& path_;
  std::vector<Waypoint>& way_;
  double fraction_from_ = 0.0;
  double fraction_span_ = 1.0;
};

}  // namespace

std::vector<Waypoint> true_way(const TruePosition& start, const StraightPath& path) {
  std::vector<Waypoint> way;
  Subdivision(start, path, way).add_pieces(0.0, 1.0);
  return way;
}

std::vector<Waypoint> true_way(const TruePosition& start, const CurvedSweep& curve) {
  std::vector<Waypoint> way;
  TruePosition truth = start;
  for (int i = 0; i < curve.chords; ++i) {
    const double from = static_cast<double>(i) / curve.chords;
    const double to = static_cast<double>(i + 1) / curve.chords;
    const StraightPath chord(curve.q_M_at(from), curve.q_M_at(to));
    Subdivision(truth, chord, way).add_pieces(from, to);
    truth.go_to(chord.to());
  }
  return way;
}

}  // namespace g31::machine
