// SPDX-License-Identifier: GPL-3.0-or-later
#include "flatten_disk.h"

#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Surface_mesh_parameterization/Barycentric_mapping_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Discrete_conformal_map_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/Error_code.h>
#include <CGAL/Surface_mesh_parameterization/Mean_value_coordinates_parameterizer_3.h>
#include <CGAL/Surface_mesh_parameterization/parameterize.h>
#include <Eigen/SparseLU>

#include <algorithm>
#include <memory>
#include <utility>

namespace cgal_blend {

namespace {

namespace SMP = CGAL::Surface_mesh_parameterization;

/// CGAL's border parameterizer concept for places that are known already.
class Given_border {
 public:
  explicit Given_border(const std::vector<Point_2>& places) : places_(&places) {}

  template <class VertexUVMap, class VertexIndexMap, class VertexParameterizedMap>
  SMP::Error_code parameterize(const Blend_mesh& mesh, Halfedge border, VertexUVMap uv, VertexIndexMap,
                               VertexParameterizedMap parameterized) {
    for (const Halfedge h : CGAL::halfedges_around_face(border, mesh)) {
      put(uv, mesh.target(h), (*places_)[mesh.target(h).idx()]);
      put(parameterized, mesh.target(h), true);
    }
    return SMP::OK;
  }
  [[nodiscard]] bool is_border_convex() const { return true; }

 private:
  const std::vector<Point_2>* places_;
};

/// CGAL's sparse linear algebra concept, with one factorization for the right sides that a parameterizer solves for.
class Solver {
 public:
  using NT = double;
  using Matrix = CGAL::Eigen_sparse_matrix<double>;
  using Vector = CGAL::Eigen_vector<double>;

  bool linear_solver(const Matrix& a, const Vector& b, Vector& x, NT& d) {
    d = 1;
    if (!lu_) {
      lu_ = std::make_shared<Eigen::SparseLU<Matrix::EigenType>>();
      lu_->compute(a.eigen_object());
    }
    if (lu_->info() != Eigen::Success) return false;
    x = lu_->solve(b.eigen_object());
    return lu_->info() == Eigen::Success;
  }

 private:
  std::shared_ptr<Eigen::SparseLU<Matrix::EigenType>> lu_;  // a parameterizer solves for one matrix
};

using Conformal = SMP::Discrete_conformal_map_parameterizer_3<Blend_mesh, Given_border, Solver>;
using Mean_value = SMP::Mean_value_coordinates_parameterizer_3<Blend_mesh, Given_border, Solver>;
using Uniform = SMP::Barycentric_mapping_parameterizer_3<Blend_mesh, Given_border, Solver>;
using Uv_map = Blend_mesh::Property_map<Vertex, Point_2>;

bool is_fold_free(const Blend_mesh& mesh, const Uv_map& uv) {
  const auto faces = mesh.faces();
  return std::all_of(faces.begin(), faces.end(), [&](Face f) {
    const Halfedge h = mesh.halfedge(f);
    return CGAL::orientation(uv[mesh.source(h)], uv[mesh.target(h)], uv[mesh.target(mesh.next(h))]) == CGAL::LEFT_TURN;
  });
}

template <class Parameterizer>
bool flatten(Blend_mesh& disk, const std::vector<Point_2>& places, Uv_map uv) {
  const auto halfedges = disk.halfedges();
  const auto border = std::find_if(halfedges.begin(), halfedges.end(), [&](Halfedge h) { return disk.is_border(h); });
  return border != halfedges.end() &&
         SMP::parameterize(disk, Parameterizer(Given_border(places)), *border, uv) == SMP::OK && is_fold_free(disk, uv);
}

}  // namespace

std::optional<std::vector<Point_2>> flatten_disk(Blend_mesh& disk, const std::vector<Point_2>& border,
                                                 Flat_weights weights) {
  const Uv_map uv = disk.add_property_map<Vertex, Point_2>("v:uv").first;
  bool done = false;
  switch (weights) {
    case Flat_weights::conformal: done = flatten<Conformal>(disk, border, uv); break;
    case Flat_weights::mean_value: done = flatten<Mean_value>(disk, border, uv); break;
    case Flat_weights::uniform: done = flatten<Uniform>(disk, border, uv); break;
  }
  if (!done) return std::nullopt;
  std::vector<Point_2> points;
  for (const Vertex v : disk.vertices()) points.push_back(uv[v]);
  return points;
}

}  // namespace cgal_blend
