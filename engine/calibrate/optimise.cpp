#include "engine/calibrate/optimise.hpp"

#include <fmt/format.h>
#include <pliant/error.hpp>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <unsupported/Eigen/LevenbergMarquardt>

namespace pliant::calibrate {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int runs_are_spent = -1;

/// The model as a function of the angles of its parameters. Stores what it has evaluated.
class Model {
 public:
  Model(const std::vector<Parameter>& parameters, const Evaluate& evaluate,
        const OptimiserOptions& options)
      : parameters_(parameters), evaluate_(evaluate), options_(options) {}

  int runs() const { return static_cast<int>(known_.size()); }

  /// False if the runs do not suffice.
  bool provide(const std::vector<VectorXd>& points) {
    std::vector<std::vector<double>> missing;
    for (const VectorXd& point : points) {
      const std::vector<double> values = values_at(point);
      if (!known_.contains(values)) missing.push_back(values);
    }
    if (runs() + static_cast<int>(missing.size()) > options_.most_runs) return false;
    if (missing.empty()) return true;
    const auto found = evaluate_(missing);
    for (std::size_t i = 0; i < missing.size(); ++i) known_[missing[i]] = found[i];
    return true;
  }

  const std::optional<Residuals>& at(const VectorXd& point) const {
    return known_.at(values_at(point));
  }

  /// The point and its neighbours, one for each parameter.
  std::vector<VectorXd> stencil(const VectorXd& point) const {
    std::vector<VectorXd> points = {point};
    for (Eigen::Index i = 0; i < point.size(); ++i) {
      points.push_back(point);
      points.back()[i] += step(point[i]);
    }
    return points;
  }

  MatrixXd slopes(const VectorXd& point) const {
    const std::vector<VectorXd> points = stencil(point);
    const Residuals& here = *at(point);
    MatrixXd result(here.size(), point.size());
    for (Eigen::Index i = 0; i < point.size(); ++i) {
      const auto& there = at(points[static_cast<std::size_t>(i) + 1]);
      if (!there) {
        throw InputError(
            fmt::format("{}: the case cannot be run beside {:.6g}; give narrower bounds",
                        parameters_[i].key, values_at(point)[i]));
      }
      for (std::size_t r = 0; r < here.size(); ++r) {
        result(r, i) = ((*there)[r] - here[r]) / step(point[i]);
      }
    }
    return result;
  }

  std::vector<double> values_at(const VectorXd& point) const {
    std::vector<double> values(parameters_.size());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = parameters_[i].value(point[i]);
    return values;
  }

 private:
  /// Points away from the nearer bound.
  double step(double angle) const {
    return std::sin(angle) > 0 ? -options_.difference : options_.difference;
  }

  const std::vector<Parameter>& parameters_;
  const Evaluate& evaluate_;
  const OptimiserOptions& options_;
  std::map<std::vector<double>, std::optional<Residuals>> known_;
};

/// The interface for Eigen's optimiser.
struct Functor : Eigen::DenseFunctor<double> {
  Functor(Model& a_model, int inputs, int values) : DenseFunctor(inputs, values), model(a_model) {}

  int operator()(const VectorXd& point, VectorXd& residuals) const {
    if (!model.provide({point})) return runs_are_spent;
    const auto& found = model.at(point);
    // Where the model has no values, large residuals make the optimiser shorten the step.
    constexpr double bad = 1e6;
    residuals.setConstant(values(), bad);
    if (found) std::copy(found->begin(), found->end(), residuals.data());
    return 0;
  }

  int df(const VectorXd& point, MatrixXd& slopes) const {
    if (!model.provide(model.stencil(point))) return runs_are_spent;
    slopes = model.slopes(point);
    return 0;
  }

