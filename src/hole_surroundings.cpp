// SPDX-License-Identifier: GPL-3.0-or-later
#include "hole_surroundings.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <Eigen/SparseLU>

#include <cmath>
#include <iterator>

namespace cgal_blend {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

constexpr int rings_around = 3;  // of faces; fairing with continuous tangents looks at two
constexpr double evenly = 2;     // mean edge at a rim over mean edge along it, up to which faces count as of one size
const double usual_density = std::sqrt(2.0);

double length(const Blend_mesh& mesh, Halfedge h) {
  return std::sqrt(CGAL::squared_distance(mesh.point(mesh.source(h)), mesh.point(mesh.target(h))));
}

/// Triangles of a filling are as large as the faces around. Where these are long strips that end at the rim, it is the
/// rim's edges that count: else there would be no vertex within, and no way for the filling to go on smoothly.
double density(const Blend_mesh& mesh, Halfedge hole) {
  double along = 0, around = 0;
  std::size_t rim = 0, edges = 0;
  for (const Halfedge h : mesh.halfedges_around_face(hole)) {
    along += length(mesh, h);
    ++rim;
    for (const Halfedge g : mesh.halfedges_around_target(h)) {
      around += length(mesh, g);
      ++edges;
    }
  }
  const double ratio = around / static_cast<double>(edges) / (along / static_cast<double>(rim));
  return ratio > evenly ? usual_density * ratio : usual_density;
}

}  // namespace

Hole_surroundings::Hole_surroundings(const Blend_mesh& mesh, Halfedge hole) : mesh_(mesh), hole_(hole) {
  std::vector<Vertex> front;
  for (const Halfedge h : mesh.halfedges_around_face(hole)) front.push_back(mesh.target(h));
  for (int ring = 0; ring < rings_around; ++ring) front = add_faces_at(front);
}

std::vector<Face> Hole_surroundings::fill() {
  std::vector<Face> faces;
  if (failed_) return faces;
  const Halfedge h = copy_.halfedge(vertex_at(mesh_.source(hole_)), vertex_at(mesh_.target(hole_)));
  if (h == Blend_mesh::null_halfedge() || !copy_.is_border(h)) return faces;
  using Solver = CGAL::Eigen_solver_traits<Eigen::SparseLU<CGAL::Eigen_sparse_matrix<double>::EigenType>>;
  std::vector<Vertex> vertices;
  PMP::triangulate_refine_and_fair_hole(
      copy_, h, std::back_inserter(faces), std::back_inserter(vertices),
      PMP::parameters::sparse_linear_solver(Solver()).density_control_factor(density(copy_, h)));
  return faces;
}

Vertex Hole_surroundings::vertex_at(Vertex v) {
  const auto [found, is_new] = copies_.emplace(v, Vertex());
  if (is_new) {
    found->second = copy_.add_vertex(mesh_.point(v));
    originals_.push_back(v);
  }
  return found->second;
}

std::vector<Vertex> Hole_surroundings::add_faces_at(const std::vector<Vertex>& front) {
  std::vector<Vertex> reached;
  for (const Vertex v : front)
    for (const Face f : mesh_.faces_around_target(mesh_.halfedge(v))) {
      if (f == Blend_mesh::null_face() || !faces_.insert(f).second) continue;
      std::vector<Vertex> corners;
      for (const Vertex w : mesh_.vertices_around_face(mesh_.halfedge(f))) {
        corners.push_back(vertex_at(w));
        reached.push_back(w);
      }
      failed_ = failed_ || copy_.add_face(corners) == Blend_mesh::null_face();
    }
  return reached;
}

}  // namespace cgal_blend
