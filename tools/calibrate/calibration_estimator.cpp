// Builds the least-squares problem, lets Ceres solve it, and reads values and covariance from it.
#include "tools/calibrate/calibration_estimator.hpp"

#include <ceres/ceres.h>
#include <ceres/normal_prior.h>
#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>
#include <memory>

#include "tools/calibrate/parameter_layout.hpp"
#include "tools/calibrate/standing_model.hpp"

namespace gaitway::calibration {
namespace {

constexpr int kPasses = 2;  // the second with residuals weighed at the first one's result
constexpr int kIterations = 50;
constexpr double kDerivativeStep = 1e-4;  // in prior deviations

// One pose, its residuals in their own standard deviations.
class PoseCost {
 public:
  PoseCost(StandingModel& model, const ParameterLayout& layout, int placement, const Eigen::VectorXd& at)
      : model_(model), layout_(layout), placement_(placement) {
    root_.compute(model.covariance(layout.standing_robot(at), layout.ground(at, placement)));
    if (root_.info() != Eigen::Success) throw CalibrationError("a pose's residuals depend on each other");
  }

  [[nodiscard]] bool operator()(const double* const* parameters, double* residuals) const {
    const Eigen::VectorXd at = Eigen::Map<const Eigen::VectorXd>(parameters[0], layout_.size());
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(model_.noise_count());
    Eigen::Map<Eigen::VectorXd>(residuals, model_.residual_count()) = root_.matrixL().solve(
        model_.residuals(layout_.standing_robot(at), layout_.ground(at, placement_), none));
    return true;
  }

 private:
  StandingModel& model_;
  const ParameterLayout& layout_;
  int placement_;
  Eigen::LLT<Eigen::MatrixXd> root_;
};

// The whole robot on a pair of scales.
class WeighingCost {
 public:
  WeighingCost(const urdf::RobotModel& robot, const ParameterLayout& layout, const Weighing& weighing)
      : robot_(robot), layout_(layout), weighing_(weighing) {}

  [[nodiscard]] bool operator()(const double* const* parameters, double* residual) const {
    const RobotDeviations at =
        layout_.robot(Eigen::Map<const Eigen::VectorXd>(parameters[0], layout_.size()));
    residual[0] = (total_mass_kg(robot_, at) - weighing_.mass_kg) / weighing_.deviation_kg;
    return true;
  }

 private:
  const urdf::RobotModel& robot_;
  const ParameterLayout& layout_;
  Weighing weighing_;
};

template <class Cost>
void add_cost(ceres::Problem& problem, std::unique_ptr<Cost> cost, Eigen::VectorXd& parameters,
              Eigen::Index residuals) {
  ceres::NumericDiffOptions options;
  options.relative_step_size = kDerivativeStep;
  auto function = std::make_unique<ceres::DynamicNumericDiffCostFunction<Cost, ceres::CENTRAL>>(
      cost.release(), ceres::TAKE_OWNERSHIP, options);
  function->AddParameterBlock(static_cast<int>(parameters.size()));
  function->SetNumResiduals(static_cast<int>(residuals));
  problem.AddResidualBlock(function.release(), nullptr, parameters.data());
}

void check(const urdf::RobotModel& robot, const StandingMeasurement& pose, double described_N) {
  const auto refuse = [&pose](const std::string& what) {
    throw CalibrationError(fmt::format("pose '{}': {}", pose.pose, what));
  };
  if (pose.joint_rad.size() != robot.joints.size()) {
    refuse(fmt::format("{} joint angles; the robot '{}' has {} joints. Give one for each",
                       pose.joint_rad.size(), robot.name, robot.joints.size()));
  }
  if (!pose.stands[0] && !pose.stands[1]) refuse("no foot stands. Leave it out");
  double force_N = 0.0;
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t cell = 0; cell < kCells; ++cell) {
      if (pose.stands[side]) force_N += pose.force_N[side][cell];
      if (pose.stands[side] && !(pose.force_deviation_N[side][cell] > 0.0)) {
        refuse("the deviation of a force must be above 0. Take more than one sample");
      }
    }
  }
  constexpr double kLeastShare = 0.7, kMostShare = 1.4;
  if (!(force_N > kLeastShare * described_N && force_N < kMostShare * described_N)) {
    refuse(
        fmt::format("the standing feet bear {:.1f} N; the described robot weighs {:.1f} N. Correct the "
                    "measurement, or say which feet stand",
                    force_N, described_N));
  }
}