  Model& model;
};

Determination determination_of(const Parameter& parameter, double value, double error) {
  const double width = parameter.upper - parameter.lower;
  const bool at_bound = std::min(value - parameter.lower, parameter.upper - value) < 1e-3 * width;
  if (at_bound || !(error <= 0.5 * std::abs(value))) return Determination::not_at_all;
  return error <= 0.05 * std::abs(value) ? Determination::well : Determination::poorly;
}

/// Standard errors and correlations, from the slopes of the residuals with respect to the values. A
/// direction that does not affect the residuals has infinite variance, represented by a large
/// number.
void add_errors(Calibration& result, const std::vector<Parameter>& parameters, MatrixXd slopes) {
  const auto count = static_cast<Eigen::Index>(parameters.size());
  VectorXd scale(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    scale[i] = std::max(std::abs(result.parameters[i].value), 1e-300);
    slopes.col(i) *= scale[i];  // relative changes of the values
  }
  const VectorXd residuals = Eigen::Map<const VectorXd>(result.residuals.data(), slopes.rows());
  const double freedom = std::max<double>(1, static_cast<double>(slopes.rows() - count));
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(slopes.transpose() * slopes);
  const double floor = std::max(1e-14 * solver.eigenvalues().maxCoeff(), 1e-300);
  const VectorXd inverse = solver.eigenvalues().cwiseMax(floor).cwiseInverse();
  const MatrixXd covariance = residuals.squaredNorm() / freedom * solver.eigenvectors() *
                              inverse.asDiagonal() * solver.eigenvectors().transpose();
  const VectorXd errors = covariance.diagonal().cwiseSqrt();
  for (Eigen::Index i = 0; i < count; ++i) {
    Estimated& parameter = result.parameters[i];
    parameter.error = errors[i] * scale[i];
    parameter.determination = determination_of(parameters[i], parameter.value, parameter.error);
    result.correlation.emplace_back(static_cast<std::size_t>(count), 1.0);
    for (Eigen::Index j = 0; j < count; ++j) {
      if (i != j) result.correlation[i][j] = covariance(i, j) / (errors[i] * errors[j]);
    }
  }
}

/// False if the runs are used up. In long valleys of hardly determined parameters, the search also
/// ends at a step that lowers the sum of squares by less than a tenth of the variance, below a
/// third of a standard error.
bool search_minimum(Eigen::LevenbergMarquardt<Functor>& optimiser, int freedom, VectorXd& point) {
  using Status = Eigen::LevenbergMarquardtSpace::Status;
  const auto squares = [&] { return optimiser.fnorm() * optimiser.fnorm(); };
  Status status = optimiser.minimizeInit(point);
  double before = std::numeric_limits<double>::infinity();
  while (status == Status::NotStarted || status == Status::Running) {
    status = optimiser.minimizeOneStep(point);
    if (status == Status::Running && before - squares() < 0.1 * squares() / std::max(1, freedom)) {
      return true;
    }
    before = squares();
  }
  return status != Status::UserAsked;
}

}  // namespace

Calibration optimise(const std::vector<Parameter>& parameters, const Evaluate& evaluate,
                     const OptimiserOptions& options) {
  const int count = static_cast<int>(parameters.size());
  VectorXd point(count);
  for (int i = 0; i < count; ++i) point[i] = parameters[i].angle(parameters[i].start);
  // Reserves runs for the errors at the result.
  OptimiserOptions search = options;
  search.most_runs = options.most_runs - count;
  Model model(parameters, evaluate, search);
  if (!model.provide({point}) || !model.at(point)) {
    throw InputError("the case cannot be run with the start values; give others");
  }
  Functor functor(model, count, static_cast<int>(model.at(point)->size()));
  Eigen::LevenbergMarquardt<Functor> optimiser(functor);
  optimiser.setFtol(options.tolerance);
  optimiser.setXtol(options.tolerance);
  optimiser.setFactor(1);
  Calibration result;
  result.has_converged = search_minimum(optimiser, functor.values() - count, point);
  search.most_runs = options.most_runs;
  result.residuals = *model.at(point);
  for (const double value : model.values_at(point)) {
    result.parameters.push_back({value, std::numeric_limits<double>::infinity()});
  }
  if (model.provide(model.stencil(point))) {
    MatrixXd slopes = model.slopes(point);
    for (int i = 0; i < count; ++i) {
      const double slope = parameters[i].slope(point[i]);
      slopes.col(i) /= std::abs(slope) > 1e-300 ? slope : 1e-300;
    }
    add_errors(result, parameters, slopes);
  }
  result.runs = model.runs();
  return result;
}

}  // namespace pliant::calibrate
