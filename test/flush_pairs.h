// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TEST_FLUSH_PAIRS_H
#define CGAL_BLEND_TEST_FLUSH_PAIRS_H

#include "shapes.h"

#include <cgal_blend/fillet.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

// Pairs of bodies with faces in common planes, and the volumes of their booleans in closed form; turned and moved in
// doubles, so that the planes are common but for rounding.

namespace cgal_blend::test {

struct Flush_pair {
  Blend_mesh a, b;
  double volume_a = 0, volume_b = 0, overlap = 0;
  bool difference_touches_itself = false;  ///< along edges, so that it is not manifold
};

/// Volume of a boolean of the pair.
inline double volume_of(const Flush_pair& pair, Boolean_operation operation) {
  switch (operation) {
    case Boolean_operation::union_: return pair.volume_a + pair.volume_b - pair.overlap;
    case Boolean_operation::intersection: return pair.overlap;
    case Boolean_operation::difference: return pair.volume_a - pair.overlap;
  }
  return 0;
}

/// Draws numbers; the same on every platform.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : engine_(seed) {}
  /// An integer in [low, high].
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint32_t>(high - low + 1));
  }
  /// A number in [0, 1).
  double real() { return engine_() / 4294967296.0; }
  bool coin() { return engine_() % 2 == 0; }

 private:
  std::mt19937 engine_;
};

namespace detail {

using Interval = std::pair<double, double>;
using Extent = std::array<Interval, 3>;
using Outline = std::vector<std::pair<double, double>>;

inline double length(const Interval& i) { return std::max(0.0, i.second - i.first); }
inline Interval common(const Interval& i, const Interval& j) {
  return {std::max(i.first, j.first), std::min(i.second, j.second)};
}
inline double volume(const Extent& e) { return length(e[0]) * length(e[1]) * length(e[2]); }
inline Blend_mesh box_of(const Extent& e, int grid = 1) {
  const Point_3 low(e[0].first, e[1].first, e[2].first), high(e[0].second, e[1].second, e[2].second);
  return grid > 1 ? grid_box(low, high, grid) : box(low, high);
}

inline Flush_pair boxes(const Extent& a, const Extent& b, int grid_a = 1, int grid_b = 1) {
  const Extent both{common(a[0], b[0]), common(a[1], b[1]), common(a[2], b[2])};
  return {box_of(a, grid_a), box_of(b, grid_b), volume(a), volume(b), volume(both)};
}

/// Swaps the coordinates round, so that no direction is special.
inline Extent cycled(const Extent& e, int by) { return {e[by % 3], e[(by + 1) % 3], e[(by + 2) % 3]}; }

inline Blend_mesh united(const Blend_mesh& a, const Blend_mesh& b) {
  Blend_mesh out;
  if (!unchecked::corefine_and_fillet(a, b, Boolean_operation::union_, out, {}).ok())
    throw std::logic_error("the parts of a test shape cannot be united");
  return out;
}

inline double area(const Outline& outline) {
  double sum = 0;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++)
    sum += outline[j].first * outline[i].second - outline[i].first * outline[j].second;
  return sum / 2;
}

inline Outline polygon(double radius, int n, double phase = 0) {
  Outline outline;
  for (int i = 0; i < n; ++i)
    outline.emplace_back(radius * std::cos(2 * pi * (i + phase) / n), radius * std::sin(2 * pi * (i + phase) / n));
  return outline;
}

/// Pyramid or truncated pyramid over an outline: every point is moved towards the axis by the scale at the top.
inline Blend_mesh frustum(const Outline& outline, double z0, double z1, double top) {
  Blend_mesh mesh = prism(outline, z0, z1);
  for (std::size_t i = 0; i < outline.size(); ++i)
    mesh.point(Vertex(outline.size() + i)) = {top * outline[i].first, top * outline[i].second, z1};
  return mesh;
}

inline Blend_mesh pyramid(const Outline& outline, double z0, double z1) {
  const std::size_t n = outline.size();
  std::vector<Point_3> points;
  for (const auto& [x, y] : outline) points.emplace_back(x, y, z0);
  points.emplace_back(0, 0, z1);
  std::vector<Corner_indices> triangles;
  for (std::size_t i = 1; i + 1 < n; ++i) triangles.push_back({0, i + 1, i});
  for (std::size_t i = 0; i < n; ++i) triangles.push_back({i, (i + 1) % n, n});
  return mesh_of(points, triangles);
}

}  // namespace detail

/// A family of pairs; each call of `draw` gives another one.
struct Flush_family {
  const char* name;
  Flush_pair (*draw)(Dice&);
};

