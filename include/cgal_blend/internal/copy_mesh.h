// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_INTERNAL_COPY_MESH_H
#define CGAL_BLEND_INTERNAL_COPY_MESH_H

#include <cgal_blend/blend_mesh.h>

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/Lazy.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <cstddef>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace cgal_blend::internal {

/// Values by descriptor: a flat array where descriptors are indices, a hash map otherwise. Unlike a dynamic property
/// map it leaves the graph alone, so that several threads may copy one mesh.
template <class Descriptor, class Value, bool = std::is_convertible_v<Descriptor, std::size_t>>
class Descriptor_map {
 public:
  void reserve(std::size_t size) { values_.reserve(size); }
  void set(Descriptor d, Value value) {
    const auto i = static_cast<std::size_t>(d);
    if (i >= values_.size()) values_.resize(i + 1);
    values_[i] = value;
  }
  [[nodiscard]] Value at(Descriptor d) const { return values_.at(static_cast<std::size_t>(d)); }

 private:
  std::vector<Value> values_;
};

template <class Descriptor, class Value>
class Descriptor_map<Descriptor, Value, false> {
 public:
  void reserve(std::size_t size) { values_.reserve(size); }
  void set(Descriptor d, Value value) { values_[d] = value; }
  [[nodiscard]] Value at(Descriptor d) const { return values_.at(d); }

 private:
  std::unordered_map<Descriptor, Value> values_;
};

template <class FT, class = void>
struct Has_exact : std::false_type {};
template <class FT>
struct Has_exact<FT, std::void_t<decltype(CGAL::exact(std::declval<const FT&>()))>> : std::true_type {};

/// Nearly nearest double. A lazy number would by itself only promise five digits, and equal numbers that were
/// constructed in different ways could become different doubles.
template <class FT>
double rounded(const FT& x) {
  if constexpr (Has_exact<FT>::value)
    return CGAL::to_double(CGAL::exact(x));
  else
    return CGAL::to_double(x);
}

/// Converts points of one kernel to another; from exact to inexact ones by rounding.
template <class From, class To>
struct Point_converter {
  To operator()(const From& p) const {
    using From_kernel = typename CGAL::Kernel_traits<From>::Kernel;
    using To_kernel = typename CGAL::Kernel_traits<To>::Kernel;
    if constexpr (std::is_same_v<From, To>)
      return p;
    else if constexpr (std::is_floating_point_v<typename To_kernel::FT>)
      return To(rounded(p.x()), rounded(p.y()), rounded(p.z()));
    else
      return CGAL::Cartesian_converter<From_kernel, To_kernel>()(p);
  }
};

/// Which element of the target each element of the source became.
template <class Source, class Target>
struct Copy_maps {
  using Source_traits = boost::graph_traits<Source>;
  using Target_traits = boost::graph_traits<Target>;
  Descriptor_map<typename Source_traits::vertex_descriptor, typename Target_traits::vertex_descriptor> vertices;
  Descriptor_map<typename Source_traits::halfedge_descriptor, typename Target_traits::halfedge_descriptor> halfedges;
  Descriptor_map<typename Source_traits::face_descriptor, typename Target_traits::face_descriptor> faces;
};

template <class Source, class Source_points, class Target, class Target_points>
void copy_vertices(const Source& source, Source_points source_points, Target& target, Target_points target_points,
                   Copy_maps<Source, Target>& maps) {
  using Convert = Point_converter<typename boost::property_traits<Source_points>::value_type,
                                  typename boost::property_traits<Target_points>::value_type>;
  for (const auto v : vertices(source)) {
    const auto copy = add_vertex(target);
    put(target_points, copy, Convert()(get(source_points, v)));
    maps.vertices.set(v, copy);
  }
}

/// `target(h, graph)` under a name that no argument called `target` hides.
template <class Graph>
auto end_vertex(typename boost::graph_traits<Graph>::halfedge_descriptor h, const Graph& graph) {
  return target(h, graph);
}

template <class Source, class Target>
void copy_edges(const Source& source, Target& target, Copy_maps<Source, Target>& maps) {
  for (const auto e : edges(source)) {
    const auto h = halfedge(e, source);
    const auto copy = halfedge(add_edge(target), target);
    maps.halfedges.set(h, copy);
    maps.halfedges.set(opposite(h, source), opposite(copy, target));
    set_face(copy, boost::graph_traits<Target>::null_face(), target);
    set_face(opposite(copy, target), boost::graph_traits<Target>::null_face(), target);
  }
  for (const auto h : halfedges(source)) {
    const auto copy = maps.halfedges.at(h);
    set_target(copy, maps.vertices.at(end_vertex(h, source)), target);
    set_next(copy, maps.halfedges.at(next(h, source)), target);
  }
}

/// Copies vertices, edges and faces in their order, with the halfedge that each of them names first, which
/// `CGAL::copy_face_graph` does not. Vertices without edges are copied too. The target must be empty.
template <class Source, class Source_points, class Target, class Target_points>
Copy_maps<Source, Target> copy_graph(const Source& source, Source_points source_points, Target& target,
                                     Target_points target_points) {
  Copy_maps<Source, Target> maps;
  copy_vertices(source, source_points, target, target_points, maps);
  copy_edges(source, target, maps);
  for (const auto f : faces(source)) {
    const auto copy = add_face(target);
    maps.faces.set(f, copy);
    set_halfedge(copy, maps.halfedges.at(halfedge(f, source)), target);
    for (const auto h : CGAL::halfedges_around_face(halfedge(f, source), source))
      set_face(maps.halfedges.at(h), copy, target);
  }
  for (const auto v : vertices(source)) {
    const auto h = halfedge(v, source);
    if (h != boost::graph_traits<Source>::null_halfedge())
      set_halfedge(maps.vertices.at(v), maps.halfedges.at(h), target);
  }
  return maps;
}

/// Copy of a user's mesh to work on, with the way from its elements to those of the copy and back.
/// Element i of the copy is the i-th of the user's mesh in the order of its ranges.
template <class Graph>
class Mesh_copy {
 public:
  using vertex_descriptor = typename boost::graph_traits<Graph>::vertex_descriptor;
  using edge_descriptor = typename boost::graph_traits<Graph>::edge_descriptor;
  using face_descriptor = typename boost::graph_traits<Graph>::face_descriptor;

  /// \param np `vertex_point_map` of the mesh
  template <class Named_parameters>
  Mesh_copy(const Graph& graph, const Named_parameters& np)
      : graph_(graph),
        vertices_(vertices(graph).begin(), vertices(graph).end()),
        edges_(edges(graph).begin(), edges(graph).end()),
        faces_(faces(graph).begin(), faces(graph).end()) {
    CGAL_precondition(CGAL::is_triangle_mesh(graph));
    using CGAL::parameters::choose_parameter;
    using CGAL::parameters::get_parameter;
    const auto points = choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point),
                                         get_const_property_map(CGAL::vertex_point, graph));
    maps_ = copy_graph(graph, points, mesh_, get(CGAL::vertex_point, mesh_));
  }

  [[nodiscard]] const Blend_mesh& mesh() const { return mesh_; }

  [[nodiscard]] Vertex copy_of_vertex(vertex_descriptor v) const { return maps_.vertices.at(v); }
  [[nodiscard]] Edge copy_of_edge(edge_descriptor e) const {
    return mesh_.edge(maps_.halfedges.at(halfedge(e, graph_)));
  }
  [[nodiscard]] Face copy_of_face(face_descriptor f) const { return maps_.faces.at(f); }

  [[nodiscard]] vertex_descriptor original(Vertex v) const { return vertices_.at(v); }
  [[nodiscard]] edge_descriptor original(Edge e) const { return edges_.at(e); }
  [[nodiscard]] face_descriptor original(Face f) const { return faces_.at(f); }

 private:
  const Graph& graph_;
  Blend_mesh mesh_;
  std::vector<vertex_descriptor> vertices_;
  std::vector<edge_descriptor> edges_;
  std::vector<face_descriptor> faces_;
  Copy_maps<Graph, Blend_mesh> maps_;
};

