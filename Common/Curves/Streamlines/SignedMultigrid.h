// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ink
{

/// A V-cycle of multigrid by aggregation (Notay 2010, there without signs), as a preconditioner for
/// Eigen::ConjugateGradient: for symmetric, diagonally dominant matrices, entries of which may have either
/// sign, as those of graphs whose edges say that two unknowns are alike or opposite.
///
/// Unknowns are put together with those they are tied to, with a sign each; a coarser matrix is that of the
/// groups, whose unknowns differ in signs alone. The coarsest is solved directly.
class SignedMultigrid
{
public:
  using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor, std::int64_t>;
  using Vector = Eigen::VectorXd;

  /// What Eigen asks of a preconditioner. The matrix is copied.
  SignedMultigrid& compute(const Matrix& matrix);
  Vector solve(const Vector& residual) const { return this->cycle(0, residual); }
  Eigen::ComputationInfo info() { return Eigen::Success; }

  /// Of the matrix and the coarser ones.
  std::size_t levelCount() const { return this->Levels.size(); }

private:
  struct Level
  {
    Matrix matrix;
    Vector inverseDiagonal;
    /// Each unknown's group and sign in it; none for the coarsest.
    std::vector<Eigen::Index> groups;
    std::vector<double> signs;
  };

  Vector cycle(std::size_t level, const Vector& residual) const;

  std::vector<Level> Levels;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> Coarsest;
};

} // namespace ink
