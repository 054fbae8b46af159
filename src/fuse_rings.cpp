// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuse_frame.h"

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Polygon_2_algorithms.h>
#include <CGAL/box_intersection_d.h>

#include <optional>
#include <utility>
#include <vector>

namespace cgal_blend {

namespace {

using Segment_2 = Kernel::Segment_2;
using Step = std::pair<std::size_t, std::size_t>;  // ring, first vertex
using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, Step>;

Segment_2 segment(const std::vector<Ring>& rings, const Step& s) {
  const Ring& ring = rings[s.first];
  return {ring[s.second], ring[(s.second + 1) % ring.size()]};
}

bool follows(const std::vector<Ring>& rings, const Step& a, const Step& b) {
  return a.first == b.first && b.second == (a.second + 1) % rings[a.first].size();
}

/// True if two edges meet where they should not; edges in a row only if they fold back onto each other.
bool meet(const std::vector<Ring>& rings, const Step& a, const Step& b) {
  const Segment_2 s = segment(rings, a), t = segment(rings, b);
  if (follows(rings, a, b)) return t.has_on(s.source()) || s.has_on(t.target());
  if (follows(rings, b, a)) return s.has_on(t.source()) || t.has_on(s.target());
  return CGAL::do_intersect(s, t);
}

std::optional<Step> first_meeting(const std::vector<Ring>& rings) {
  std::vector<Box> boxes;
  for (std::size_t r = 0; r < rings.size(); ++r)
    for (std::size_t i = 0; i < rings[r].size(); ++i) boxes.emplace_back(segment(rings, {r, i}).bbox(), Step{r, i});
  std::optional<Step> found;
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    if (meet(rings, a.info(), b.info())) {
      const Step least = std::min(a.info(), b.info());
      if (!found || least < *found) found = least;
    }
  });
  return found;
}

/// How many other rings surround a ring.
std::size_t depth(const std::vector<Ring>& rings, std::size_t r) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < rings.size(); ++k)
    if (k != r &&
        CGAL::bounded_side_2(rings[k].begin(), rings[k].end(), rings[r].front(), Kernel()) == CGAL::ON_BOUNDED_SIDE)
      ++count;
  return count;
}

}  // namespace

Diagnosis check_rings(const Fuse_side& side, const Opening_sections& sections, bool upper) {
  const std::vector<Ring>& rings = sections.rings;
  if (const auto step = first_meeting(rings))
    return {Status::openings_overlap, "", side.points[step->first][step->second], {}};
  for (std::size_t r = 0; r < rings.size(); ++r) {
    // The normal of the upper plane points down the frame.
    const bool outer =
        (CGAL::orientation_2(rings[r].begin(), rings[r].end(), Kernel()) == CGAL::COUNTERCLOCKWISE) != upper;
    if (outer == (depth(rings, r) % 2 == 0)) continue;
    return {
        Status::sides_interpenetrate, "an opening lies inside another one that is filled", side.points[r].front(), {}};
  }
  return {};
}

}  // namespace cgal_blend
