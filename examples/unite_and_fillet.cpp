// SPDX-License-Identifier: GPL-3.0-or-later
// Puts a round boss on a plate, both made here, and blends the curve in which they meet.
//   unite_and_fillet [RADIUS [OUT.off]]
#include <cgal_blend/fillet.h>
#include <cgal_blend/mesh_io.h>

#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/boost/graph/generators.h>

#include <cstdlib>
#include <iostream>

using cgal_blend::Blend_mesh;
using cgal_blend::Point_3;

// 100 x 100 x 10, the upper side at y = 0.
Blend_mesh make_plate() {
  Blend_mesh mesh;
  CGAL::make_hexahedron(Point_3(-50, -10, -50), Point_3(-50, -10, 50), Point_3(50, -10, 50), Point_3(50, -10, -50),
                        Point_3(50, 0, -50), Point_3(-50, 0, -50), Point_3(-50, 0, 50), Point_3(50, 0, 50), mesh);
  CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
  return mesh;
}

// A cylinder of radius 15 about a vertical axis, off centre; it begins inside the plate.
Blend_mesh make_boss() {
  Blend_mesh mesh;
  CGAL::make_regular_prism(128, mesh, Point_3(3, -5, 1), 45.0, 15.0, true);
  return mesh;
}

int main(int argc, char** argv) {
  cgal_blend::Fillet_options options;
  options.radius = argc > 1 ? std::atof(argv[1]) : 5;
  Blend_mesh part;
  // As graph options, so that both bodies are checked first.
  const auto result = corefine_and_fillet(make_plate(), make_boss(), cgal_blend::Boolean_operation::union_, part,
                                          cgal_blend::Graph_fillet_options(options));
  if (!result.ok()) {
    std::cerr << message(result.diagnosis) << "\n";
    return EXIT_FAILURE;
  }
  std::cout << part.number_of_faces() << " faces, " << result.blend_faces.size() << " of them blend; volume "
            << result.volume << "\n";
  for (const cgal_blend::Blend_report& blend : result.blends)
    std::cout << "curve of " << blend.edges << " edges: radius " << blend.radius << " within "
              << 100 * blend.radius_error << " %\n";
  cgal_blend::write_mesh(argc > 2 ? argv[2] : "boss_on_plate.off", part);
}
