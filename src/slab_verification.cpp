// SPDX-License-Identifier: GPL-3.0-or-later
#include "slab_verification.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cgal_blend {

namespace {

constexpr double side_depth = 0.25;  // where Psi must have its sign, of the mean edge around

std::size_t number_distinct(std::vector<std::pair<std::size_t, std::size_t>>& items) {
  std::sort(items.begin(), items.end());
  return static_cast<std::size_t>(std::unique(items.begin(), items.end()) - items.begin());
}

class Side_check {
 public:
  Side_check(const Hermite_transition& psi, const Blend_mesh& mesh) : psi_(psi), mesh_(mesh) {}

  std::vector<Point_3> run() {
    for (const Face f : mesh_.faces()) {
      const Halfedge h = mesh_.halfedge(f);
      const Point_3 &a = mesh_.point(mesh_.source(h)), &b = mesh_.point(mesh_.target(h)),
                    &c = mesh_.point(mesh_.target(mesh_.next(h)));
      check(CGAL::centroid(a, b, c), normal(h), (length(h) + length(mesh_.next(h)) + length(mesh_.prev(h))) / 3);
    }
    for (const Edge e : mesh_.edges()) {
      if (mesh_.is_border(e)) continue;
      const Halfedge h = mesh_.halfedge(e), g = mesh_.opposite(h);
      const double around =
          length(h) + length(mesh_.next(h)) + length(mesh_.prev(h)) + length(mesh_.next(g)) + length(mesh_.prev(g));
      check(CGAL::midpoint(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h))), normal(h) + normal(g),
            around / 5);
    }
    return std::move(places_);
  }

 private:
  double length(Halfedge h) const {
    return std::sqrt(CGAL::squared_distance(mesh_.point(mesh_.source(h)), mesh_.point(mesh_.target(h))));
  }
  Vector_3 normal(Halfedge h) const {
    const Point_3& a = mesh_.point(mesh_.source(h));
    const Vector_3 n =
        CGAL::cross_product(mesh_.point(mesh_.target(h)) - a, mesh_.point(mesh_.target(mesh_.next(h))) - a);
    return n.squared_length() > 0 ? n / std::sqrt(n.squared_length()) : n;
  }
  void check(const Point_3& p, const Vector_3& n, double size) {
    const double squared = n.squared_length();
    if (squared > 0) {
      const Vector_3 step = side_depth * size / std::sqrt(squared) * n;
      if (psi_(p - step) < 0 && psi_(p + step) > 0) return;
    }
    places_.push_back(p);
  }

  const Hermite_transition& psi_;
  const Blend_mesh& mesh_;
  std::vector<Point_3> places_;
};

}  // namespace

std::vector<Point_3> doubtful_places(const Hermite_transition& psi, const Blend_mesh& mesh) {
  return Side_check(psi, mesh).run();
}

long euler_characteristic(const std::vector<std::array<std::size_t, 3>>& triangles) {
  std::vector<std::pair<std::size_t, std::size_t>> vertices, edges;
  for (const auto& t : triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      vertices.emplace_back(t[i], t[i]);
      edges.emplace_back(std::minmax(t[i], t[(i + 1) % 3]));
    }
  return static_cast<long>(number_distinct(vertices)) - static_cast<long>(number_distinct(edges)) +
         static_cast<long>(triangles.size());
}

}  // namespace cgal_blend
