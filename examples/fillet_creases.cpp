// SPDX-License-Identifier: GPL-3.0-or-later
// Finds the creases of a mesh and blends them, corners included; says what it left sharp.
//   fillet_creases IN OUT RADIUS [ANGLE]
#include <cgal_blend/creases.h>
#include <cgal_blend/curve_network.h>
#include <cgal_blend/fillet.h>
#include <cgal_blend/mesh_io.h>
#include <cgal_blend/validate.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <vector>

using namespace cgal_blend;

std::vector<Edge> edges_marked(const Blend_mesh& mesh, const Blend_mesh::Property_map<Edge, bool>& mark) {
  std::vector<Edge> edges;
  for (Edge e : mesh.edges())
    if (mark[e]) edges.push_back(e);
  return edges;
}

int run(const char* in, const char* out, double radius, double angle) {
  Blend_mesh mesh = read_mesh(in);
  if (const auto validity = validate(mesh); !validity.ok()) {
    std::cerr << message(validity.diagnosis) << "\n";
    return EXIT_FAILURE;
  }
  auto is_crease = mesh.add_property_map<Edge, bool>("e:is_crease", false).first;
  detect_creases(mesh, angle, is_crease);
  const std::vector<Edge> creases = edges_marked(mesh, is_crease);
  const Curve_network<Blend_mesh> network = make_curve_network(mesh, creases);

  const auto closed = std::count_if(network.branches.begin(), network.branches.end(),
                                    [](const auto& branch) { return branch.closed(); });
  std::cout << network.branches.size() << " curves, " << closed << " of them closed\n";

  Fillet_options options;
  options.radius = radius;
  options.keep_going = true;
  Blend_mesh blended;
  const auto outcome = fillet_edges(mesh, {Edge_blend{creases}}, blended, options);
  for (const Blend_report& blend : outcome.blends)
    std::cout << "curve of " << blend.edges << " edges: " << message(blend.diagnosis) << "\n";
  if (!outcome.ok()) {
    std::cerr << message(outcome.diagnosis) << "\n";
    return EXIT_FAILURE;
  }
  write_mesh(out, blended);
  return EXIT_SUCCESS;
}

int main(int argc, char** argv) {
  if (argc < 4) {
    std::cerr << "usage: fillet_creases IN OUT RADIUS [ANGLE]\n";
    return EXIT_FAILURE;
  }
  try {
    return run(argv[1], argv[2], std::atof(argv[3]), argc > 4 ? std::atof(argv[4]) : 40);
  } catch (const Mesh_io_error& error) {
    std::cerr << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
