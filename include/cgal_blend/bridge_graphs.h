// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_BRIDGE_GRAPHS_H
#define CGAL_BLEND_BRIDGE_GRAPHS_H

#include <cgal_blend/bridge.h>
#include <cgal_blend/internal/copy_mesh.h>

#include <string>
#include <utility>
#include <vector>

// The operations of bridge.h for meshes of any type. Included by it.

namespace cgal_blend {

/// Bridges on meshes of any type; the descriptors are those of the output mesh.
template <class Graph>
struct Bridge_result {
  using face_descriptor = typename boost::graph_traits<Graph>::face_descriptor;

  Diagnosis diagnosis;  ///< `ok`, or the first refusal; then the output mesh is left as it was
  std::vector<Bridge_report> bridges;
  std::vector<std::vector<face_descriptor>> bridge_faces;  ///< per bridge
  std::vector<face_descriptor> changed_faces;              ///< every face that is not a face of an input
  std::size_t kept_faces = 0;                              ///< faces bit-identical to faces of an input, order kept
  double volume = 0, area = 0;                             ///< of the output
  Bridge_times times;

  [[nodiscard]] bool ok() const noexcept { return diagnosis.ok(); }
};

namespace internal {

inline Diagnosis check_bridge_input(const Blend_mesh& mesh, const char* which, const Bridge_options& options) {
  Diagnosis diagnosis =
      check_but_for_holes(mesh, options.fill_holes, "; Bridge_options::fill_holes accepts holes within contact curves");
  if (!diagnosis.ok() && *which != '\0')
    diagnosis.detail = diagnosis.detail.empty() ? which : which + (": " + diagnosis.detail);
  return diagnosis;
}

template <class Graph>
Bridge_result<Graph> refused_bridge(Diagnosis diagnosis) {
  Bridge_result<Graph> result;
  result.diagnosis = std::move(diagnosis);
  return result;
}

template <class Graph, class Named_parameters>
Bridge_result<Graph> hand_out_bridge(const Bridge_outcome& outcome, const Blend_mesh& mesh, Graph& out,
                                     const Named_parameters& np) {
  Bridge_result<Graph> result;
  result.diagnosis = outcome.diagnosis;
  result.bridges = outcome.bridges;
  result.times = outcome.times;
  if (!outcome.ok()) return result;
  const Copy_maps<Blend_mesh, Graph> maps = copy_out(mesh, out, np);
  for (const auto& faces : outcome.bridge_faces) result.bridge_faces.push_back(translated<Graph>(faces, maps));
  result.changed_faces = translated<Graph>(outcome.changed_faces, maps);
  result.kept_faces = outcome.kept_faces;
  result.volume = outcome.volume;
  result.area = outcome.area;
  return result;
}

/// Checks two bodies by name, and hands out what an engine makes of them.
template <class Engine, class Graph, class Named_parameters>
Bridge_result<Graph> bridge_two(const Blend_mesh& a, const Blend_mesh& b, const Engine& engine, Graph& out,
                                const Bridge_options& options, const Named_parameters& np) {
  if (Diagnosis bad = check_bridge_input(a, "first body", options); !bad.ok())
    return refused_bridge<Graph>(std::move(bad));
  if (Diagnosis bad = check_bridge_input(b, "second body", options); !bad.ok())
    return refused_bridge<Graph>(std::move(bad));
  Blend_mesh result;
  const Bridge_outcome outcome = engine(a, b, result);
  return hand_out_bridge(outcome, result, out, np);
}

}  // namespace internal

/// Joins two spots of a mesh by a smooth tube; see the engine in `unchecked`.
/// \tparam Graph, Output models of `MutableFaceGraph` and `FaceListGraph` with points of any Cartesian kernel;
///         exact coordinates are rounded to double
/// \param mesh a triangle mesh of one body or several, checked by `validate`, but for holes if these are to be filled
/// \param out receives the result; may be `mesh`; not touched if the bridge is refused
/// \param np_mesh, np_out `CGAL::parameters::vertex_point_map` of the meshes
template <class Graph, class Output, class Named_parameters_mesh = CGAL::parameters::Default_named_parameters,
          class Named_parameters_out = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Bridge_result<Output> bridge(const Graph& mesh, const std::array<Bridge_end, 2>& ends, Output& out,
                                           const Bridge_options& options = {},
                                           const Named_parameters_mesh& np_mesh = CGAL::parameters::default_values(),
                                           const Named_parameters_out& np_out = CGAL::parameters::default_values()) {
  const internal::Mesh_copy<Graph> copy(mesh, np_mesh);
  if (Diagnosis bad = internal::check_bridge_input(copy.mesh(), "", options); !bad.ok())
    return internal::refused_bridge<Output>(std::move(bad));
  Blend_mesh result;
  const Bridge_outcome outcome = unchecked::bridge(copy.mesh(), ends, result, options);
  return internal::hand_out_bridge(outcome, result, out, np_out);
}

/// Joins a spot of one body and a spot of another by a smooth tube. The bodies may cross each other where the bridge takes
/// the crossing away.
template <class Graph_a, class Graph_b, class Output,
          class Named_parameters_a = CGAL::parameters::Default_named_parameters,
          class Named_parameters_b = CGAL::parameters::Default_named_parameters,
          class Named_parameters_out = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Bridge_result<Output> bridge_bodies(
    const Graph_a& a, const Graph_b& b, const std::array<Bridge_end, 2>& ends, Output& out,
    const Bridge_options& options = {}, const Named_parameters_a& np_a = CGAL::parameters::default_values(),
    const Named_parameters_b& np_b = CGAL::parameters::default_values(),
    const Named_parameters_out& np_out = CGAL::parameters::default_values()) {
  const auto engine = [&](const Blend_mesh& first, const Blend_mesh& second, Blend_mesh& result) {
    return unchecked::bridge(unchecked::put_together({&first, &second}), ends, result, options);
  };
  return internal::bridge_two(internal::Mesh_copy<Graph_a>(a, np_a).mesh(),
                              internal::Mesh_copy<Graph_b>(b, np_b).mesh(), engine, out, options, np_out);
}

/// Unites two bodies that cross, with bridges in place of their intersection curves; see the engine in `unchecked`.
template <class Graph_a, class Graph_b, class Output,
          class Named_parameters_a = CGAL::parameters::Default_named_parameters,
          class Named_parameters_b = CGAL::parameters::Default_named_parameters,
          class Named_parameters_out = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Bridge_result<Output> bridge_intersection(
    const Graph_a& a, const Graph_b& b, const std::array<Bridge_end, 2>& ends, Output& out,
    const Bridge_options& options = {}, const Named_parameters_a& np_a = CGAL::parameters::default_values(),
    const Named_parameters_b& np_b = CGAL::parameters::default_values(),
    const Named_parameters_out& np_out = CGAL::parameters::default_values()) {
  const auto engine = [&](const Blend_mesh& first, const Blend_mesh& second, Blend_mesh& result) {
    return unchecked::bridge_intersection(first, second, ends, result, options);
  };
  return internal::bridge_two(internal::Mesh_copy<Graph_a>(a, np_a).mesh(),
                              internal::Mesh_copy<Graph_b>(b, np_b).mesh(), engine, out, options, np_out);
}

}  // namespace cgal_blend

#endif
