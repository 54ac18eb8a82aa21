#pragma once

#include <Eigen/Core>
#include <Eigen/SparseLU>

#include "case/case.hpp"
#include "column/section.hpp"
#include "column/section_balance.hpp"

namespace riffle::inline column {

/// Solves (diagonal + J) x = b, J = matrix + column row^T the Jacobian of a section: a sparse factorisation
/// and the formula of Sherman and Morrison.
class SectionFactorisation {
  public:
    /// Throws InputError where the matrix is singular.
    void compute(const SectionJacobian& jacobian, const Eigen::VectorXd& diagonal);

    [[nodiscard]] Eigen::VectorXd solve(const Eigen::VectorXd& right) const;

  private:
    Eigen::SparseLU<Eigen::SparseMatrix<double>> factors_;
    bool analysed_ = false;
    Eigen::VectorXd column_;  ///< solution for the column
    Eigen::VectorXd row_;
    double denominator_ = 1.0;
};

/// Throws InputError, saying what to change, unless has_section().
void check_section(const Case& c);

/// The velocities of the half section as a result; its relaxation time is 0.
[[nodiscard]] SectionResult section_result(const Case& c, const SectionGrid& grid,
                                           const SectionBalance& balance, const Eigen::VectorXd& u);

/// Velocities of a result at the centres of a grid.
[[nodiscard]] Eigen::VectorXd velocities_on(const SectionGrid& grid, const SectionResult& result);

}  // namespace riffle::inline column
