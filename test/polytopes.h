// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TEST_POLYTOPES_H
#define CGAL_BLEND_TEST_POLYTOPES_H

#include "shapes.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <random>
#include <set>
#include <utility>
#include <vector>

// Convex polytopes as meshes, and what is left of them when a ball has rounded their edges: closed forms (Steiner's
// formula for the inner parallel body), integrals over the section of one round, and membership of points.

namespace cgal_blend::test {

using Vec3 = Eigen::Vector3d;

inline Vec3 vec3(const Point_3& p) { return {p.x(), p.y(), p.z()}; }

/// Half-space of the points with normal . x <= height; the normal has length 1.
struct Half_space {
  Vec3 normal;
  double height = 0;

  [[nodiscard]] double above(const Vec3& p) const { return normal.dot(p) - height; }
};

inline Half_space half_space(const Vec3& normal, const Vec3& through) {
  return {normal.normalized(), normal.normalized().dot(through)};
}

/// Edge of a polytope: its vertices, and the faces that meet there.
struct Polytope_edge {
  std::size_t a, b, f, g;
};

/// Bounded intersection of half-spaces, found by trying all triples of planes.
class Polytope {
 public:
  explicit Polytope(std::vector<Half_space> sides) : sides_(std::move(sides)), faces_(sides_.size()) {
    double size = 0;
    for (const Half_space& s : sides_) size = std::max(size, std::abs(s.height));
    const double same = 1e-9 * size;
    for (std::size_t i = 0; i < sides_.size(); ++i)
      for (std::size_t j = i + 1; j < sides_.size(); ++j)
        for (std::size_t k = j + 1; k < sides_.size(); ++k) {
          Eigen::Matrix3d m;
          m << sides_[i].normal.transpose(), sides_[j].normal.transpose(), sides_[k].normal.transpose();
          if (std::abs(m.determinant()) < 1e-9) continue;
          const Vec3 p = m.inverse() * Vec3(sides_[i].height, sides_[j].height, sides_[k].height);
          const bool inside =
              std::all_of(sides_.begin(), sides_.end(), [&](const Half_space& s) { return s.above(p) < same; });
          const bool known =
              std::any_of(points_.begin(), points_.end(), [&](const Vec3& q) { return (p - q).norm() < 100 * same; });
          if (inside && !known) points_.push_back(p);
        }
    for (std::size_t i = 0; i < sides_.size(); ++i) sort_face(i, 100 * same);
    for (std::size_t f = 0; f < faces_.size(); ++f)
      for (std::size_t k = 0; k < faces_[f].size(); ++k) {
        const std::size_t a = faces_[f][k], b = faces_[f][(k + 1) % faces_[f].size()];
        for (std::size_t g = f + 1; g < faces_.size(); ++g)
          if (has(g, a) && has(g, b)) edges_.push_back({a, b, f, g});
      }
  }

  [[nodiscard]] const std::vector<Half_space>& sides() const { return sides_; }
  [[nodiscard]] const std::vector<Vec3>& points() const { return points_; }
  [[nodiscard]] const std::vector<Polytope_edge>& edges() const { return edges_; }
  [[nodiscard]] bool has(std::size_t face, std::size_t vertex) const {
    return std::find(faces_[face].begin(), faces_[face].end(), vertex) != faces_[face].end();
  }

  [[nodiscard]] double length(const Polytope_edge& e) const { return (points_[e.b] - points_[e.a]).norm(); }
  /// Angle between the outward normals.
  [[nodiscard]] double turn(const Polytope_edge& e) const {
    return std::acos(std::clamp(sides_[e.f].normal.dot(sides_[e.g].normal), -1.0, 1.0));
  }