// The problem that one calibration is, from its inputs to its result.
class Estimation {
 public:
  Estimation(const urdf::RobotModel& robot, std::span<const StandingMeasurement> measurements,
             const CalibrationSettings& settings);
  Calibration run();

 private:
  void build(ceres::Problem& problem);
  void solve();
  [[nodiscard]] Estimate direct(Eigen::Index parameter, double prior, double value) const;
  [[nodiscard]] Eigen::RowVectorXd gradient(
      const std::function<double(const Eigen::VectorXd&)>& function) const;
  [[nodiscard]] Estimate derived(const std::function<double(const Eigen::VectorXd&)>& function) const;
  void write_imu(Calibration& result) const;
  void write_posture(Calibration& result) const;

  const urdf::RobotModel& robot_;
  CalibrationSettings settings_;
  std::vector<StandingModel> models_;
  std::vector<int> placement_of_;  // each pose's index of a placement, or -1
  std::unique_ptr<ParameterLayout> layout_;
  Eigen::VectorXd parameters_;
  Eigen::MatrixXd covariance_;
  double misfit_ = 0.0;
};

Estimation::Estimation(const urdf::RobotModel& robot, std::span<const StandingMeasurement> measurements,
                       const CalibrationSettings& settings)
    : robot_(robot), settings_(settings) {
  if (measurements.empty()) throw CalibrationError("there are no poses. Give at least one");
  std::map<int, int> index_of;
  std::vector<Eigen::Vector3d> placements;
  const RobotDeviations none = no_deviations(robot);
  models_.reserve(measurements.size());
  for (const StandingMeasurement& measurement : measurements) {
    check(robot, measurement, robot.total_mass_kg() * 9.81);
    StandingModel& model = models_.emplace_back(robot, measurement, settings_.standing);
    int index = -1;
    if (model.both_stand()) {
      const auto [found, is_new] =
          index_of.try_emplace(measurement.placement, static_cast<int>(placements.size()));
      if (is_new) placements.push_back(model.placement(none));
      index = found->second;
    }
    placement_of_.push_back(index);
  }
  layout_ = std::make_unique<ParameterLayout>(robot, settings_.manufacturing, settings_.standing,
                                              std::move(placements));
  parameters_.setZero(layout_->size());
}

void Estimation::build(ceres::Problem& problem) {
  problem.AddParameterBlock(parameters_.data(), static_cast<int>(parameters_.size()));
  ceres::Vector mean = ceres::Vector::Zero(layout_->size());
  problem.AddResidualBlock(
      new ceres::NormalPrior(ceres::Matrix::Identity(layout_->size(), layout_->size()), mean), nullptr,
      parameters_.data());
  if (settings_.weighing) {
    add_cost(problem, std::make_unique<WeighingCost>(robot_, *layout_, *settings_.weighing), parameters_, 1);
  }
  for (std::size_t i = 0; i < models_.size(); ++i) {
    add_cost(problem, std::make_unique<PoseCost>(models_[i], *layout_, placement_of_[i], parameters_),
             parameters_, models_[i].residual_count());
  }
}

void Estimation::solve() {
  ceres::Problem problem;
  build(problem);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_QR;
  options.max_num_iterations = kIterations;
  options.function_tolerance = 1e-10;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  if (!summary.IsSolutionUsable()) {
    throw CalibrationError("no deviations explain the measurements: " + summary.message);
  }
  // With a prior on each parameter, residuals minus parameters are the degrees of freedom: the measurements'.
  const double freedom = static_cast<double>(summary.num_residuals - summary.num_parameters);
  misfit_ = std::sqrt(2.0 * summary.final_cost / freedom);
  ceres::Covariance::Options covariance_options;
  covariance_options.algorithm_type = ceres::DENSE_SVD;
  ceres::Covariance covariance(covariance_options);
  if (!covariance.Compute(std::vector<const double*>{parameters_.data()}, &problem)) {
    throw CalibrationError("the measurements' covariance cannot be computed: a value is not finite");
  }
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> block(layout_->size(),
                                                                               layout_->size());
  covariance.GetCovarianceBlock(parameters_.data(), parameters_.data(), block.data());
  covariance_ = block;
}