inline const std::vector<Flush_family>& flush_families() {
  using namespace detail;
  static const std::vector<Flush_family> families{
      {"cubes, whole face",
       [](Dice& dice) {
         const int by = dice.integer(0, 2);
         return boxes(cycled({{{0, 1}, {0, 1}, {0, 1}}}, by), cycled({{{0, 1}, {0, 1}, {1, 2}}}, by));
       }},
      {"cubes, part of a face",
       [](Dice& dice) {
         const int by = dice.integer(0, 2), x = dice.integer(0, 5), y = dice.integer(0, 5);
         const Extent small{
             {{x / 8.0, (x + dice.integer(1, 8 - x)) / 8.0}, {y / 8.0, (y + dice.integer(1, 8 - y)) / 8.0}, {1, 1.5}}};
         return boxes(cycled({{{0, 1}, {0, 1}, {0, 1}}}, by), cycled(small, by));
       }},
      {"cubes, offset faces",
       [](Dice& dice) {
         const int by = dice.integer(0, 2);
         const double x = dice.integer(-7, 7) / 8.0, y = dice.integer(-7, 7) / 8.0, z = dice.coin() ? 1 : 0;
         return boxes(cycled({{{0, 1}, {0, 1}, {0, 1}}}, by), cycled({{{x, x + 1}, {y, y + 1}, {z, z + 1}}}, by));
       }},
      {"overlapping boxes with coplanar sides",
       [](Dice& dice) {
         Extent b;
         for (Interval& side : b) {
           const int low = dice.integer(-4, 3);
           side = {low / 4.0, (low + dice.integer(1 - std::min(low, 0), 8)) / 4.0};
         }
         b[dice.integer(0, 2)].first = 0;
         b[dice.integer(0, 2)].second = 1;
         for (Interval& side : b)
           if (!(side.first < side.second)) side.second = side.first + 1;
         return boxes({{{0, 1}, {0, 1}, {0, 1}}}, b);
       }},
      {"flush pocket",
       [](Dice& dice) {
         const int x = dice.integer(1, 5), y = dice.integer(0, 5);
         return boxes({{{0, 1}, {0, 1}, {0, 0.5}}},
                      {{{x / 8.0, (x + 2) / 8.0}, {y / 8.0, (y + 2) / 8.0}, {dice.coin() ? 0.25 : 0, 0.5}}});
       }},
      {"stacked boxes, in the middle",
       [](Dice& dice) {
         const double inset = dice.integer(1, 7) / 16.0;
         return boxes({{{0, 1}, {0, 1}, {0, 1}}},
                      {{{inset, 1 - inset}, {inset, 1 - inset}, {1, 1 + dice.integer(1, 4) / 4.0}}});
       }},
      {"stacked boxes of many faces",
       [](Dice& dice) {
         const double x = dice.integer(0, 4) / 12.0, y = dice.integer(0, 4) / 12.0;
         const int grid_a = dice.integer(1, 6), grid_b = dice.integer(1, 6);
         return boxes({{{0, 1}, {0, 1}, {0, 1}}}, {{{x, x + 0.5}, {y, y + 0.5}, {dice.coin() ? 1 : 0.5, 1.5}}}, grid_a,
                      grid_b);
       }},
      {"coaxial prisms, end to end",
       [](Dice& dice) {
         const Outline outline = polygon(1, dice.integer(3, 24), dice.real());
         const double overlap = dice.coin() ? 0 : 0.25;
         return Flush_pair{prism(outline, 0, 1), prism(outline, 1 - overlap, 2), area(outline),
                           (1 + overlap) * area(outline), overlap * area(outline)};
       }},
      {"coaxial prisms, one in the other",
       [](Dice& dice) {
         const int n = dice.integer(3, 16);
         const Outline outer = polygon(1, n), inner = polygon(dice.integer(1, 7) / 8.0, n);
         const double bottom = dice.coin() ? 0 : 0.5;
         return Flush_pair{prism(outer, 0, 1), prism(inner, bottom, 1), area(outer), (1 - bottom) * area(inner),
                           (1 - bottom) * area(inner)};
       }},
      {"coaxial prisms, corners on sides",
       [](Dice& dice) {
         const int n = dice.integer(3, 12);
         const Outline outer = polygon(1, n), inner = polygon(std::cos(pi / n), n, 0.5);
         const double bottom = dice.coin() ? 0 : 1;
         return Flush_pair{prism(outer, 0, 1), prism(inner, bottom, bottom + 1), area(outer),
                           area(inner),        bottom == 0 ? area(inner) : 0,    bottom == 0};
       }},
      {"coaxial cylinders",
       [](Dice& dice) {
         const int n = dice.integer(8, 24);  // CGAL takes seconds for fans of 60 faces on each other
         const double r = dice.coin() ? 1 : 0.5, z = dice.integer(0, 3) / 4.0 + 0.25, circle = area(polygon(1, n));
         return Flush_pair{cylinder(1, n, 0, 1), cylinder(r, n, z, z + 1), circle, r * r * circle,
                           (1 - z) * r * r * circle};
       }},
      {"L-shape and a box in its notch",
       [](Dice& dice) {
         const double t = dice.integer(1, 3) / 4.0, z = dice.coin() ? 0 : 0.5;
         const Extent notch{{{t, 1}, {t, dice.coin() ? 1 : 1.25}, {z, z + 1}}};
         return Flush_pair{l_bracket(1, t, 1), box_of(notch), 2 * t - t * t, volume(notch), 0};
       }},
      {"two L-shapes",
       [](Dice& dice) {
         const double t = 0.5, z = dice.integer(0, 4) / 4.0, area = 2 * t - t * t;
         return Flush_pair{l_bracket(1, t, 1), l_bracket(1, t, z + 1 - z / 2), area, area * (1 + z / 2), area};
       }},
      {"boss on a plate",
       [](Dice& dice) {
         const Outline outline = polygon(dice.integer(1, 6) / 8.0, dice.integer(3, 32), dice.coin() ? 0 : dice.real());
         return Flush_pair{plate(1, 0.25), prism(outline, 0, 1), 1, area(outline), 0};
       }},
      {"hole through a plate",
       [](Dice& dice) {
         const double radius = dice.integer(1, 6) / 8.0;
         const int n = dice.integer(3, 32);
         const double top = dice.coin() ? 0 : 0.5, base = area(polygon(radius, n));
         return Flush_pair{plate(1, 0.25), cylinder(radius, n, -0.25, top), 1, (top + 0.25) * base, 0.25 * base};
       }},
      {"block of two boxes and a third one",
       [](Dice& dice) {
         const double step = dice.integer(1, 3) / 4.0;
         const Extent first{{{0, 1}, {0, 1}, {0, 1}}}, second{{{0, step}, {0, 1}, {1, 2}}};
         const Extent third{{{step, 1.25}, {dice.coin() ? 0 : 0.25, 1}, {1, dice.coin() ? 2 : 1.5}}};
         return Flush_pair{united(box_of(first), box_of(second)), box_of(third), 1 + step, volume(third), 0};
       }},
      {"plate with a boss, and a second boss beside it",
       [](Dice& dice) {
         const Outline outline = polygon(0.2, dice.integer(3, 12));
         const Extent second{{{0.25, 0.75}, {-0.25, dice.coin() ? 0.25 : 1}, {dice.coin() ? 0 : -0.25, 0.5}}};
         const double overlap = -second[2].first * volume(second) / length(second[2]);
         return Flush_pair{united(plate(1, 0.25), prism(outline, 0, 0.5)), box_of(second), 1 + area(outline) / 2,
                           volume(second), overlap};
       }},
      {"pyramids with a common side or base",
       [](Dice& dice) {
         const Outline outline = polygon(1, dice.integer(3, 8));
         if (dice.coin()) {  // the point of a pyramid set on its stump
           const double whole = area(outline) / 3, point = whole / 8;
           return Flush_pair{frustum(outline, 0, 0.5, 0.5),
                             pyramid(polygon(0.5, static_cast<int>(outline.size())), 0.5, 1), whole - point, point, 0};
         }
         return Flush_pair{pyramid(outline, 0, 1), prism(outline, -1, 0), area(outline) / 3, area(outline), 0};
       }},
      {"the same body, cut by a coplanar one",
       [](Dice& dice) {
         const Outline outline = polygon(1, dice.integer(3, 12));
         const double half = area(outline) / 2;
         return Flush_pair{prism(outline, 0, 1), prism(outline, 0, 0.5), 2 * half, half, half};
       }},
  };
  return families;
}

/// A random rotation and translation, the same for both bodies, applied in doubles.
inline Flush_pair moved_pair(Flush_pair pair, Dice& dice, double distance = 3) {
  const auto vector = [&] {
    const double x = 2 * dice.real() - 1, y = 2 * dice.real() - 1, z = 2 * dice.real() - 1;
    return Vector_3(x, y, z);
  };
  const Vector_3 axis = vector(), by = vector();
  const Placement motion = placement(axis, 2 * pi * dice.real(), distance * by);
  pair.a = transformed(pair.a, motion);
  pair.b = transformed(pair.b, motion);
  return pair;
}

}  // namespace cgal_blend::test

#endif
