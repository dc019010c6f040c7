// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/Streamlines/ConnectionMultigrid.h"

#include <algorithm>
#include <cmath>

namespace ink
{

namespace
{

using Matrix = ConnectionMultigrid::Matrix;
using Index = Eigen::Index;
using Scalar = ConnectionMultigrid::Scalar;

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
    if (entry.col() != row && entry.value() != Scalar(0.0))
    {
      visit(entry.col(), entry.value());
    }
  }
}

/// Groups of unknowns with their strong neighbors; what is left joins the group that it is tied to most.
/// @return how many
Index makeGroups(const Matrix& matrix, std::vector<Index>& groups, std::vector<Scalar>& turns)
{
  const Index count = matrix.rows();
  groups.assign(static_cast<std::size_t>(count), none);
  turns.assign(static_cast<std::size_t>(count), 1.0);
  const auto groupOf = [&](Index i) -> Index& { return groups[static_cast<std::size_t>(i)]; };
  const auto turnOf = [&](Index i) -> Scalar& { return turns[static_cast<std::size_t>(i)]; };
  // From an unknown to the one that it is tied to by an entry of its row.
  const auto turnTo = [](const Scalar& value) { return -std::conj(value) / std::abs(value); };
  Index number = 0;
  for (Index i = 0; i < count; ++i)
  {
    double strongest = 0.0;
    bool isFree = groupOf(i) == none;
    bool isAlone = true;
    visitTies(matrix, i,
      [&](Index j, const Scalar& value)
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
      [&](Index j, const Scalar& value)
      {
        if (!isAlone && std::abs(value) >= strong * strongest)
        {
          groupOf(j) = number;
          turnOf(j) = turnTo(value);
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
      [&](Index j, const Scalar& value)
      {
        if (groupOf(j) != none && std::abs(value) > strongest)
        {
          strongest = std::abs(value);
          groupOf(i) = groupOf(j);
          turnOf(i) = turnOf(j) * std::conj(turnTo(value));
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

ConnectionMultigrid& ConnectionMultigrid::compute(const Matrix& matrix)
{
  this->Levels.clear();
  const auto inverse = [](const Matrix& of) -> Eigen::VectorXd
  { return of.diagonal().real().cwiseInverse(); };
  this->Levels.push_back({ matrix, inverse(matrix), {}, {} });
  while (this->Levels.back().matrix.rows() > fewUnknowns)
  {
    Level& fine = this->Levels.back();
    const Index count = makeGroups(fine.matrix, fine.groups, fine.turns);
    if (count == fine.matrix.rows())
    {
      break;
    }
    std::vector<Eigen::Triplet<Scalar, std::int64_t>> entries;
    entries.reserve(static_cast<std::size_t>(fine.matrix.nonZeros()));
    for (Index row = 0; row < fine.matrix.rows(); ++row)
    {
      const auto i = static_cast<std::size_t>(row);
      for (Matrix::InnerIterator entry(fine.matrix, row); entry; ++entry)
      {
        const auto j = static_cast<std::size_t>(entry.col());
        entries.emplace_back(
          fine.groups[i], fine.groups[j], std::conj(fine.turns[i]) * entry.value() * fine.turns[j]);
      }
    }
    Matrix coarse(count, count);
    coarse.setFromTriplets(entries.begin(), entries.end());
    this->Levels.push_back({ coarse, inverse(coarse), {}, {} });
  }
  this->Levels.back().groups.clear();
  this->Coarsest.compute(Eigen::SparseMatrix<Scalar>(this->Levels.back().matrix));
  return *this;
}

ConnectionMultigrid::Vector ConnectionMultigrid::cycle(std::size_t level, const Vector& residual) const
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
    coarse[own.groups[i]] += std::conj(own.turns[i]) * left[static_cast<Index>(i)];
  }
  coarse = this->cycle(level + 1, coarse);
  for (std::size_t i = 0; i < own.groups.size(); ++i)
  {
    x[static_cast<Index>(i)] += overcorrection * own.turns[i] * coarse[own.groups[i]];
  }
  left = residual - own.matrix * x;
  x += damping * own.inverseDiagonal.cwiseProduct(left);
  return x;
}

} // namespace ink