Estimate Estimation::direct(Eigen::Index parameter, double prior, double value) const {
  return {value, prior * std::sqrt(covariance_(parameter, parameter)), prior};
}

Eigen::RowVectorXd Estimation::gradient(const std::function<double(const Eigen::VectorXd&)>& function) const {
  Eigen::RowVectorXd result(layout_->size());
  Eigen::VectorXd at = parameters_;
  for (Eigen::Index i = 0; i < layout_->size(); ++i) {
    at[i] = parameters_[i] + kDerivativeStep;
    result[i] = function(at);
    at[i] = parameters_[i] - kDerivativeStep;
    result[i] = (result[i] - function(at)) / (2.0 * kDerivativeStep);
    at[i] = parameters_[i];
  }
  return result;
}

// Linear in the parameters: so near to the description everything is.
Estimate Estimation::derived(const std::function<double(const Eigen::VectorXd&)>& function) const {
  const Eigen::RowVectorXd slope = gradient(function);
  return {function(parameters_), std::sqrt((slope * covariance_ * slope.transpose()).value()), slope.norm()};
}

void Estimation::write_imu(Calibration& result) const {
  for (const ImuSensor sensor : kImuSensors) {
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      const auto tilt_rad = [this, sensor, axis](const Eigen::VectorXd& at) {
        return tilt_said(sensor, robot_.imu, layout_->robot(at).imu, Eigen::Vector3d::UnitZ())[axis];
      };
      result.imu_tilt_rad[static_cast<std::size_t>(sensor)][static_cast<std::size_t>(axis)] =
          derived(tilt_rad);
    }
  }
}

void Estimation::write_posture(Calibration& result) const {
  for (std::size_t i = 0; i < kPostureErrors; ++i) {
    const Estimate estimate = derived(
        [this, i](const Eigen::VectorXd& at) { return posture_errors(robot_, layout_->robot(at))[i]; });
    const NamedQuantity& named = posture_quantities()[i];
    result.posture.push_back({std::string(named.name), std::string(named.unit), estimate});
  }
}

Calibration Estimation::run() {
  for (int pass = 0; pass < kPasses; ++pass) solve();
  Calibration result;
  result.deviations = layout_->robot(parameters_);
  result.misfit = misfit_;
  for (const StandingModel& model : models_) result.feet_on_edge += model.feet_on_edge();
  const ManufacturingDeviations& prior = layout_->deviations();
  for (std::size_t j = 0; j < robot_.joints.size(); ++j) {
    result.zero_rad.push_back(direct(layout_->zero(j), prior.joint_zero_rad, result.deviations.zero_rad[j]));
  }
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    result.trunk_com_m[static_cast<std::size_t>(axis)] =
        direct(layout_->trunk_com(axis), prior.trunk_com_m[axis], result.deviations.trunk_com_offset_m[axis]);
  }
  for (std::size_t side = 0; side < 2; ++side) {
    for (std::size_t cell = 0; cell < kCells; ++cell) {
      result.cell_gain[side][cell] =
          direct(layout_->cell(side, cell), prior.cell_gain, result.deviations.cell_gain[side][cell]);
    }
  }
  result.mass_kg =
      derived([this](const Eigen::VectorXd& at) { return total_mass_kg(robot_, layout_->robot(at)); });
  write_imu(result);
  write_posture(result);
  return result;
}

}  // namespace

Calibration calibrate(const urdf::RobotModel& robot, std::span<const StandingMeasurement> measurements,
                      const CalibrationSettings& settings) {
  return Estimation(robot, measurements, settings).run();
}

}  // namespace gaitway::calibration