  [[nodiscard]] double face_area(std::size_t f) const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < faces_[f].size(); ++k)
      sum += (points_[faces_[f][k]] - points_[faces_[f][0]]).cross(points_[faces_[f][k + 1]] - points_[faces_[f][0]]);
    return sum.norm() / 2;
  }
  [[nodiscard]] double area() const {
    double sum = 0;
    for (std::size_t f = 0; f < faces_.size(); ++f) sum += face_area(f);
    return sum;
  }
  [[nodiscard]] double volume() const {
    double sum = 0;
    for (std::size_t f = 0; f < faces_.size(); ++f) sum += face_area(f) * sides_[f].height / 3;
    return sum;
  }

  /// All points that are at least r inside.
  [[nodiscard]] Polytope inner_parallel(double r) const {
    std::vector<Half_space> moved = sides_;
    for (Half_space& s : moved) s.height -= r;
    return Polytope(std::move(moved));
  }

  /// Faces as fans of triangles.
  [[nodiscard]] Blend_mesh mesh() const {
    std::vector<Point_3> points;
    for (const Vec3& p : points_) points.emplace_back(p.x(), p.y(), p.z());
    std::vector<Corner_indices> triangles;
    for (const auto& face : faces_)
      for (std::size_t k = 1; k + 1 < face.size(); ++k) triangles.push_back({face[0], face[k], face[k + 1]});
    return mesh_of(points, triangles);
  }

 private:
  // Vertices on the plane, counterclockwise seen from outside.
  void sort_face(std::size_t f, double same) {
    const Half_space& side = sides_[f];
    Vec3 middle = Vec3::Zero();
    for (std::size_t v = 0; v < points_.size(); ++v)
      if (std::abs(side.above(points_[v])) < same) faces_[f].push_back(v);
    if (faces_[f].size() < 3) {
      faces_[f].clear();
      return;
    }
    for (const std::size_t v : faces_[f]) middle += points_[v] / static_cast<double>(faces_[f].size());
    const Vec3 x = (points_[faces_[f][0]] - middle).normalized(), y = side.normal.cross(x);
    const auto angle = [&](std::size_t v) {
      return std::atan2(y.dot(points_[v] - middle), x.dot(points_[v] - middle));
    };
    std::sort(faces_[f].begin(), faces_[f].end(), [&](std::size_t a, std::size_t b) { return angle(a) < angle(b); });
  }

  std::vector<Half_space> sides_;
  std::vector<Vec3> points_;
  std::vector<std::vector<std::size_t>> faces_;
  std::vector<Polytope_edge> edges_;
};

/// Volume and area of a convex polytope all of whose edges and corners are rounded by a ball inside: of the inner
/// parallel body moved outward again (Steiner).
inline double rounded_volume(const Polytope& body, double r) {
  const Polytope core = body.inner_parallel(r);
  double sum = core.volume() + r * core.area() + 4 * pi * r * r * r / 3;
  for (const Polytope_edge& e : core.edges()) sum += r * r / 2 * core.length(e) * core.turn(e);
  return sum;
}

inline double rounded_area(const Polytope& body, double r) {
  const Polytope core = body.inner_parallel(r);
  double sum = core.area() + 4 * pi * r * r;
  for (const Polytope_edge& e : core.edges()) sum += r * core.length(e) * core.turn(e);
  return sum;
}

/// The round of an edge, continued along its line as far as anyone asks.
struct Edge_round {
  Half_space f, g;
  double r;

  [[nodiscard]] Vec3 direction() const { return f.normal.cross(g.normal).normalized(); }
  /// A point of the ball's axis.
  [[nodiscard]] Vec3 center() const {
    Eigen::Matrix3d m;
    m << f.normal.transpose(), g.normal.transpose(), direction().transpose();
    return m.inverse() * Vec3(f.height - r, g.height - r, 0);
  }
  /// How far a point between the contacts is off the axis; nothing for points elsewhere.
  [[nodiscard]] std::optional<double> off_axis(const Vec3& p) const {
    const Vec3 u = direction();
    Vec3 d = p - center();
    d -= d.dot(u) * u;
    const Vec3 x = f.normal, y = g.normal;
    const double c = x.dot(y), a = (d.dot(x) - c * d.dot(y)) / (1 - c * c), b = (d.dot(y) - c * d.dot(x)) / (1 - c * c);
    if (a < 0 || b < 0) return std::nullopt;
    return d.norm();
  }
};

/// Volume that the round of an edge takes from a convex polytope: lengths across it, summed up over the round's section.
inline double removed_by_round(const Polytope& body, const Edge_round& round, int steps = 200) {
  const Vec3 u = round.direction(), center = round.center();
  const double half = std::acos(round.f.normal.dot(round.g.normal)) / 2;
  double sum = 0;
  for (const auto& [from, to] :
       {std::pair(round.f.normal, round.g.normal), std::pair(round.g.normal, round.f.normal)}) {
    const Vec3 across = (to - to.dot(from) * from).normalized();
    for (int i = 0; i < steps; ++i) {
      const double angle = (i + 0.5) * half / steps, outer = round.r / std::cos(angle);
      for (int j = 0; j < steps; ++j) {
        const double rho = round.r + (j + 0.5) * (outer - round.r) / steps;
        const Vec3 p = center + rho * (std::cos(angle) * from + std::sin(angle) * across);
        double low = -1e300, high = 1e300;
        for (const Half_space& s : body.sides()) {
          const double rise = s.normal.dot(u);
          if (std::abs(rise) < 1e-9) continue;  // along the edge
          (rise > 0 ? high : low) = rise > 0 ? std::min(high, -s.above(p) / rise) : std::max(low, -s.above(p) / rise);
        }
        if (high > low) sum += (high - low) * rho * (half / steps) * ((outer - round.r) / steps);
      }
    }
  }
  return sum;
}

// Polytopes.

inline Polytope polytope_of_box(const Vec3& low, const Vec3& high) {
  std::vector<Half_space> sides;
  for (int k = 0; k < 3; ++k)
    for (const double sign : {-1.0, 1.0}) sides.push_back({sign * Vec3::Unit(k), sign < 0 ? -low[k] : high[k]});
  return Polytope(sides);
}

