// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

namespace ink
{

/// The solution of least norm of a system's normal equations, A^T A x = A^T b, by the eigenvalues of A^T A:
/// the pseudoinverse of A, whether there are fewer equations than unknowns, as many, or more. Zero along
/// directions that the equations do not determine.
template <int size, int columns = 1>
Eigen::Matrix<double, size, columns> leastNormSolution(
  const Eigen::Matrix<double, size, size>& matrix, const Eigen::Matrix<double, size, columns>& right)
{
  constexpr double rankTolerance = 1e-10;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, size, size>> solver(matrix);
  const auto& values = solver.eigenvalues();
  const double least = rankTolerance * values[size - 1];
  Eigen::Matrix<double, size, columns> x = solver.eigenvectors().transpose() * right;
  for (int i = 0; i < size; ++i)
  {
    x.row(i) *= values[i] > least ? 1.0 / values[i] : 0.0;
  }
  return solver.eigenvectors() * x;
}

} // namespace ink
