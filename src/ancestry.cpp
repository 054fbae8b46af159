// SPDX-License-Identifier: GPL-3.0-or-later
#include "ancestry.h"

#include "stitching.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace cgal_blend {

Ancestry::Ancestry(const Blend_mesh& first)
    : origins(first.number_of_faces()), kept(origins.size(), true), input_faces(first.number_of_faces()) {
  std::iota(origins.begin(), origins.end(), 0u);
}

Ancestry::Ancestry(const Fillet_outcome& first) : origins(first.origins), kept(origins.size(), true) {
  for (const Face f : first.changed_faces) kept[f.idx()] = false;
}

void Ancestry::advance(const Fillet_outcome& step, std::uint32_t part_faces) {
  std::vector<std::uint32_t> next_origins;
  std::vector<bool> next_kept(step.origins.size(), true);
  for (const Face f : step.changed_faces) next_kept[f.idx()] = false;
  const auto own_faces = static_cast<std::uint32_t>(origins.size());
  for (std::size_t f = 0; f < step.origins.size(); ++f) {
    const std::uint32_t base = step.origins[f];
    const bool own = base < own_faces;
    next_origins.push_back(own ? origins[base] : base == no_origin ? no_origin : input_faces + (base - own_faces));
    next_kept[f] = next_kept[f] && (!own || kept[base]);
  }
  origins = std::move(next_origins);
  kept = std::move(next_kept);
  input_faces += part_faces;
}

void Ancestry::put_kept_first(Blend_mesh& mesh) {
  std::vector<Face> faces(mesh.faces().begin(), mesh.faces().end());
  const auto is_kept = [&](Face f) { return kept[f.idx()]; };
  if (std::is_partitioned(faces.begin(), faces.end(), is_kept)) return;
  std::stable_partition(faces.begin(), faces.end(), is_kept);
  mesh = reorder(mesh, {mesh.vertices().begin(), mesh.vertices().end()}, faces).mesh;
  const Ancestry before = *this;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    origins[i] = before.origins[faces[i].idx()];
    kept[i] = before.kept[faces[i].idx()];
  }
}

void Ancestry::describe_faces(Fillet_outcome& outcome) const {
  outcome.blend_faces.clear();
  outcome.changed_faces.clear();
  outcome.kept_faces = 0;
  for (std::uint32_t f = 0; f < origins.size(); ++f) {
    if (origins[f] == no_origin) outcome.blend_faces.push_back(Face(f));
    if (kept[f])
      ++outcome.kept_faces;
    else
      outcome.changed_faces.push_back(Face(f));
  }
  outcome.origins = origins;
}

void add(Stage_times& times, const Stage_times& more) {
  times.boolean += more.boolean;
  times.coarsen += more.coarsen;
  times.blend += more.blend;
  times.copy += more.copy;
  times.validate += more.validate;
}

}  // namespace cgal_blend
