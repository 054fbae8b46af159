// SPDX-License-Identifier: GPL-3.0-or-later
// Rounds all edges of an L-shaped bracket, made here: the concave one, and the convex ones over its ends and corners.
//   round_bracket [RADIUS [OUT.off]]
#include <cgal_blend/creases.h>
#include <cgal_blend/fillet.h>
#include <cgal_blend/mesh_io.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <vector>

using namespace cgal_blend;

// Legs of 30 and 24, 6 thick, 20 high.
Blend_mesh make_bracket() {
  const std::array<std::array<double, 2>, 6> outline{{{0, 0}, {30, 0}, {30, 6}, {6, 6}, {6, 24}, {0, 24}}};
  Blend_mesh mesh;
  std::vector<Vertex> low, high;
  for (const auto& [x, y] : outline) low.push_back(mesh.add_vertex(Point_3(x, y, 0)));
  for (const auto& [x, y] : outline) high.push_back(mesh.add_vertex(Point_3(x, y, 20)));
  for (const auto& [a, b, c] : {std::array{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}) {
    mesh.add_face(high[a], high[b], high[c]);
    mesh.add_face(low[c], low[b], low[a]);
  }
  for (std::size_t i = 0, k = 1; i < 6; ++i, k = (i + 1) % 6) {
    mesh.add_face(low[i], low[k], high[k]);
    mesh.add_face(low[i], high[k], high[i]);
  }
  return mesh;
}

std::vector<Edge> sharp_edges(Blend_mesh& mesh) {
  const auto is_crease = mesh.add_property_map<Edge, bool>("e:is_crease", false).first;
  detect_creases(mesh, 40, is_crease);
  std::vector<Edge> edges;
  std::copy_if(mesh.edges().begin(), mesh.edges().end(), std::back_inserter(edges),
               [&](Edge e) { return is_crease[e]; });
  return edges;
}

int main(int argc, char** argv) {
  Blend_mesh bracket = make_bracket();
  const std::vector<Edge_blend> blends{{sharp_edges(bracket)}};
  Fillet_options options;
  options.radius = argc > 1 ? std::atof(argv[1]) : 1.5;
  Blend_mesh round;
  const auto result = fillet_edges(bracket, blends, round, options);
  if (!result.ok()) {
    std::cerr << message(result.diagnosis) << "\n";
    return EXIT_FAILURE;
  }
  std::cout << result.blends.size() << " blends, volume " << result.volume << "\n";

  // A radius that is too large is refused, and the refusal tells the largest that it has found to work.
  options.radius = 6;
  Blend_mesh none;
  const auto refused = fillet_edges(bracket, blends, none, options);
  if (refused.diagnosis.max_radius) std::cout << "largest radius " << *refused.diagnosis.max_radius << "\n";
  write_mesh(argc > 2 ? argv[2] : "bracket.off", round);
}
