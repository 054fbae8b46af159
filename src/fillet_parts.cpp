// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/fillet.h>

#include "ancestry.h"
#include "stopwatch.h"

#include <utility>

namespace cgal_blend {

namespace {

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
  if (options.mode == Blend_mode::stitch) ancestry.put_kept_first(body);
  ancestry.describe_faces(whole);
  out = std::move(body);
  whole.times.copy += copying.milliseconds();
  return whole;
}

}  // namespace unchecked

}  // namespace cgal_blend