/// The convex hull, by trying all triples of points.
inline Polytope hull_of(const std::vector<Vec3>& points) {
  std::vector<Half_space> sides;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j)
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        const Vec3 n = (points[j] - points[i]).cross(points[k] - points[i]);
        if (n.norm() < 1e-12) continue;
        for (const double sign : {-1.0, 1.0}) {
          const Half_space side = half_space(sign * n, points[i]);
          const bool bounds =
              std::all_of(points.begin(), points.end(), [&](const Vec3& p) { return side.above(p) < 1e-9; });
          const bool known = std::any_of(sides.begin(), sides.end(),
                                         [&](const Half_space& s) { return (s.normal - side.normal).norm() < 1e-7; });
          if (bounds && !known) sides.push_back(side);
        }
      }
  return Polytope(sides);
}

/// Vertices of a regular solid with so many faces.
inline std::vector<Vec3> regular_solid(int faces) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  std::vector<Vec3> p;
  const auto all_signs = [&](double x, double y, double z) {
    for (int k = 0; k < 8; ++k) {
      const Vec3 v(k & 1 ? -x : x, k & 2 ? -y : y, k & 4 ? -z : z);
      if (std::none_of(p.begin(), p.end(), [&](const Vec3& q) { return (v - q).norm() < 1e-9; })) p.push_back(v);
    }
  };
  switch (faces) {
    case 4: p = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}; break;
    case 6: all_signs(1, 1, 1); break;
    case 8: all_signs(1, 0, 0), all_signs(0, 1, 0), all_signs(0, 0, 1); break;
    case 12: all_signs(1, 1, 1), all_signs(0, 1 / g, g), all_signs(1 / g, g, 0), all_signs(g, 0, 1 / g); break;
    case 20: all_signs(0, 1, g), all_signs(1, g, 0), all_signs(g, 0, 1); break;
    default: break;
  }
  return p;
}

/// Pyramid over a square of side 2 a at z = 0.
inline Polytope pyramid(double a, double height) {
  return hull_of({{a, a, 0}, {-a, a, 0}, {-a, -a, 0}, {a, -a, 0}, {0, 0, height}});
}

/// Uniform on the unit sphere, the same for the same engine on every system.
inline Vec3 random_direction(std::mt19937& random) {
  const auto uniform = [&] { return random() / 4294967296.0; };
  const double z = 2 * uniform() - 1, angle = 2 * pi * uniform();
  return {std::sqrt(1 - z * z) * std::cos(angle), std::sqrt(1 - z * z) * std::sin(angle), z};
}

/// The hull of so many points at random on the unit sphere.
inline Polytope random_hull(unsigned points, std::mt19937& random) {
  std::vector<Vec3> on_sphere;
  for (unsigned k = 0; k < points; ++k) on_sphere.push_back(random_direction(random));
  return hull_of(on_sphere);
}

// Prisms over any simple outline.

/// Right prism over a simple polygon, counterclockwise, whose sides are cut at all the heights, in rising order. The caps
/// have no further vertices.
inline Blend_mesh tower(const std::vector<std::pair<double, double>>& outline, const std::vector<double>& heights) {
  const std::size_t n = outline.size(), top = n * (heights.size() - 1);
  std::vector<Point_3> points;
  for (const double z : heights)
    for (const auto& [x, y] : outline) points.emplace_back(x, y, z);
  std::vector<Corner_indices> triangles;
  const auto turn = [&](std::size_t a, std::size_t b, std::size_t c) {
    const auto& [ax, ay] = outline[a];
    const auto& [bx, by] = outline[b];
    const auto& [cx, cy] = outline[c];
    return (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
  };
  std::vector<std::size_t> rest(n);
  for (std::size_t i = 0; i < n; ++i) rest[i] = i;
  while (rest.size() > 2)
    for (std::size_t k = 0;; ++k) {  // an ear
      if (k == rest.size()) throw std::logic_error("an outline of a test shape is not simple");
      const std::size_t a = rest[(k + rest.size() - 1) % rest.size()], b = rest[k], c = rest[(k + 1) % rest.size()];
      if (turn(a, b, c) <= 0) continue;
      const bool blocked = std::any_of(rest.begin(), rest.end(), [&](std::size_t p) {
        return p != a && p != b && p != c && turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
      });
      if (blocked) continue;
      triangles.push_back({c, b, a});
      triangles.push_back({top + a, top + b, top + c});
      rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(k));
      break;
    }
  for (std::size_t level = 0; level + 1 < heights.size(); ++level)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = level * n + i, b = level * n + (i + 1) % n;
      triangles.push_back({a, b, b + n});
      triangles.push_back({a, b + n, a + n});
    }
  return mesh_of(points, triangles);
}

}  // namespace cgal_blend::test

#endif
