// SPDX-License-Identifier: GPL-3.0-or-later
// Smoke test of the installed package: headers are found, the library links and answers.
#include <cgal_blend/fillet.h>
#include <cgal_blend/validate.h>

#include <CGAL/boost/graph/generators.h>

#include <iostream>

int main() {
  using cgal_blend::Point_3;
  cgal_blend::Blend_mesh mesh, out;
  CGAL::make_tetrahedron(Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1), mesh);
  const auto report = cgal_blend::validate(mesh);
  std::cout << "tetrahedron: " << message(report.diagnosis) << "\n";

  cgal_blend::Fillet_options options;
  options.radius = 0.1;
  const auto outcome = cgal_blend::fillet_edges(mesh, {}, out, options);  // no edge chosen: refused by name
  std::cout << "nothing to blend: " << message(outcome.diagnosis) << "\n";
  return report.ok() && !outcome.ok() && out.is_empty() ? 0 : 1;
}
