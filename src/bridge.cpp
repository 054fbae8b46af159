// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/bridge.h>

#include <cgal_blend/internal/copy_mesh.h>

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

namespace cgal_blend {

namespace {

constexpr std::uint32_t no_bridge = no_origin;

/// Where the faces of a mesh come from, over the bridges made so far.
struct Bridge_ancestry {
  std::vector<std::uint32_t> origins;  // among the faces of the input
  std::vector<std::uint32_t> bridges;  // that the face is a part of
  std::vector<bool> kept;              // bit-identical to its origin

  explicit Bridge_ancestry(std::size_t faces) : origins(faces), bridges(faces, no_bridge), kept(faces, true) {
    std::iota(origins.begin(), origins.end(), 0U);
  }

  void advance(const Bridge_outcome& step, std::uint32_t bridge) {
    Bridge_ancestry next(0);
    for (std::size_t f = 0; f < step.origins.size(); ++f) {
      const std::uint32_t before = step.origins[f];
      next.origins.push_back(before == no_origin ? no_origin : origins[before]);
      next.bridges.push_back(before == no_origin ? bridge : bridges[before]);
      next.kept.push_back(before != no_origin && f < step.kept_faces && kept[before]);
    }
    *this = std::move(next);
  }

  void describe(Bridge_outcome& outcome, std::size_t bridge_count) {
    outcome.bridge_faces.assign(bridge_count, {});
    for (std::size_t f = 0; f < origins.size(); ++f) {
      const Face face(static_cast<std::uint32_t>(f));
      if (kept[f])
        ++outcome.kept_faces;
      else
        outcome.changed_faces.push_back(face);
      if (bridges[f] != no_bridge) outcome.bridge_faces[bridges[f]].push_back(face);
    }
    outcome.origins = std::move(origins);
  }
};

void add(Bridge_times& times, const Bridge_times& more) {
  times.parametrize += more.parametrize;
  times.trim += more.trim;
  times.validate += more.validate;
}

/// Bridges on a closed mesh, one after the other.
Bridge_outcome bridge_closed(const Blend_mesh& mesh, const std::vector<Bridge>& bridges, Blend_mesh& out) {
  Bridge_outcome whole;
  Bridge_ancestry ancestry(mesh.number_of_faces());
  Blend_mesh body;
  for (std::size_t k = 0; k < bridges.size(); ++k) {
    Blend_mesh next;
    Bridge_outcome step = unchecked::bridge(k == 0 ? mesh : body, bridges[k].ends, next, bridges[k].options);
    whole.bridges.insert(whole.bridges.end(), step.bridges.begin(), step.bridges.end());
    add(whole.times, step.times);
    if (!step.ok()) {
      whole.diagnosis = std::move(step.diagnosis);
      std::string& detail = whole.diagnosis.detail;
      if (bridges.size() > 1) detail = "bridge " + std::to_string(k + 1) + (detail.empty() ? "" : ", " + detail);
      out.clear();
      return whole;
    }
    ancestry.advance(step, static_cast<std::uint32_t>(k));
    whole.volume = step.volume;
    whole.area = step.area;
    body = std::move(next);
  }
  ancestry.describe(whole, bridges.size());
  out = std::move(body);
  return whole;
}

/// The same on a mesh with holes, which stand filled until all bridges are made.
Bridge_outcome bridge_filled(const Blend_mesh& mesh, std::vector<Bridge> bridges, Blend_mesh& out) {
  const Filled_mesh filled = fill_mesh(mesh);
  Bridge_outcome whole;
  whole.diagnosis = filled.diagnosis;
  Blend_mesh result;
  std::vector<Bridge_end> ends;
  for (Bridge& bridge : bridges) {
    bridge.options.fill_holes = false;
    unchecked::move_spots_to_fillings(filled, bridge.ends);
    ends.insert(ends.end(), bridge.ends.begin(), bridge.ends.end());
  }
  if (whole.ok()) whole = bridge_closed(filled.mesh, bridges, result);
  if (whole.ok()) whole.diagnosis = unchecked::check_fillings(filled, whole.origins, ends);
  if (!whole.ok()) {
    Bridge_outcome refused;
    refused.diagnosis = whole.diagnosis;
    refused.bridges = whole.bridges;
    refused.times = whole.times;
    whole = std::move(refused);
    result.clear();
  }
  out = std::move(result);
  return whole;
}

}  // namespace

namespace unchecked {

Bridge_outcome bridge(const Blend_mesh& mesh, const std::array<Bridge_end, 2>& ends, Blend_mesh& out,
                      const Bridge_options& options) {
  const auto cancelled = [&](double done) { return options.progress && !options.progress(done); };
  const auto refused = [&] {
    Bridge_outcome outcome;
    outcome.diagnosis.status = Status::cancelled;
    out.clear();
    return outcome;
  };
  if (cancelled(0)) return refused();
  const Bridge_solver solver(mesh, ends, options);
  if (cancelled(0.5)) return refused();
  Blend_mesh result;  // `out` may be `mesh`
  Bridge_outcome outcome = solver.build(result);
  out = std::move(result);
  return outcome;
}

Bridge_outcome bridge_all(const Blend_mesh& mesh, const std::vector<Bridge>& bridges, Blend_mesh& out) {
  Bridge_outcome whole;
  if (bridges.empty()) {
    whole.diagnosis = {Status::invalid_parameter, "there are no bridges", {}, {}};
    return whole;
  }
  const bool fills = std::any_of(bridges.begin(), bridges.end(), [](const Bridge& b) { return b.options.fill_holes; });
  return fills && !CGAL::is_closed(mesh) ? bridge_filled(mesh, bridges, out) : bridge_closed(mesh, bridges, out);
}

Blend_mesh put_together(const std::vector<const Blend_mesh*>& bodies) {
  Blend_mesh all;
  for (const Blend_mesh* body : bodies) {
    CGAL_precondition(body != nullptr);
    internal::copy_graph(*body, body->points(), all, all.points());
  }
  return all;
}

}  // namespace unchecked

}  // namespace cgal_blend
