// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_choice.h"

#include "failure.h"

#include <cgal_blend/creases.h>
#include <cgal_blend/curve_network.h>
#include <cgal_blend/polyline.h>
#include <cgal_blend/selection.h>

namespace cgal_blend::cli {

namespace {

std::vector<Edge> creases(const Blend_mesh& mesh, double angle) {
  std::vector<Edge> found;
  for (Edge e : mesh.edges())
    if (is_crease(e, mesh, angle)) found.push_back(e);
  return found;
}

Vertex vertex_with_index(const Blend_mesh& mesh, std::size_t index, const std::string& where) {
  if (index >= mesh.number_of_vertices())
    throw Failure(Diagnosis{Status::no_such_edge, "there is no vertex " + std::to_string(index), {}, {}}, where);
  return Vertex(static_cast<Blend_mesh::size_type>(index));
}

std::vector<Edge> edges_along(const Blend_mesh& mesh, const std::vector<Vertex>& chain, const std::string& where) {
  const Edge_chain<Blend_mesh> edges = edges_of_polyline(mesh, chain);
  if (!edges.ok()) throw Failure(edges.diagnosis, where);
  return edges.edges;
}

std::vector<Edge> selected_edges(const Blend_mesh& mesh, const std::string& path) {
  std::vector<Edge> found;
  for (const auto& [from, to] : read_selection(path).edges) {
    const std::string where = in_quotes(path) + ", edge " + std::to_string(from) + " " + std::to_string(to);
    const std::vector<Vertex> ends{vertex_with_index(mesh, from, where), vertex_with_index(mesh, to, where)};
    found.push_back(edges_along(mesh, ends, where).front());
  }
  return found;
}

std::vector<Vertex> vertices_along(const Blend_mesh& mesh, const std::vector<Point_3>& polyline,
                                   const Vertex_locator<Blend_mesh>& locate, const std::string& where) {
  const Edge_chain<Blend_mesh> edges = edges_of_polyline(mesh, polyline, locate);
  if (!edges.ok()) throw Failure(edges.diagnosis, where);
  std::vector<Vertex> chain;
  for (const Point_3& p : polyline) chain.push_back(*locate(p));
  return chain;
}

/// A closed curve has the sense of its branch, whatever way the polyline runs round.
bool runs_against_branch(const Blend_mesh& mesh, const std::vector<Edge>& edges, const std::vector<Vertex>& polyline) {
  for (const Branch<Blend_mesh>& branch : make_curve_network(mesh, edges).branches)
    for (const Halfedge h : branch.halfedges)
      if (branch.closed() && mesh.source(h) == polyline[1] && mesh.target(h) == polyline[0]) return true;
  return false;
}

/// The blend along a polyline, at whose first vertex its radius and its fractions begin.
Edge_blend blend_along(const Blend_mesh& mesh, const std::vector<Vertex>& polyline, const Edge_choice& choice,
                       const Blend_request& request, const std::string& where) {
  Edge_blend blend{edges_along(mesh, polyline, where), 0, request.profile};
  blend.from = request.from.value_or(choice.from);
  blend.to = request.to.value_or(choice.to);
  const bool is_partial = blend.from != 0 || blend.to != 1;
  const bool varies = request.radius && !request.radius->is_constant();
  const bool turned = (is_partial || varies) && runs_against_branch(mesh, blend.edges, polyline);
  if (is_partial || varies) blend.start = polyline.front();
  if (is_partial && turned) {
    const double from = blend.from;
    blend.from = 1 - blend.to;
    blend.to = 1 - from;
  }
  if (varies)
    blend.law = turned ? request.radius->reversed() : *request.radius;
  else if (request.radius)
    blend.radius = request.radius->largest();  // blends with the same number are joined where they meet
  return blend;
}

std::vector<Edge_blend> requested_edges(const Blend_mesh& mesh, const Edge_choice& choice,
                                        const std::vector<Blend_request>& requests) {
  const std::string& path = choice.blends_file;
  std::vector<Edge_blend> blends;
  std::optional<Vertex_locator<Blend_mesh>> locate;
  for (const Blend_request& request : requests) {
    const std::string where = in_quotes(path) + ", blend " + std::to_string(blends.size() + 1);
    std::vector<Vertex> polyline;
    for (const std::size_t index : request.vertices) polyline.push_back(vertex_with_index(mesh, index, where));
    if (!request.points.empty()) {
      if (!locate) locate.emplace(mesh);
      polyline = vertices_along(mesh, request.points, *locate, where);
    }
    blends.push_back(blend_along(mesh, polyline, choice, request, where));
  }
  return blends;
}

}  // namespace

void Edge_choice::require_one() const {
  const int given = int(sharp_angle.has_value()) + int(!edges_file.empty()) + int(!blends_file.empty());
  if (given != 1) throw usage_failure("name the edges to blend by exactly one of --sharp-angle, --edges and --blends");
}

std::vector<Edge_blend> chosen_edges(const Edge_choice& choice, const std::vector<Blend_request>& requests,
                                     const Blend_mesh& mesh) {
  if (!choice.blends_file.empty()) {
    if (requests.empty())
      throw Failure(Diagnosis{Status::no_edges_selected, "", {}, {}}, in_quotes(choice.blends_file));
    return requested_edges(mesh, choice, requests);
  }
  const std::vector<Edge> edges =
      choice.sharp_angle ? creases(mesh, *choice.sharp_angle) : selected_edges(mesh, choice.edges_file);
  if (edges.empty()) throw Failure(Diagnosis{Status::no_edges_selected, "", {}, {}});
  Edge_blend blend{edges};
  blend.from = choice.from;
  blend.to = choice.to;
  return {blend};
}

}  // namespace cgal_blend::cli
