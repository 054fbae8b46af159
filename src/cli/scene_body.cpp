// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_body.h"

#include "failure.h"
#include "transform.h"

#include <cgal_blend/mesh_io.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>
#include <vector>

namespace cgal_blend::cli {

namespace {

using Corners = std::array<std::size_t, 3>;

constexpr double most_faces = 4e6;

Blend_mesh mesh_of(const std::vector<Point_3>& points, const std::vector<Corners>& triangles) {
  Blend_mesh mesh;
  for (const Point_3& p : points) mesh.add_vertex(p);
  const auto vertex = [](std::size_t i) { return Vertex(static_cast<std::uint32_t>(i)); };
  for (const Corners& t : triangles) mesh.add_face(vertex(t[0]), vertex(t[1]), vertex(t[2]));
  return mesh;
}

double positive(const Scene_value& json) {
  const double value = json.number();
  if (!(value > 0 && std::isfinite(value))) json.refuse("must be greater than 0");
  return value;
}

std::size_t count(const Scene_value& parent, const std::string& key, std::size_t otherwise, std::size_t least) {
  if (!parent.has(key)) return otherwise;
  const std::size_t value = parent[key].index();
  if (value < least || static_cast<double>(value) > most_faces)
    parent[key].refuse("must be at least " + std::to_string(least) + ", and not huge");
  return value;
}

/// Icosahedron, divided; unit sphere.
Blend_mesh unit_sphere(std::size_t level) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  std::vector<Vector_3> points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                                  {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  std::vector<Corners> triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (; level > 0; --level) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> middles;
    const auto middle = [&](std::size_t i, std::size_t j) {
      const auto [place, is_new] = middles.emplace(std::minmax(i, j), points.size());
      if (is_new) points.push_back((points[i] + points[j]) / 2);
      return place->second;
    };
    std::vector<Corners> finer;
    for (const auto& [a, b, c] : triangles) {
      const std::size_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    triangles = std::move(finer);
    for (Vector_3& p : points) p = p / std::sqrt(p.squared_length());
  }
  std::vector<Point_3> places;
  for (const Vector_3& p : points) places.push_back(CGAL::ORIGIN + p / std::sqrt(p.squared_length()));
  return mesh_of(places, triangles);
}

void stretch(Blend_mesh& mesh, const Vector_3& axes, const Point_3& centre) {
  for (const Vertex v : mesh.vertices()) {
    const Point_3& p = mesh.point(v);
    mesh.point(v) = centre + Vector_3(axes.x() * p.x(), axes.y() * p.y(), axes.z() * p.z());
  }
}

Point_3 centre_of(const Scene_value& json) { return json.has("centre") ? json["centre"].point() : Point_3(0, 0, 0); }

Blend_mesh sphere(const Scene_value& json) {
  json.allow({"radius", "centre", "level"});
  const double r = positive(json["radius"]);
  const std::size_t level = count(json, "level", 5, 0);
  if (level > 8) json["level"].refuse("must not be above 8");
  Blend_mesh mesh = unit_sphere(level);
  stretch(mesh, {r, r, r}, centre_of(json));
  return mesh;
}

Blend_mesh ellipsoid(const Scene_value& json) {
  json.allow({"axes", "centre", "level"});
  const std::size_t level = count(json, "level", 5, 0);
  if (level > 8) json["level"].refuse("must not be above 8");
  const auto axes = json["axes"].list(3);
  Blend_mesh mesh = unit_sphere(level);
  stretch(mesh, {positive(axes[0]), positive(axes[1]), positive(axes[2])}, centre_of(json));
  return mesh;
}

/// Around the z axis.
Blend_mesh torus(const Scene_value& json) {
  json.allow({"major", "minor", "centre", "around", "across"});
  const double major = positive(json["major"]), minor = positive(json["minor"]);
  if (minor >= major) json["minor"].refuse("must be less than 'major'");
  const std::size_t n = count(json, "around", 160, 3), m = count(json, "across", 48, 3);
  const Vector_3 centre = centre_of(json) - CGAL::ORIGIN;
  std::vector<Point_3> points;
  std::vector<Corners> triangles;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = 0; j < m; ++j) {
      const double a = 2 * CGAL_PI * static_cast<double>(i) / static_cast<double>(n),
                   b = 2 * CGAL_PI * static_cast<double>(j) / static_cast<double>(m);
      const double r = major + minor * std::cos(b);
      points.push_back(Point_3(r * std::cos(a), r * std::sin(a), minor * std::sin(b)) + centre);
      const std::size_t k = (i + 1) % n, l = (j + 1) % m;
      triangles.push_back({i * m + j, k * m + j, k * m + l});
      triangles.push_back({i * m + j, k * m + l, i * m + l});
    }
  return mesh_of(points, triangles);
}

/// Along the z axis, centred, with rings on its wall and on its caps.
Blend_mesh cylinder(const Scene_value& json) {
  json.allow({"radius", "height", "centre", "around", "rings", "cap_rings"});
  const double r = positive(json["radius"]), h = positive(json["height"]);
  const std::size_t n = count(json, "around", 96, 3), rings = count(json, "rings", 48, 1),
                    caps = count(json, "cap_rings", 8, 1);
  const Vector_3 centre = centre_of(json) - CGAL::ORIGIN;
  std::vector<std::pair<double, double>> profile;  // radius and height, from the lower centre to the upper one
  for (std::size_t i = 1; i <= caps; ++i)
    profile.emplace_back(r * static_cast<double>(i) / static_cast<double>(caps), -h / 2);
  for (std::size_t i = 1; i <= rings; ++i)
    profile.emplace_back(r, h * (static_cast<double>(i) / static_cast<double>(rings) - 0.5));
  for (std::size_t i = caps - 1; i > 0; --i)
    profile.emplace_back(r * static_cast<double>(i) / static_cast<double>(caps), h / 2);
  std::vector<Point_3> points{Point_3(0, 0, -h / 2) + centre, Point_3(0, 0, h / 2) + centre};
  for (const auto& [radius, z] : profile)
    for (std::size_t i = 0; i < n; ++i) {
      const double a = 2 * CGAL_PI * static_cast<double>(i) / static_cast<double>(n);
      points.push_back(Point_3(radius * std::cos(a), radius * std::sin(a), z) + centre);
    }
  std::vector<Corners> triangles;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t k = (i + 1) % n, last = 2 + (profile.size() - 1) * n;
    triangles.push_back({0, 2 + k, 2 + i});
    triangles.push_back({1, last + i, last + k});
    for (std::size_t j = 0; j + 1 < profile.size(); ++j) {
      const std::size_t low = 2 + j * n, high = low + n;
      triangles.push_back({low + i, low + k, high + k});
      triangles.push_back({low + i, high + k, high + i});
    }
  }
  return mesh_of(points, triangles);
}

Transform placement(const Scene_value& json) {
  std::string text;
  for (const Scene_value& number : json.list(12)) {
    const std::string digits = nlohmann::json(number.number()).dump();
    text += (text.empty() ? "" : " ") + digits;
  }
  return parse_transform(text, json.where());
}

}  // namespace

Blend_mesh read_scene_body(const Scene_value& json, const std::string& folder) {
  json.allow({"file", "sphere", "ellipsoid", "torus", "cylinder", "transform"});
  Blend_mesh mesh;
  if (json.has("file"))
    mesh = read_mesh((std::filesystem::path(folder) / json["file"].text()).string());
  else if (json.has("sphere"))
    mesh = sphere(json["sphere"]);
  else if (json.has("ellipsoid"))
    mesh = ellipsoid(json["ellipsoid"]);
  else if (json.has("torus"))
    mesh = torus(json["torus"]);
  else if (json.has("cylinder"))
    mesh = cylinder(json["cylinder"]);
  else
    json.refuse("must have a 'file', 'sphere', 'ellipsoid', 'torus' or 'cylinder'");
  if (json.has("transform")) {
    const Transform transform = placement(json["transform"]);
    apply(transform, mesh);
  }
  return mesh;
}

}  // namespace cgal_blend::cli
