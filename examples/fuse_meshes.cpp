// SPDX-License-Identifier: GPL-3.0-or-later
// Joins a pillar to two bent legs: one opening above, two below, in planes that are not parallel.
//   fuse_meshes [DEGREES [OUT.off]]
#include <cgal_blend/fuse.h>
#include <cgal_blend/mesh_io.h>

#include <CGAL/Aff_transformation_3.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

using namespace cgal_blend;

// A closed prism over a regular polygon, with a ring of vertices every unit of height.
Blend_mesh pillar(double radius, int sides, int height, const Vector_3& at) {
  Blend_mesh mesh;
  const auto ring = [&](double r, double z) {
    std::vector<Vertex> vertices;
    for (int i = 0; i < (r > 0 ? sides : 1); ++i) {
      const double angle = 2 * CGAL_PI * i / sides;
      vertices.push_back(mesh.add_vertex(Point_3(r * std::cos(angle), r * std::sin(angle), z) + at));
    }
    return vertices;
  };
  std::vector<std::vector<Vertex>> rings{ring(0, 0)};
  for (int z = 0; z <= height; ++z) rings.push_back(ring(radius, z));
  rings.push_back(ring(0, height));
  for (std::size_t k = 0; k + 1 < rings.size(); ++k)
    for (int i = 0; i < sides; ++i) {
      const auto corner = [&](std::size_t r, int j) { return rings[r][j % rings[r].size()]; };
      if (k > 0) mesh.add_face(corner(k, i), corner(k, i + 1), corner(k + 1, i));
      if (k + 2 < rings.size()) mesh.add_face(corner(k, i + 1), corner(k + 1, i + 1), corner(k + 1, i));
    }
  return mesh;
}

int main(int argc, char** argv) {
  const double angle = (argc > 1 ? std::atof(argv[1]) : 40) * CGAL_PI / 180, c = std::cos(angle), s = std::sin(angle);
  const Blend_mesh left = pillar(1, 40, 4, {-1.3, 0, 0}), right = pillar(1, 40, 4, {1.3, 0, 0});

  // The upper pillar, turned about an axis along x at a distance of 5: the transition follows an arc of that radius.
  Blend_mesh top = pillar(1.5, 60, 4, {0, 0, 0});
  const CGAL::Aff_transformation_3<Kernel> place(1, 0, 0, 0, 0, c, -s, 5 * (c - 1) + 0.5 * s, 0, s, c,
                                                 2.5 + 5 * s - 0.5 * c);
  for (const Vertex v : top.vertices()) top.point(v) = place.transform(top.point(v));

  const Fusion_side lower{{&left, &right}, Cut_plane{{0, 0, 2.5}, {0, 0, 1}}};
  const Fusion_side upper{{&top}, Cut_plane{place.transform(Point_3(0, 0, 0.5)), place.transform(Vector_3(0, 0, -1))}};

  Fuse_options options;
  options.model = rbf_opening();
  options.grading = 2;
  Blend_mesh out;
  const auto result = fuse(lower, upper, out, options);
  if (!result.ok()) {
    std::cerr << message(result.diagnosis) << "\n";  // for example: the planes are too steep
    return EXIT_FAILURE;
  }
  std::cout << result.rings[0] << " rings below, " << result.rings[1] << " above, " << result.transition_faces.size()
            << " faces between them, tangent within " << result.tangency_max << " degrees, volume " << result.volume
            << "\n";
  write_mesh(argc > 2 ? argv[2] : "fused.off", out);
}
