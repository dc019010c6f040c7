// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <complex>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ink
{

/// A V-cycle of multigrid by aggregation (Notay 2010, there of real numbers), as a preconditioner for
/// Eigen::ConjugateGradient: for Hermitian, diagonally dominant matrices, as those of connection Laplacians
/// (Singer and Wu 2012), whose edges say that an unknown is another one turned by an angle.
///
/// Unknowns are put together with those they are tied to, with a turn each; a coarser matrix is that of the
/// groups, whose unknowns differ in turns alone. The coarsest is solved directly.
class ConnectionMultigrid
{
public:
  using Scalar = std::complex<double>;
  using Matrix = Eigen::SparseMatrix<Scalar, Eigen::RowMajor, std::int64_t>;
  using Vector = Eigen::VectorXcd;

  /// What Eigen asks of a preconditioner. The matrix is copied.
  ConnectionMultigrid& compute(const Matrix& matrix);
  Vector solve(const Vector& residual) const { return this->cycle(0, residual); }
  Eigen::ComputationInfo info() { return Eigen::Success; }

  /// Of the matrix and the coarser ones.
  std::size_t levelCount() const { return this->Levels.size(); }

private:
  struct Level
  {
    Matrix matrix;
    Eigen::VectorXd inverseDiagonal;
    /// Each unknown's group, and the turn from that to it, of length 1; none for the coarsest.
    std::vector<Eigen::Index> groups;
    std::vector<Scalar> turns;
  };

  Vector cycle(std::size_t level, const Vector& residual) const;

  std::vector<Level> Levels;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<Scalar>> Coarsest;
};

} // namespace ink
