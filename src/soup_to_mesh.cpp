// SPDX-License-Identifier: GPL-3.0-or-later
#include "soup_to_mesh.h"

#include "fill_loop.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace cgal_blend {

namespace {

using Directed = std::pair<std::size_t, std::size_t>;

/// Triangles at each edge, by its ends in ascending order.
std::map<Directed, std::vector<std::size_t>> triangles_at_edges(const Triangle_soup& soup) {
  std::map<Directed, std::vector<std::size_t>> at;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const std::size_t a = soup.triangles[t][i], b = soup.triangles[t][(i + 1) % 3];
      at[std::minmax(a, b)].push_back(t);
    }
  return at;
}

bool has_directed(const std::array<std::size_t, 3>& t, std::size_t a, std::size_t b) {
  return (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
}

}  // namespace

bool orient(Triangle_soup& soup) {
  const auto at = triangles_at_edges(soup);
  std::vector<char> done(soup.triangles.size(), false);
  std::vector<std::size_t> stack;
  for (std::size_t first = 0; first < soup.triangles.size(); ++first) {
    if (done[first]) continue;
    done[first] = true;
    stack.push_back(first);
    while (!stack.empty()) {
      const std::size_t t = stack.back();
      stack.pop_back();
      for (int i = 0; i < 3; ++i) {
        const std::size_t a = soup.triangles[t][i], b = soup.triangles[t][(i + 1) % 3];
        const auto& beside = at.at(std::minmax(a, b));
        if (beside.size() > 2) return false;
        for (const std::size_t other : beside) {
          if (other == t) continue;
          const bool agrees = has_directed(soup.triangles[other], b, a);
          if (done[other] && !agrees) return false;
          if (done[other]) continue;
          if (!agrees) std::swap(soup.triangles[other][1], soup.triangles[other][2]);
          done[other] = true;
          stack.push_back(other);
        }
      }
    }
  }
  return true;
}

bool fill(const std::vector<std::size_t>& rim, int part, Triangle_soup& soup) {
  Blend_mesh corners;
  std::vector<Vertex> loop;
  for (const std::size_t v : rim) loop.push_back(corners.add_vertex(soup.points[v]));
  Vec normal = Vec::Zero();
  double extent = 0;
  const Vec origin = to_vec(soup.points[rim[0]]);
  for (std::size_t i = 1; i + 1 < rim.size(); ++i) {
    const Vec a = to_vec(soup.points[rim[i]]) - origin, b = to_vec(soup.points[rim[i + 1]]) - origin;
    normal += a.cross(b);
    extent = std::max(extent, a.norm());
  }
  normal.normalize();
  for (const std::size_t v : rim)
    if (std::abs(normal.dot(to_vec(soup.points[v]) - origin)) > planarity * extent) return false;
  const auto triangles = fill_loop(corners, normal, loop);
  if (!triangles) return false;
  for (const auto& t : *triangles) {
    soup.triangles.push_back({rim[t[0]], rim[t[1]], rim[t[2]]});
    soup.parts.push_back(part);
  }
  return true;
}

void thicken(double thickness, int side_part, Triangle_soup& soup) {
  const std::size_t points = soup.points.size(), triangles = soup.triangles.size();
  std::vector<Vector_3> normals(points, Vector_3(0, 0, 0));
  for (const auto& t : soup.triangles)
    for (int i = 0; i < 3; ++i) {
      const Point_3 &p = soup.points[t[i]], &q = soup.points[t[(i + 1) % 3]], &r = soup.points[t[(i + 2) % 3]];
      const Vector_3 a = q - p, b = r - p, cross = CGAL::cross_product(a, b);
      const double length = std::sqrt(cross.squared_length());
      if (length > 0) normals[t[i]] = normals[t[i]] + std::atan2(length, a * b) / length * cross;
    }
  const auto at = triangles_at_edges(soup);
  for (std::size_t v = 0; v < points; ++v) {
    const double length = std::sqrt(normals[v].squared_length());
    const Vector_3 half = length > 0 ? thickness / (2 * length) * normals[v] : Vector_3(0, 0, 0);
    soup.points.push_back(soup.points[v] - half);
    soup.points[v] = soup.points[v] + half;
  }
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto [a, b, c] = soup.triangles[t];
    soup.triangles.push_back({a + points, c + points, b + points});
    soup.parts.push_back(soup.parts[t]);
  }
  for (const auto& [edge, beside] : at) {
    if (beside.size() != 1) continue;
    auto [a, b] = edge;
    if (!has_directed(soup.triangles[beside[0]], a, b)) std::swap(a, b);
    soup.triangles.push_back({b, a, a + points});
    soup.triangles.push_back({b, a + points, b + points});
    soup.parts.insert(soup.parts.end(), 2, side_part);
  }
}

std::optional<Blend_mesh> to_mesh(const Triangle_soup& soup) {
  Blend_mesh mesh;
  std::vector<Vertex> vertex(soup.points.size(), Blend_mesh::null_vertex());
  for (const auto& t : soup.triangles)
    for (const std::size_t v : t)
      if (vertex[v] == Blend_mesh::null_vertex()) vertex[v] = mesh.add_vertex(soup.points[v]);
  for (const auto& [a, b, c] : soup.triangles)
    if (mesh.add_face(vertex[a], vertex[b], vertex[c]) == Blend_mesh::null_face()) return std::nullopt;
  return mesh;
}

void reverse(Triangle_soup& soup) {
  for (auto& t : soup.triangles) std::swap(t[1], t[2]);
}

double signed_volume(const Triangle_soup& soup) {
  double sum = 0;
  const Point_3 origin = soup.points[soup.triangles[0][0]];
  for (const auto& [a, b, c] : soup.triangles)
    sum += (soup.points[a] - origin) * CGAL::cross_product(soup.points[b] - origin, soup.points[c] - origin);
  return sum / 6;
}

}  // namespace cgal_blend
