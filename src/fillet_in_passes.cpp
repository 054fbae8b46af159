// SPDX-License-Identifier: GPL-3.0-or-later
#include "fillet_in_passes.h"

#include "ancestry.h"
#include "edge_finder.h"
#include "fillet_engine.h"
#include "stopwatch.h"

#include <utility>

namespace cgal_blend {

Fillet_outcome fillet_in_passes(const Fillet_body& body, const std::vector<Edge_blend>& blends, Blend_mesh& out,
                                const Fillet_options& options) {
  Fillet_pass pass = fillet_pass(body, blends, {}, out, options);
  if (!pass.outcome.ok() || pass.later.empty()) return std::move(pass.outcome);
  Fillet_outcome whole = std::move(pass.outcome);
  Ancestry ancestry(whole);
  while (!pass.later.empty()) {
    Blend_mesh mesh = std::move(out);
    out.clear();
    const Edge_finder find(mesh);
    std::vector<Edge_blend> next;
    for (const Later_blend& later : pass.later) {
      Edge_blend blend{find(later.edges), later.radius, later.profile, later.law};
      if (!blend.edges.empty()) next.push_back(std::move(blend));  // else an earlier blend has taken it up
    }
    Earlier_blends earlier{find(pass.creases), {}};
    for (const Face f : mesh.faces())
      if (ancestry.origins[f.idx()] == no_origin) earlier.faces.push_back(f);
    if (next.empty()) {
      out = std::move(mesh);
      break;
    }
    Fillet_body rest;
    rest.mesh = rest.base[0] = rest.base[1] = &mesh;
    pass = fillet_pass(rest, next, earlier, out, options);
    add(whole.times, pass.outcome.times);
    whole.blends.insert(whole.blends.end(), pass.outcome.blends.begin(), pass.outcome.blends.end());
    if (!pass.outcome.ok()) {
      if (options.keep_going && pass.outcome.diagnosis.status != Status::cancelled) {
        out = std::move(mesh);  // with the blends so far
        break;
      }
      whole.diagnosis = pass.outcome.diagnosis;
      out.clear();
      return whole;
    }
    ancestry.advance(pass.outcome, 0);
    whole.volume = pass.outcome.volume;
    whole.area = pass.outcome.area;
  }
  const Stopwatch copying;
  ancestry.put_kept_first(out);
  ancestry.describe_faces(whole);
  whole.times.copy += copying.milliseconds();
  return whole;
}

}  // namespace cgal_blend
