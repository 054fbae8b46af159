// SPDX-License-Identifier: GPL-3.0-or-later
// Joins an ellipsoid, cut by a plane, to a cylinder, cut by another cylinder, with a blend that continues the curvature.
//   blend_quadrics [DISTANCE [OUT.off]]
#include <cgal_blend/boundary_models.h>
#include <cgal_blend/mesh_io.h>
#include <cgal_blend/quadric_intersection.h>
#include <cgal_blend/surface_blend_body.h>
#include <cgal_blend/surface_blend_fit.h>

#include <array>
#include <cstdlib>
#include <iostream>

using namespace cgal_blend;

// The component of an intersection that lies above z = 0, as a boundary curve of the quadric.
Boundary_curve upper_curve(const Quadric_3& quadric, const Quadric_intersection& section) {
  for (const Intersection_curve& curve : section.components)
    if (curve.is_closed() && curve.at(0).point.z() > 0)
      return Implicit_boundary(implicit_function(quadric), space_curve_of(curve));
  std::cerr << "no closed curve: " << section.type << "\n";
  std::exit(EXIT_FAILURE);
}

int main(int argc, char** argv) {
  // Factors of x^2, y^2, z^2, xy, xz, yz, x, y, z, 1; exact rational numbers.
  const Quadric_3 ellipsoid(std::array<double, 10>{1, 2, 4, 0, 0, 0, 0, 0, 0, -8});
  const Quadric_3 cylinder = Quadric_3::cylinder({0, 0, 0}, {0, 0, 1}, Quadric_3::Rational(1) / 2);
  const Quadric_3 cutter = Quadric_3::cylinder({0, 0, 0}, {1, 0, 0}, 9);
  const Quadric_3::Plane plane{0, 0, 1, -1}, far{0, 0, 1, -5};  // z = 1, and what is kept has z <= 5

  Surface_blend_options options;
  options.g2 = true;
  if (argc > 1) options.sides[0].distance = options.sides[1].distance = std::atof(argv[1]);
  const auto result = blend_surfaces(upper_curve(ellipsoid, intersect(ellipsoid, plane)),
                                     upper_curve(cylinder, intersect_quadrics(cylinder, cutter)), options);
  if (!result.ok()) {
    std::cerr << message(result.diagnosis) << "\n";  // for example: folds; with how much smaller distances it would not
    return EXIT_FAILURE;
  }
  std::cout << "degree " << result.blend->degree() << ", distances times " << result.factor << "\n";

  const Blend_body body =
      make_blend_body({trimmed_quadric(ellipsoid), trimmed_quadric(cylinder, {far})}, {{*result.blend}});
  if (!body.ok()) {
    std::cerr << message(body.diagnosis) << "\n";
    return EXIT_FAILURE;
  }
  std::cout << body.mesh.number_of_faces() << " faces, volume " << body.validity.volume << "\n";
  write_mesh(argc > 2 ? argv[2] : "quadrics.off", body.mesh);

  if (const auto surface = fit_bspline(*result.blend, 1e-5))
    std::cout << "B-spline surface of " << surface->knots.size() << " knots, error " << surface->error << "\n";
}
