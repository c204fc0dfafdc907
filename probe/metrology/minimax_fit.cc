#include "probe/metrology/minimax_fit.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/LU>
#include <Eigen/QR>

namespace g31::metrology {
namespace {

constexpr int kMostExchanges = 20'000;
constexpr int kStalled = 30;
/// Rounding alone goes on where even Bland's rule does not get further.
constexpr int kMostStalled = 1'000;

/// A point that touches the zone from above (+1) or below (-1).
struct Touch {
  Eigen::Index point = 0;
  double side = 1.0;

  /// A number of its own, for Bland's rule.
  [[nodiscard]] Eigen::Index number() const { return 2 * point + (side > 0.0 ? 0 : 1); }
};

/// The simplex method: weights of touching points, and the function that they hold.
class Exchange {
 public:
  Exchange(const Eigen::MatrixXd& columns, const Eigen::VectorXd& values,
           const std::vector<Eigen::Index>& independent, machine::WorkWatch* watch)
      : columns_(columns),
        values_(values),
        tolerance_(1e-13 * values.cwiseAbs().maxCoeff()),
        watch_(watch) {
    touches_ = {{independent.front(), 1.0}, {independent.front(), -1.0}};
    for (std::size_t i = 1; i < independent.size(); ++i) {
      touches_.push_back({independent[i], 1.0});
    }
  }

  MinimaxFit run() {
    int stalled = 0;
    double best = -1.0;
    for (int i = 0; i < kMostExchanges && stalled < kMostStalled; ++i) {
      solve();
      stalled = half_width_ > best + tolerance_ ? 0 : stalled + 1;
      best = std::max(best, half_width_);
      const auto enters = entering(stalled > kStalled);
      if (!enters || !exchange(*enters)) {
        break;
      }
    }
    const Eigen::VectorXd off = values_ - columns_ * parameters_;
    return {parameters_, off.cwiseAbs().maxCoeff()};
  }

 private:
  [[nodiscard]] Eigen::VectorXd column_of(const Touch& touch) const {
    Eigen::VectorXd column(columns_.cols() + 1);
    column.head(columns_.cols()) = touch.side * columns_.row(touch.point).transpose();
    column[columns_.cols()] = 1.0;
    return column;
  }

  void solve() {
    const Eigen::Index size = columns_.cols() + 1;
    Eigen::MatrixXd basis(size, size);
    Eigen::VectorXd cost(size);
    for (Eigen::Index k = 0; k < size; ++k) {
      const Touch& touch = touches_[static_cast<std::size_t>(k)];
      basis.col(k) = column_of(touch);
      cost[k] = touch.side * values_[touch.point];
    }
    basis_.compute(basis);
    const Eigen::VectorXd held = basis_.transpose().solve(cost);
    parameters_ = held.head(columns_.cols());
    half_width_ = held[columns_.cols()];
    weights_ = basis_.solve(Eigen::VectorXd::Unit(size, size - 1));
  }

  /// The point furthest outside the zone; by Bland's rule the first one outside.
  [[nodiscard]] std::optional<Touch> entering(bool takes_first) const {
    const Eigen::VectorXd off = values_ - columns_ * parameters_;
    std::optional<Touch> enters;
    double furthest = half_width_ + tolerance_;
    for (Eigen::Index i = 0; i < off.size(); ++i) {
      if (watch_ != nullptr) {
        watch_->look();
      }
      if (std::abs(off[i]) > furthest) {
        enters = Touch{i, off[i] > 0.0 ? 1.0 : -1.0};
        furthest = std::abs(off[i]);
        if (takes_first) {
          break;
        }
      }
    }
    return enters;
  }

  bool exchange(const Touch& enters) {
    const Eigen::VectorXd change = basis_.solve(column_of(enters));
    const double scale = 1e-11 * change.cwiseAbs().maxCoeff();
    std::optional<std::size_t> leaves;
    double least = 0.0;
    for (std::size_t k = 0; k < touches_.size(); ++k) {
      const auto at = static_cast<Eigen::Index>(k);
      if (change[at] <= scale) {
        continue;
      }
      const double ratio = std::max(weights_[at], 0.0) / change[at];
      const bool is_less = !leaves || ratio < least - 1e-14;
      const bool is_tie =
          leaves && ratio <= least + 1e-14 && touches_[k].number() < touches_[*leaves].number();
      if (is_less || is_tie) {
        leaves = k;
        least = leaves && !is_less ? std::min(least, ratio) : ratio;
      }
    }
    if (leaves) {
      touches_[*leaves] = enters;
    }
    return leaves.has_value();
  }

  const Eigen::MatrixXd& columns_;
  const Eigen::VectorXd& values_;
  double tolerance_;
  machine::WorkWatch* watch_;
  std::vector<Touch> touches_;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> basis_;
  Eigen::VectorXd parameters_;
  Eigen::VectorXd weights_;
  double half_width_ = 0.0;
};

}  // namespace

std::optional<MinimaxFit> minimax_fit(const Eigen::MatrixXd& columns, const Eigen::VectorXd& values,
                                      machine::WorkWatch* watch) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> order(columns.transpose());
  order.setThreshold(1e-9);
  if (columns.rows() < columns.cols() || order.rank() < columns.cols()) {
    return std::nullopt;
  }
  // What a least-squares fit leaves is small: nothing is lost in large values.
  const Eigen::VectorXd start = columns.colPivHouseholderQr().solve(values);
  const Eigen::VectorXd rest = values - columns * start;
  std::vector<Eigen::Index> independent;
  for (Eigen::Index i = 0; i < columns.cols(); ++i) {
    independent.push_back(order.colsPermutation().indices()[i]);
  }
  MinimaxFit fit = Exchange(columns, rest, independent, watch).run();
  fit.parameters += start;
  return fit;
}

}  // namespace g31::metrology
