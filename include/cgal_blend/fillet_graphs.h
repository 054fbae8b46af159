// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_FILLET_GRAPHS_H
#define CGAL_BLEND_FILLET_GRAPHS_H

#include <cgal_blend/fillet.h>
#include <cgal_blend/internal/copy_mesh.h>
#include <cgal_blend/validate.h>

#include <chrono>
#include <cstddef>
#include <deque>
#include <string>
#include <utility>
#include <vector>

// The operations of fillet.h for meshes of any type. Included by it.

namespace cgal_blend {

/// What is done about an input mesh before anything else.
enum class Input_check {
  full,  ///< `validate`; a mesh that is not acceptable is refused by name, see also `Fillet_options::accept_flaws`
  none   ///< nothing: the caller vouches for it, for example because this library wrote it
};

/// Options of the overloads for meshes of any type.
struct Graph_fillet_options : Fillet_options {
  Graph_fillet_options(const Fillet_options& options = {}, Input_check check = Input_check::full)
      : Fillet_options(options), input_check(check) {}
  Input_check input_check;
};

/// A blend of meshes of any type; the descriptors are those of the output mesh.
template <class Graph>
struct Fillet_result {
  using face_descriptor = typename boost::graph_traits<Graph>::face_descriptor;

  Diagnosis diagnosis;                         ///< `ok`, or the first refusal; then the output mesh is left as it was
  std::vector<Blend_report> blends;            ///< one per blending curve
  std::vector<face_descriptor> blend_faces;    ///< faces of the transition surfaces
  std::vector<face_descriptor> changed_faces;  ///< every face that is not a face of an input, blend faces included
  std::size_t kept_faces = 0;                  ///< faces bit-identical to faces of an input, order kept
  double volume = 0, area = 0;                 ///< of the output
  std::size_t accepted_flaws = 0;              ///< flaws of the input that are flaws of the output, see `Flaw`
  Stage_times times;                           ///< `validate` includes the check of the inputs

