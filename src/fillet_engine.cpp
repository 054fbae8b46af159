// SPDX-License-Identifier: GPL-3.0-or-later
#include "fillet_engine.h"

#include "ancestry.h"
#include "pass_engine.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace cgal_blend {

Fillet_pass fillet_pass(const Fillet_body& body, const std::vector<Edge_blend>& blends, const Earlier_blends& earlier,
                        Blend_mesh& out, const Fillet_options& options, bool thorough) {
  std::vector<Edge_blend> wanted = blends;
  Earlier_blends before = earlier;
  std::vector<std::pair<Blend_report, Edge_blend>> refused;
  Stage_times times;
  while (true) {
    Fillet_pass pass = Pass_engine(body, options, thorough, before).run(wanted, out);
    add(times, pass.outcome.times);
    if (pass.again) {
      std::unordered_set<Edge> left_out;
      for (const auto& [place, blend] : pass.refused) {
        refused.emplace_back(pass.outcome.blends[place], blend);
        left_out.insert(blend.edges.begin(), blend.edges.end());
      }
      before.creases.insert(before.creases.end(), left_out.begin(), left_out.end());
      before.flat_corners.insert(pass.flat_corners.begin(), pass.flat_corners.end());
      for (Edge_blend& blend : wanted)
        blend.edges.erase(
            std::remove_if(blend.edges.begin(), blend.edges.end(), [&](Edge e) { return left_out.count(e) != 0; }),
            blend.edges.end());
      wanted.erase(
          std::remove_if(wanted.begin(), wanted.end(), [](const Edge_blend& blend) { return blend.edges.empty(); }),
          wanted.end());
      if (!wanted.empty()) continue;
      pass.outcome.blends.clear();
      pass.refused.clear();
      pass.outcome.diagnosis = refused.front().first.diagnosis;
    }
    for (const auto& [report, blend] : refused) {
      pass.refused.emplace_back(pass.outcome.blends.size(), blend);
      pass.outcome.blends.push_back(report);
    }
    pass.outcome.times = times;
    return pass;
  }
}

}  // namespace cgal_blend
