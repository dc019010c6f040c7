// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/SignedMultigrid.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ink
{

namespace
{

using Matrix = SignedMultigrid::Matrix;
using Index = Eigen::Index;

constexpr Index none = -1;
/// So many unknowns are solved for directly.
constexpr Index fewUnknowns = 500;
/// Of Jacobi's smoother; below 1, the eigenvalues of what it is applied to being 2 at most.
constexpr double damping = 0.67;
/// Groups are stiffer than the unknowns in them, so their correction falls short (Braess 1995).
constexpr double overcorrection = 1.8;
/// Of a row's strongest tie: those that make a group.
constexpr double strong = 0.25;

/// Calls visit(column, value) for the entries of a row off the diagonal that are not zero.
template <class Visit>
void visitTies(const Matrix& matrix, Index row, const Visit& visit)
{
  for (Matrix::InnerIterator entry(matrix, row); entry; ++entry)
  {
    if (entry.col() != row && entry.value() != 0.0)
    {
      visit(entry.col(), entry.value());
    }
  }
}

/// Groups of unknowns with their strong neighbors; what is left joins the group that it is tied to most.
/// @return how many
Index makeGroups(const Matrix& matrix, std::vector<Index>& groups, std::vector<double>& signs)
{
  const Index count = matrix.rows();
  groups.assign(static_cast<std::size_t>(count), none);
  signs.assign(static_cast<std::size_t>(count), 1.0);
  const auto groupOf = [&](Index i) -> Index& { return groups[static_cast<std::size_t>(i)]; };
  const auto signOf = [&](Index i) -> double& { return signs[static_cast<std::size_t>(i)]; };
  Index number = 0;
  for (Index i = 0; i < count; ++i)
  {
    double strongest = 0.0;
    bool isFree = groupOf(i) == none;
    bool isAlone = true;
    visitTies(matrix, i,
      [&](Index j, double value)
      {
        strongest = std::max(strongest, std::abs(value));
        isAlone = false;
        isFree = isFree && groupOf(j) == none;
      });
    if (!isFree)
    {
      continue;
    }
    groupOf(i) = number;
    visitTies(matrix, i,
      [&](Index j, double value)
      {
        if (!isAlone && std::abs(value) >= strong * strongest)
        {
          groupOf(j) = number;
          signOf(j) = value > 0.0 ? -1.0 : 1.0;
        }
      });
    ++number;
  }
  for (Index i = 0; i < count; ++i)
  {
    if (groupOf(i) != none)
    {
      continue;
    }
    double strongest = 0.0;
    visitTies(matrix, i,
      [&](Index j, double value)
      {
        if (groupOf(j) != none && std::abs(value) > strongest)
        {
          strongest = std::abs(value);
          groupOf(i) = groupOf(j);
          signOf(i) = value > 0.0 ? -signOf(j) : signOf(j);
        }
      });
    if (groupOf(i) == none)
    {
      groupOf(i) = number++;
    }
  }
  return number;
}

} // namespace

SignedMultigrid& SignedMultigrid::compute(const Matrix& matrix)
{
  this->Levels.clear();
  this->Levels.push_back({ matrix, matrix.diagonal().cwiseInverse(), {}, {} });
  while (this->Levels.back().matrix.rows() > fewUnknowns)
  {
    Level& fine = this->Levels.back();
    const Index count = makeGroups(fine.matrix, fine.groups, fine.signs);
    if (count == fine.matrix.rows())
    {
      break;
    }
    std::vector<Eigen::Triplet<double, std::int64_t>> entries;
    entries.reserve(static_cast<std::size_t>(fine.matrix.nonZeros()));
    for (Index row = 0; row < fine.matrix.rows(); ++row)
    {
      const auto i = static_cast<std::size_t>(row);
      for (Matrix::InnerIterator entry(fine.matrix, row); entry; ++entry)
      {
        const auto j = static_cast<std::size_t>(entry.col());
        entries.emplace_back(fine.groups[i], fine.groups[j], fine.signs[i] * fine.signs[j] * entry.value());
      }
    }
    Matrix coarse(count, count);
    coarse.setFromTriplets(entries.begin(), entries.end());
    Vector inverse = coarse.diagonal().cwiseInverse();
    this->Levels.push_back({ std::move(coarse), std::move(inverse), {}, {} });
  }
  this->Levels.back().groups.clear();
  this->Coarsest.compute(Eigen::SparseMatrix<double>(this->Levels.back().matrix));
  return *this;
}

SignedMultigrid::Vector SignedMultigrid::cycle(std::size_t level, const Vector& residual) const
{
  const Level& own = this->Levels[level];
  if (level + 1 == this->Levels.size())
  {
    return this->Coarsest.solve(residual);
  }
  Vector x = damping * own.inverseDiagonal.cwiseProduct(residual);
  Vector left = residual - own.matrix * x;
  Vector coarse = Vector::Zero(this->Levels[level + 1].matrix.rows());
  for (std::size_t i = 0; i < own.groups.size(); ++i)
  {
    coarse[own.groups[i]] += own.signs[i] * left[static_cast<Index>(i)];
  }
  coarse = this->cycle(level + 1, coarse);
  for (std::size_t i = 0; i < own.groups.size(); ++i)
  {
    x[static_cast<Index>(i)] += overcorrection * own.signs[i] * coarse[own.groups[i]];
  }
  left = residual - own.matrix * x;
  x += damping * own.inverseDiagonal.cwiseProduct(left);
  return x;
}

} // namespace ink