  [[nodiscard]] bool ok() const noexcept { return diagnosis.ok(); }
};

namespace internal {

/// Validates an input mesh; `which` names it in the message where there are two. Adds the time it took.
/// \param flaws receives those that are accepted, if the options say so; null: none are
inline Diagnosis check_input(const Blend_mesh& mesh, const Graph_fillet_options& options, const char* which,
                             Stage_times& times, std::vector<Flaw>* flaws = nullptr) {
  if (options.input_check == Input_check::none) return {};
  const auto start = std::chrono::steady_clock::now();
  const bool accept = flaws != nullptr && options.accept_flaws;
  Validity_report report = validate(mesh, accept ? Flaw_policy::accept : Flaw_policy::refuse);
  Diagnosis diagnosis = std::move(report.diagnosis);
  if (accept) *flaws = std::move(report.flaws);
  times.validate += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  const bool name_it = !diagnosis.ok() && *which != '\0';
  if (name_it) diagnosis.detail = diagnosis.detail.empty() ? which : which + (": " + diagnosis.detail);
  return diagnosis;
}

/// Hands an engine's outcome to the user; the output mesh is only touched if there is something to write into it.
template <class Graph, class Named_parameters>
Fillet_result<Graph> hand_out(const Fillet_outcome& outcome, const Blend_mesh& mesh, const Stage_times& before,
                              Graph& out, const Named_parameters& np) {
  Fillet_result<Graph> result;
  result.diagnosis = outcome.diagnosis;
  result.blends = outcome.blends;
  result.times = outcome.times;
  result.times.validate += before.validate;
  if (!outcome.ok()) return result;
  const Copy_maps<Blend_mesh, Graph> maps = copy_out(mesh, out, np);
  result.blend_faces = translated<Graph>(outcome.blend_faces, maps);
  result.changed_faces = translated<Graph>(outcome.changed_faces, maps);
  result.kept_faces = outcome.kept_faces;
  result.volume = outcome.volume;
  result.area = outcome.area;
  return result;
}

template <class Graph>
Fillet_result<Graph> refused(Diagnosis diagnosis, const Stage_times& times) {
  Fillet_result<Graph> result;
  result.diagnosis = std::move(diagnosis);
  result.times = times;
  return result;
}

}  // namespace internal

/// Blends edges of a mesh with a rolling ball. See the engine in `unchecked`.
/// \tparam Graph, Output models of `MutableFaceGraph` and `FaceListGraph` with points of any Cartesian kernel;
///         exact coordinates are rounded to double
/// \param mesh a triangle mesh, checked by `validate` unless the options say otherwise; indices in messages count its
///        vertices and faces in the order of their ranges
/// \param out receives the result; may be `mesh`; not touched if the blend is refused
/// \param np_mesh, np_out `CGAL::parameters::vertex_point_map` of the meshes
template <class Graph, class Output, class Named_parameters_mesh = CGAL::parameters::Default_named_parameters,
          class Named_parameters_out = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Fillet_result<Output> fillet_edges(
    const Graph& mesh, const std::vector<Edge_blend_of<Graph>>& blends, Output& out,
    const Graph_fillet_options& options, const Named_parameters_mesh& np_mesh = CGAL::parameters::default_values(),
    const Named_parameters_out& np_out = CGAL::parameters::default_values()) {
  const internal::Mesh_copy<Graph> copy(mesh, np_mesh);
  Stage_times times;
  std::vector<Flaw> flaws;
  if (Diagnosis bad = internal::check_input(copy.mesh(), options, "", times, &flaws); !bad.ok())
    return internal::refused<Output>(std::move(bad), times);
  std::vector<Edge_blend> copied_blends;
  for (const Edge_blend_of<Graph>& blend : blends) {
    copied_blends.push_back({{}, blend.radius, blend.profile, blend.law});
    copied_blends.back().from = blend.from;
    copied_blends.back().to = blend.to;
    if (blend.start) copied_blends.back().start = copy.copy_of_vertex(*blend.start);
    for (const auto e : blend.edges) copied_blends.back().edges.push_back(copy.copy_of_edge(e));
  }
  Blend_mesh result;
  const Fillet_outcome outcome = unchecked::fillet_edges(copy.mesh(), copied_blends, flaws, result, options);
  Fillet_result<Output> handed_out = internal::hand_out(outcome, result, times, out, np_out);
  if (handed_out.ok()) handed_out.accepted_flaws = flaws.size();
  return handed_out;
}

/// Computes a boolean of two meshes and blends their intersection curves; radius 0 leaves the curves sharp.
/// See the engine in `unchecked`; for the parameters, `fillet_edges` for meshes of any type.
template <class Graph_a, class Graph_b, class Output,
          class Named_parameters_a = CGAL::parameters::Default_named_parameters,
          class Named_parameters_b = CGAL::parameters::Default_named_parameters,
          class Named_parameters_out = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Fillet_result<Output> corefine_and_fillet(
    const Graph_a& a, const Graph_b& b, Boolean_operation operation, Output& out, const Graph_fillet_options& options,
    const Named_parameters_a& np_a = CGAL::parameters::default_values(),
    const Named_parameters_b& np_b = CGAL::parameters::default_values(),
    const Named_parameters_out& np_out = CGAL::parameters::default_values()) {
  const internal::Mesh_copy<Graph_a> copy_a(a, np_a);
  const internal::Mesh_copy<Graph_b> copy_b(b, np_b);
  Stage_times times;
  if (Diagnosis bad = internal::check_input(copy_a.mesh(), options, "first body", times); !bad.ok())
    return internal::refused<Output>(std::move(bad), times);
  if (Diagnosis bad = internal::check_input(copy_b.mesh(), options, "second body", times); !bad.ok())
    return internal::refused<Output>(std::move(bad), times);
  Blend_mesh result;
  const Fillet_outcome outcome =
      unchecked::corefine_and_fillet(copy_a.mesh(), copy_b.mesh(), operation, result, options);
  return internal::hand_out(outcome, result, times, out, np_out);
}

/// Computes a series of booleans and blends the intersection curves of each; see the engine in `unchecked`.
/// The points of the parts are those of the meshes themselves; `np_first`, `np_out` may hold a `vertex_point_map`.
/// For the other parameters, `fillet_edges` for meshes of any type.
template <class Graph, class Part_graph, class Output,
          class Named_parameters_first = CGAL::parameters::Default_named_parameters,
          class Named_parameters_out = CGAL::parameters::Default_named_parameters>
[[nodiscard]] Fillet_result<Output> corefine_and_fillet_all(
    const Graph& first, const std::vector<Part_of<Part_graph>>& parts, Output& out, const Graph_fillet_options& options,
    const Named_parameters_first& np_first = CGAL::parameters::default_values(),
    const Named_parameters_out& np_out = CGAL::parameters::default_values()) {
  const internal::Mesh_copy<Graph> copy_of_first(first, np_first);
  Stage_times times;
  if (Diagnosis bad = internal::check_input(copy_of_first.mesh(), options, "first body", times); !bad.ok())
    return internal::refused<Output>(std::move(bad), times);
  std::deque<internal::Mesh_copy<Part_graph>> copies;
  std::vector<Part> copied_parts;
  for (const Part_of<Part_graph>& part : parts) {
    CGAL_precondition(part.mesh != nullptr);
    copies.emplace_back(*part.mesh, CGAL::parameters::default_values());
    const std::string which = "part " + std::to_string(copies.size());
    if (Diagnosis bad = internal::check_input(copies.back().mesh(), options, which.c_str(), times); !bad.ok())
      return internal::refused<Output>(std::move(bad), times);
    copied_parts.push_back({&copies.back().mesh(), part.operation, part.radius, part.law});
  }
  Blend_mesh result;
  const Fillet_outcome outcome =
      unchecked::corefine_and_fillet_all(copy_of_first.mesh(), copied_parts, result, options);
  return internal::hand_out(outcome, result, times, out, np_out);
}

}  // namespace cgal_blend

#endif