template <class Graph, class = void>
struct Keeps_property_maps : std::false_type {};
template <class Graph>
struct Keeps_property_maps<Graph, std::void_t<decltype(std::declval<Graph&>().clear_without_removing_property_maps())>>
    : std::true_type {};

/// Empties a mesh, but leaves property maps of the user's in place: the points may be one of them.
template <class Graph>
void empty_graph(Graph& graph) {
  if constexpr (Keeps_property_maps<Graph>::value)
    graph.clear_without_removing_property_maps();
  else
    CGAL::clear(graph);
}

/// Replaces the contents of a user's mesh by those of `mesh`, element for element.
/// \param np `vertex_point_map` of the user's mesh
template <class Graph, class Named_parameters>
Copy_maps<Blend_mesh, Graph> copy_out(const Blend_mesh& mesh, Graph& graph, const Named_parameters& np) {
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  empty_graph(graph);
  const auto points =
      choose_parameter(get_parameter(np, CGAL::internal_np::vertex_point), get_property_map(CGAL::vertex_point, graph));
  return copy_graph(mesh, get(CGAL::vertex_point, mesh), graph, points);
}

/// Faces of a mesh as those of its copy.
template <class Graph>
std::vector<typename boost::graph_traits<Graph>::face_descriptor> translated(const std::vector<Face>& faces,
                                                                             const Copy_maps<Blend_mesh, Graph>& maps) {
  std::vector<typename boost::graph_traits<Graph>::face_descriptor> result;
  result.reserve(faces.size());
  for (const Face f : faces) result.push_back(maps.faces.at(f));
  return result;
}

}  // namespace cgal_blend::internal

#endif
