// SPDX-License-Identifier: BSD-3-Clause
#include "Curves/ChainSegments.h"

#include <gtest/gtest.h>

namespace
{

using Numbers = std::vector<std::uint32_t>;
using Offsets = std::vector<std::size_t>;
using Flags = std::vector<std::uint8_t>;

ink::Chains chain(const std::vector<ink::Segment>& segments, std::size_t nodes)
{
  return ink::chainSegments(segments, nodes);
}

} // namespace

TEST(ChainSegments, JoinsAnOpenChainWhicheverWayItsSegmentsRun)
{
  // 4 - 2 - 0 - 1 - 3; the first segment, from 0 to 1, says which way.
  const ink::Chains chains = chain({ { 0, 1 }, { 0, 2 }, { 3, 1 }, { 2, 4 } }, 5);
  EXPECT_EQ(chains.nodes, (Numbers{ 4, 2, 0, 1, 3 }));
  EXPECT_EQ(chains.segments, (Numbers{ 3, 1, 0, 2, 2 }));
  EXPECT_EQ(chains.polylines.offsets, (Offsets{ 0, 5 }));
  EXPECT_EQ(chains.polylines.closed, (Flags{ 0 }));
  EXPECT_EQ(chains.polylines.segmentCount(0), 4u);
}

TEST(ChainSegments, BeginsAClosedChainAtItsFirstSegment)
{
  const ink::Chains chains = chain({ { 5, 7 }, { 6, 7 }, { 6, 5 } }, 8);
  EXPECT_EQ(chains.nodes, (Numbers{ 5, 7, 6 }));
  EXPECT_EQ(chains.segments, (Numbers{ 0, 1, 2 }));
  EXPECT_EQ(chains.polylines.closed, (Flags{ 1 }));
  EXPECT_EQ(chains.polylines.segmentCount(0), 3u);
}

TEST(ChainSegments, EndsWhereThreeMeet)
{
  const ink::Chains chains = chain({ { 0, 1 }, { 0, 2 }, { 3, 0 } }, 4);
  EXPECT_EQ(chains.nodes, (Numbers{ 0, 1, 0, 2, 3, 0 }));
  EXPECT_EQ(chains.polylines.offsets, (Offsets{ 0, 2, 4, 6 }));
  EXPECT_EQ(chains.polylines.closed, (Flags{ 0, 0, 0 }));
}

TEST(ChainSegments, TakesALoopThroughACrossing)
{
  // A loop at node 0, at which another segment ends: it cannot be closed there.
  const ink::Chains chains = chain({ { 1, 2 }, { 0, 1 }, { 2, 0 }, { 0, 3 } }, 4);
  EXPECT_EQ(chains.nodes, (Numbers{ 0, 1, 2, 0, 0, 3 }));
  EXPECT_EQ(chains.polylines.closed, (Flags{ 0, 0 }));
}

TEST(ChainSegments, ClosesTwoSegmentsBetweenTheSameNodes)
{
  const ink::Chains chains = chain({ { 0, 1 }, { 0, 1 } }, 2);
  EXPECT_EQ(chains.nodes, (Numbers{ 0, 1 }));
  EXPECT_EQ(chains.polylines.closed, (Flags{ 1 }));
}

TEST(ChainSegments, LeavesOutSegmentsOfOneNode)
{
  EXPECT_EQ(chain({ { 3, 3 } }, 4).polylines.size(), 0u);
  const ink::Chains chains = chain({ { 0, 1 }, { 1, 1 }, { 1, 2 } }, 3);
  EXPECT_EQ(chains.nodes, (Numbers{ 0, 1, 2 }));
  EXPECT_EQ(chain({}, 0).polylines.size(), 0u);
}
