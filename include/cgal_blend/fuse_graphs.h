// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_FUSE_GRAPHS_H
#define CGAL_BLEND_FUSE_GRAPHS_H

#include <cgal_blend/fuse.h>
#include <cgal_blend/internal/copy_mesh.h>

#include <array>
#include <cstddef>
#include <deque>
#include <string>
#include <utility>
#include <vector>

// The operation of fuse.h for meshes of any type. Included by it.

namespace cgal_blend {

/// A fusion of meshes of any type; the descriptors are those of the output mesh. For the other members see `Fuse_outcome`.
template <class Graph>
struct Fuse_result {
  using face_descriptor = typename boost::graph_traits<Graph>::face_descriptor;

  Diagnosis diagnosis;  ///< `ok`, or the first refusal; then the output mesh is left as it was
  std::vector<face_descriptor> transition_faces;
  std::vector<face_descriptor> changed_faces;
  std::size_t kept_faces = 0;
  std::array<std::size_t, 2> rings{};
  std::array<bool, 2> one_sided{};
  double angle = 0, height = 0;
  long euler_characteristic = 0;
  double tangency_mean = 0, tangency_max = 0;
  double volume = 0, area = 0;
  Fuse_times times;

  [[nodiscard]] bool ok() const noexcept { return diagnosis.ok(); }
};

namespace internal {

/// Copies of the meshes of one side.
template <class Graph>
struct Copied_side {
  std::deque<Mesh_copy<Graph>> copies;  // their addresses stay
  Fusion_side side;
};

/// Copies and checks the meshes of a side; `which` names it in the message.
template <class Graph, class Named_parameters>
Diagnosis copy_side(const Fusion_side_of<Graph>& side, const std::string& which, const Named_parameters& np,
                    Copied_side<Graph>& copied) {
  copied.side.plane = side.plane;
  for (const Graph* mesh : side.meshes) {
    CGAL_precondition(mesh != nullptr);
    copied.copies.emplace_back(*mesh, np);
    copied.side.meshes.push_back(&copied.copies.back().mesh());
    Diagnosis bad = check_fusion_part(copied.copies.back().mesh(), side.plane);
    if (bad.ok()) continue;
    const std::string name = which + " mesh " + std::to_string(copied.copies.size());
    bad.detail = bad.detail.empty() ? name : name + ": " + bad.detail;
    return bad;
  }
  return {};
}

template <class Graph, class Named_parameters>
Fuse_result<Graph> hand_out_fusion(const Fuse_outcome& outcome, const Blend_mesh& mesh, Graph& out,
                                   const Named_parameters& np) {
  Fuse_result<Graph> result;
  result.diagnosis = outcome.diagnosis;
  result.rings = outcome.rings;
  result.angle = outcome.angle;
  result.height = outcome.height;
  result.times = outcome.times;
  if (!outcome.ok()) return result;
  const Copy_maps<Blend_mesh, Graph> maps = copy_out(mesh, out, np);
  result.transition_faces = translated<Graph>(outcome.transition_faces, maps);
  result.changed_faces = translated<Graph>(outcome.changed_faces, maps);
  result.kept_faces = outcome.kept_faces;
  result.one_sided = outcome.one_sided;
  result.euler_characteristic = outcome.euler_characteristic;
  result.tangency_mean = outcome.tangency_mean;
  result.tangency_max = outcome.tangency_max;
  result.volume = outcome.volume;
  result.area = outcome.area;
  return result;
}

}  // namespace internal

/// Joins the openings of two sides by a transition surface. See the engine in `unchecked`.
/// \tparam Lower, Upper, Output models of `MutableFaceGraph` and `FaceListGraph` with points of any Cartesian kernel;
///         exact coordinates are rounded to double
/// \param lower, upper triangle meshes, checked by `check_fusion_part`; indices in messages count vertices and faces in the
///        order of their ranges
/// \param out receives the result; may be one of the meshes; not touched if the fusion is refused
/// \param np_lower, np_upper, np_out `CGAL::parameters::vertex_point_map`; that of a side serves all its meshes
template <class Lower, class Upper, class Output,
          class Named_parameters_lower = CGAL::parameters::Default_named_parameters,
          class Named_parameters_upper = CGAL::parameters::Default_named_parameters,
          class Named_parameters_out = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Fuse_result<Output> fuse(const Fusion_side_of<Lower>& lower, const Fusion_side_of<Upper>& upper,
                                       Output& out, const Fuse_options& options = {},
                                       const Named_parameters_lower& np_lower = CGAL::parameters::default_values(),
                                       const Named_parameters_upper& np_upper = CGAL::parameters::default_values(),
                                       const Named_parameters_out& np_out = CGAL::parameters::default_values()) {
  internal::Copied_side<Lower> below;
  internal::Copied_side<Upper> above;
  Fuse_outcome outcome;
  outcome.diagnosis = internal::copy_side(lower, "lower", np_lower, below);
  if (outcome.ok()) outcome.diagnosis = internal::copy_side(upper, "upper", np_upper, above);
  Blend_mesh result;
  if (outcome.ok()) outcome = unchecked::fuse(below.side, above.side, result, options);
  return internal::hand_out_fusion(outcome, result, out, np_out);
}

}  // namespace cgal_blend

#endif
