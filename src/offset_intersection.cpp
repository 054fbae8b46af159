// SPDX-License-Identifier: GPL-3.0-or-later
#include "offset_intersection.h"

#include <Eigen/Geometry>

#include <CGAL/Polygon_mesh_processing/corefinement.h>

#include <algorithm>
#include <exception>
#include <map>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace cgal_blend {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

/// The offset of a patch as a mesh of its own; `base[f]` is the face that f was moved from.
struct Offset_mesh {
  Blend_mesh mesh;
  std::vector<Face> base;
};

Offset_mesh offset_mesh(const Base_patch& patch) {
  Offset_mesh result;
  std::unordered_map<Halfedge, Vertex> vertices;  // one per smooth fan: creases come apart
  for (const Face f : patch.faces) {
    const Base_surface::Frame& frame = patch.surface->frame(f);
    std::array<Vec, 3> moved;
    for (int i = 0; i < 3; ++i) moved[i] = frame.corner[i] + patch.distance * frame.normal[i];
    // A face turned over by the offset lies where the ball does not fit.
    const Vec turned = (moved[1] - moved[0]).cross(moved[2] - moved[0]);
    const Vec original = (frame.corner[1] - frame.corner[0]).cross(frame.corner[2] - frame.corner[0]);
    if (!(turned.dot(original) > 0)) continue;
    std::array<Vertex, 3> v;
    for (int i = 0; i < 3; ++i) {
      const Halfedge fan = patch.surface->fan(frame.halfedge[i]);
      const auto found = vertices.find(fan);
      v[i] = found != vertices.end() ? found->second
                                     : vertices.emplace(fan, result.mesh.add_vertex(to_point(moved[i]))).first->second;
    }
    if (result.mesh.add_face(v[0], v[1], v[2]) != Blend_mesh::null_face()) result.base.push_back(f);
  }
  return result;
}

/// An intersection point as CGAL's visitor tells it: faces of both meshes that it lies on.
struct Node {
  Vec point;
  std::array<std::vector<Face>, 2> faces;
};

struct Enough : std::exception {};

/// Records the points and stops before CGAL retriangulates: only the curve is wanted, and retriangulation is what
/// fails where an offset crosses itself.
struct Recorder : PMP::Corefinement::Default_visitor<Blend_mesh> {
  const Blend_mesh* first;
  std::vector<Node>* nodes;
  int* passes;  // edges of the first mesh with faces of the second, then the other way round

  static std::vector<Face> around(Halfedge h, const Blend_mesh& mesh) {
    std::vector<Face> faces;
    for (const Face f : mesh.faces_around_target(h))
      if (f != Blend_mesh::null_face()) faces.push_back(f);
    return faces;
  }

  static std::vector<Face> beside(Halfedge h, const Blend_mesh& mesh) {
    std::vector<Face> faces;
    for (const Halfedge g : {h, mesh.opposite(h)})
      if (!mesh.is_border(g)) faces.push_back(mesh.face(g));
    return faces;
  }

  static Vec cross_face(Halfedge edge, const Blend_mesh& mesh, Face face, const Blend_mesh& other) {
    const Vec s = to_vec(mesh.point(mesh.source(edge))), t = to_vec(mesh.point(mesh.target(edge)));
    const Halfedge h = other.halfedge(face);
    const Vec a = to_vec(other.point(other.source(h))), b = to_vec(other.point(other.target(h)));
    const Vec c = to_vec(other.point(other.target(other.next(h))));
    const Vec n = (b - a).cross(c - a);
    const double ds = n.dot(s - a), dt = n.dot(t - a);
    const double part = ds == dt ? 0.5 : std::clamp(ds / (ds - dt), 0.0, 1.0);
    return (1 - part) * s + part * t;
  }

  void intersection_point_detected(std::size_t id, int dimension, Halfedge edge, Halfedge simplex,
                                   const Blend_mesh& mesh, const Blend_mesh& other, bool target_on, bool source_on) {
    Node node;
    const int side = &mesh == first ? 0 : 1;  // the same values whichever halfedge CGAL comes by
    node.faces[side] = target_on   ? around(edge, mesh)
                       : source_on ? around(mesh.opposite(edge), mesh)
                                   : beside(edge, mesh);
    node.faces[1 - side] = dimension == 0   ? around(simplex, other)
                           : dimension == 1 ? beside(simplex, other)
                                            : std::vector<Face>{other.face(simplex)};
    for (std::vector<Face>& faces : node.faces) std::sort(faces.begin(), faces.end());
    if (target_on)
      node.point = to_vec(mesh.point(mesh.target(edge)));
    else if (source_on)
      node.point = to_vec(mesh.point(mesh.source(edge)));
    else if (dimension == 0)
      node.point = to_vec(other.point(other.target(simplex)));
    else
      node.point = cross_face(std::min(edge, mesh.opposite(edge)), mesh, node.faces[1 - side].front(), other);
    if (nodes->size() <= id) nodes->resize(id + 1);
    (*nodes)[id] = std::move(node);
  }

