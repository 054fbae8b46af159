// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/fillet.h>

#include "stitching.h"
#include "stopwatch.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace cgal_blend {

namespace {

/// Where the faces of the body come from, over all steps so far.
struct Ancestry {
  std::vector<std::uint32_t> origins;  // among the faces of all bodies so far
  std::vector<bool> kept;              // bit-identical to its origin
  std::uint32_t input_faces = 0;       // of all bodies so far

  explicit Ancestry(const Blend_mesh& first)
      : origins(first.number_of_faces()), kept(origins.size(), true), input_faces(first.number_of_faces()) {
    std::iota(origins.begin(), origins.end(), 0u);
  }

  /// Passes on to the result of a boolean with a body of so many faces.
  void advance(const Fillet_outcome& step, std::uint32_t part_faces) {
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
};

void add(Stage_times& times, const Stage_times& more) {
  times.boolean += more.boolean;
  times.coarsen += more.coarsen;
  times.blend += more.blend;
  times.copy += more.copy;
  times.validate += more.validate;
}

Fillet_options options_of_step(const Fillet_options& options, const Part& part, std::size_t step, std::size_t steps) {
  Fillet_options result = options;
  if (part.law || part.radius != 0) {
    result.radius = part.radius;
    result.law = part.law;
  }
  if (options.progress)
    result.progress = [&options, step, steps](double fraction) {
      return options.progress((static_cast<double>(step) + fraction) / static_cast<double>(steps));
    };
  return result;
}

/// Faces of blends and of cut input faces were kept by later steps too, in between: moves them behind the faces of the
/// input, which are in order among themselves.
void put_kept_first(Blend_mesh& mesh, Ancestry& ancestry) {
  std::vector<Face> faces(mesh.faces().begin(), mesh.faces().end());
  const auto is_kept = [&](Face f) { return ancestry.kept[f.idx()]; };
  if (std::is_partitioned(faces.begin(), faces.end(), is_kept)) return;
  std::stable_partition(faces.begin(), faces.end(), is_kept);
  mesh = reorder(mesh, {mesh.vertices().begin(), mesh.vertices().end()}, faces).mesh;
  const Ancestry before = ancestry;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    ancestry.origins[i] = before.origins[faces[i].idx()];
    ancestry.kept[i] = before.kept[faces[i].idx()];
  }
}

/// Fills in what follows from the ancestry: nothing but the blends has no origin.
void describe_faces(Ancestry ancestry, Fillet_outcome& outcome) {
  for (std::uint32_t f = 0; f < ancestry.origins.size(); ++f) {
    if (ancestry.origins[f] == no_origin) outcome.blend_faces.push_back(Face(f));
    if (ancestry.kept[f])
      ++outcome.kept_faces;
    else
      outcome.changed_faces.push_back(Face(f));
  }
  outcome.origins = std::move(ancestry.origins);
}

}  // namespace

namespace unchecked {

Fillet_outcome corefine_and_fillet_all(const Blend_mesh& first, const std::vector<Part>& parts, Blend_mesh& out,
                                       const Fillet_options& options) {
  Fillet_outcome whole;
  if (parts.empty()) {
    whole.diagnosis = Diagnosis{Status::invalid_parameter, "there are no parts", {}, {}};
    return whole;
  }
  Ancestry ancestry(first);
  Blend_mesh body;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const Part& part = parts[k];
    CGAL_precondition(part.mesh != nullptr);
    Blend_mesh next;
    Fillet_outcome step = corefine_and_fillet(k == 0 ? first : body, *part.mesh, part.operation, next,
                                              options_of_step(options, part, k, parts.size()));
    whole.blends.insert(whole.blends.end(), step.blends.begin(), step.blends.end());
    add(whole.times, step.times);
    if (!step.ok()) {
      whole.diagnosis = std::move(step.diagnosis);
      std::string& detail = whole.diagnosis.detail;
      if (parts.size() > 1) detail = "part " + std::to_string(k + 1) + (detail.empty() ? "" : ": " + detail);
      out.clear();
      return whole;
    }
    ancestry.advance(step, part.mesh->number_of_faces());
    whole.volume = step.volume;
    whole.area = step.area;
    body = std::move(next);
  }
  const Stopwatch copying;
  if (options.mode == Blend_mode::stitch) put_kept_first(body, ancestry);
  describe_faces(std::move(ancestry), whole);
  out = std::move(body);
  whole.times.copy += copying.milliseconds();
  return whole;
}

}  // namespace unchecked

}  // namespace cgal_blend