  void end_handling_edge_face_intersections() const {
    if (++*passes == 2) throw Enough();
  }
};

std::vector<Node> intersection_nodes(Offset_mesh& first, Offset_mesh& second) {
  std::vector<Node> nodes;
  Recorder recorder;
  recorder.first = &first.mesh;
  recorder.nodes = &nodes;
  int passes = 0;
  recorder.passes = &passes;
  try {
    PMP::corefine(first.mesh, second.mesh, CGAL::parameters::visitor(recorder));
  } catch (const std::exception&) {  // `Enough`, or degenerate offsets: the points found so far are a guess still
  }
  // CGAL numbers them as boxes lie in memory; where chains start must not depend on that.
  const auto key = [](const Node& n) { return std::tie(n.faces[0], n.faces[1], n.point[0], n.point[1], n.point[2]); };
  std::sort(nodes.begin(), nodes.end(), [&](const Node& a, const Node& b) { return key(a) < key(b); });
  return nodes;
}

using Links = std::vector<std::vector<std::size_t>>;

/// Two nodes are neighbours on the curve if one pair of faces holds both.
Links link_nodes(const std::vector<Node>& nodes) {
  std::map<std::pair<Face, Face>, std::vector<std::size_t>> segments;
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (const Face f : nodes[i].faces[0])
      for (const Face g : nodes[i].faces[1]) segments[{f, g}].push_back(i);
  Links links(nodes.size());
  for (const auto& [pair, ends] : segments) {
    if (ends.size() != 2) continue;
    for (int k = 0; k < 2; ++k) {
      auto& list = links[ends[k]];
      if (std::find(list.begin(), list.end(), ends[1 - k]) == list.end()) list.push_back(ends[1 - k]);
    }
  }
  return links;
}

std::vector<std::size_t> chain_from(std::size_t start, const Links& links, std::vector<bool>& used, bool& closed) {
  std::vector<std::size_t> chain{start};
  used[start] = true;
  closed = false;
  for (std::size_t at = start;;) {
    std::size_t next = links.size();
    for (const std::size_t n : links[at])
      if (!used[n] && links[n].size() <= 2) next = n;
    if (next == links.size()) {
      const auto& last = links[at];
      closed = chain.size() > 2 && links[start].size() == 2 && std::find(last.begin(), last.end(), start) != last.end();
      return chain;
    }
    used[next] = true;
    chain.push_back(at = next);
  }
}

}  // namespace

std::vector<Offset_curve> intersect_offsets(const Base_patch& first, const Base_patch& second) {
  std::array<Offset_mesh, 2> offsets{offset_mesh(first), offset_mesh(second)};
  const std::array<const Base_patch*, 2> patches{&first, &second};
  const std::vector<Node> nodes = intersection_nodes(offsets[0], offsets[1]);
  const Links links = link_nodes(nodes);

  const auto foot = [&](const Node& node, int side) {
    const Face moved = node.faces[side].front();
    const Base_surface::Frame& base = patches[side]->surface->frame(offsets[side].base[moved.idx()]);
    // Same barycentric coordinates on the offset face and on its base face.
    std::array<Vec, 3> corner;
    for (int i = 0; i < 3; ++i) corner[i] = base.corner[i] + patches[side]->distance * base.normal[i];
    const Vec n = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    Surface_point at{offsets[side].base[moved.idx()], {}};
    for (int i = 0; i < 3; ++i)
      at.bary[i] = (corner[(i + 2) % 3] - corner[(i + 1) % 3]).cross(node.point - corner[(i + 1) % 3]).dot(n);
    at.bary = (at.bary / n.squaredNorm()).cwiseMax(0.0);
    at.bary /= at.bary.sum();
    return at;
  };

  std::vector<Offset_curve> curves;
  std::vector<bool> used(nodes.size(), false);
  const auto collect = [&](std::size_t start) {
    Offset_curve curve;
    for (const std::size_t i : chain_from(start, links, used, curve.closed))
      curve.nodes.push_back({nodes[i].point, {foot(nodes[i], 0), foot(nodes[i], 1)}});
    if (curve.nodes.size() > 2) curves.push_back(std::move(curve));
  };
  for (std::size_t i = 0; i < nodes.size(); ++i)  // open ends first, so that no chain starts in its middle
    if (!used[i] && links[i].size() == 1) collect(i);
  for (std::size_t i = 0; i < nodes.size(); ++i)
    if (!used[i] && links[i].size() == 2) collect(i);
  return curves;
}

}  // namespace cgal_blend
