// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene_surface.h"

#include "failure.h"

#include <cgal_blend/boundary_models.h>
#include <cgal_blend/mesh_boundary.h>
#include <cgal_blend/mesh_io.h>
#include <cgal_blend/quadric_intersection.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <stdexcept>

namespace cgal_blend::cli {

namespace {

[[noreturn]] void refuse(Status status, const Scene_value& where, const std::string& detail) {
  throw Failure(Diagnosis{status, detail, {}, {}}, where.where());
}

Quadric_3 read_quadric(const Scene_value& json) {
  Quadric_3::Coefficients coefficients;
  const auto values = json.rationals(10);
  std::copy(values.begin(), values.end(), coefficients.begin());
  if (std::all_of(values.begin(), values.end(), [](const auto& x) { return x == 0; }))
    json.refuse("all coefficients are 0");
  return Quadric_3(coefficients);
}

Far_plane read_plane(const Scene_value& json) {
  const auto v = json.rationals(4);
  if (v[0] == 0 && v[1] == 0 && v[2] == 0) json.refuse("the plane has no normal");
  return {v[0], v[1], v[2], v[3]};
}

std::vector<Far_plane> read_far(const Scene_value& json) {
  std::vector<Far_plane> planes;
  if (!json.has("far")) return planes;
  for (const Scene_value& item : json["far"].list()) planes.push_back(read_plane(item));
  return planes;
}

Quadric_intersection cut(const Quadric_3& quadric, const Scene_value& side) {
  Intersection_options options;
  if (side.has("box")) options.box = side["box"].number();
  if (!(options.box > 0)) side["box"].refuse("must be greater than 0");
  try {
    return side.has("plane") ? intersect(quadric, read_plane(side["plane"]), options)
                             : intersect_quadrics(quadric, read_quadric(side["cutter"]), options);
  } catch (const std::range_error& error) {
    refuse(Status::not_supported, side, std::string("too nearly degenerate: ") + error.what());
  }
}

double squared_distance(const Intersection_curve& curve, const Point_3& p) {
  double least = std::numeric_limits<double>::infinity();
  for (const Point_3& q : curve.sample(64)) least = std::min(least, CGAL::squared_distance(p, q));
  return least;
}

Intersection_curve choose(const std::vector<Intersection_curve>& curves, const Scene_value& side) {
  if (side.has("component")) {
    const std::size_t i = side["component"].index();
    if (i >= curves.size())
      refuse(Status::no_boundary_curve, side, "there are " + std::to_string(curves.size()) + " curves only");
    return curves[i];
  }
  if (side.has("near")) {
    const Point_3 p = side["near"].point();
    return *std::min_element(curves.begin(), curves.end(), [&](const auto& a, const auto& b) {
      return squared_distance(a, p) < squared_distance(b, p);
    });
  }
  if (curves.size() > 1)
    refuse(Status::no_boundary_curve, side,
           "there are " + std::to_string(curves.size()) + " curves; choose one with 'near' or 'component'");
  return curves.front();
}

Scene_curve read_quadric_curve(const Quadric_3& quadric, const Scene_value& side) {
  side.allow({"surface", "plane", "cutter", "component", "near", "box"});
  if (side.has("plane") == side.has("cutter")) side.refuse("needs either 'plane' or 'cutter'");
  const Quadric_intersection section = cut(quadric, side);
  if (section.status == Intersection_status::surface)
    refuse(Status::operands_identical, side, "they share a surface, and no curve cuts it off");
  std::vector<Intersection_curve> curves;
  for (const Intersection_curve& curve : section.components)
    if (!curve.is_isolated()) curves.push_back(curve);
  if (curves.empty()) refuse(Status::no_boundary_curve, side, "the surfaces do not meet in a curve");
  return {Implicit_boundary(implicit_function(quadric), space_curve_of(choose(curves, side))), 0};
}

Scene_surface read_quadric_surface(const Scene_value& json) {
  json.allow({"quadric", "far", "swept"});
  const Quadric_3 quadric = read_quadric(json["quadric"]);
  const auto far = read_far(json);
  Scene_surface surface{trimmed_quadric(quadric, far),
                        [quadric](const Scene_value& side) { return read_quadric_curve(quadric, side); }};
  if (!json.has("swept") || !json["swept"].boolean()) return surface;
  if (far.size() != 1) json.refuse("a swept surface needs one far plane");
  surface.trimmed = swept_surface(implicit_function(quadric), far[0]);
  return surface;
}

Space_curve read_space_curve(const Scene_value& side) {
  side.allow({"surface", "curve", "closed"});
  const auto formulas = side["curve"].formulas(3, {"s"});
  const auto f = [formulas](const auto& s) {
    using T = std::decay_t<decltype(s)>;
    const std::array<T, 1> values{s};
    return std::array<T, 3>{formulas[0](values), formulas[1](values), formulas[2](values)};
  };
  return space_curve(f, side.has("closed") && side["closed"].boolean());
}

constexpr double curve_on_surface = 1e-9;  // largest distance, of the curve's coordinates

Scene_curve read_implicit_curve(const Implicit_function& function, const Scene_value& side) {
  const Space_curve curve = read_space_curve(side);
  for (int i = 0; i <= 64; ++i) {
    const Point_3 p = curve.at(i / 64.0).point;
    const double size = std::max({1e-300, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
    const double slope = std::sqrt(function.gradient(p).squared_length());
    if (std::abs(function.value(p)) > curve_on_surface * size * slope)
      refuse(Status::no_boundary_curve, side, "the curve does not lie on the surface");
  }
  return {Implicit_boundary(function, curve), 0};
}

Scene_surface read_implicit_surface(const Scene_value& json) {
  json.allow({"implicit", "far"});
  const Expression formula = json["implicit"].formula({"x", "y", "z"});
  const Implicit_function function = implicit_function([formula](const auto& x, const auto& y, const auto& z) {
    return formula(std::array<std::decay_t<decltype(x)>, 3>{x, y, z});
  });
  const auto far = read_far(json);
  if (far.size() != 1) json.refuse("an implicit surface needs one far plane");
  return {swept_surface(function, far[0]),
          [function](const Scene_value& side) { return read_implicit_curve(function, side); }};
}

Scene_surface patch_surface(const Parametric_patch& patch) {
  return {trimmed_patch(patch), [patch](const Scene_value& side) {
            side.allow({"surface", "end"});
            const std::string end = side["end"].text();
            if (end != "start" && end != "end") side["end"].refuse("must be \"start\" or \"end\"");
            const bool first = end == "start";
            return Scene_curve{Iso_curve_boundary(patch, first ? patch.v0 : patch.v1), first ? 0 : 1};
          }};
}

Scene_surface read_patch(const Scene_value& json) {
  json.allow({"patch", "domain", "closed"});
  const auto formulas = json["patch"].formulas(3, {"u", "v"});
  const auto domain = json["domain"].list(4);
  const std::array<double, 4> d{domain[0].number(), domain[1].number(), domain[2].number(), domain[3].number()};
  if (!(d[0] < d[1] && d[2] < d[3])) json["domain"].refuse("must be [u0, u1, v0, v1] with u0 < u1 and v0 < v1");
  const auto f = [formulas](const auto& u, const auto& v) {
    using T = std::decay_t<decltype(u)>;
    const std::array<T, 2> values{u, v};
    return std::array<T, 3>{formulas[0](values), formulas[1](values), formulas[2](values)};
  };
  return patch_surface(parametric_patch(f, d, json.has("closed") && json["closed"].boolean()));
}

Vector_3 unit(const Scene_value& json) {
  const Vector_3 v = json.vector();
  if (!(v.squared_length() > 0)) json.refuse("must not be 0");
  return v / std::sqrt(v.squared_length());
}

Scene_surface read_torus(const Scene_value& json) {
  json.allow({"centre", "axis", "start", "radii", "angles"});
  const Vector_3 axis = unit(json["axis"]), given = unit(json["start"]);
  const Vector_3 across = given - (given * axis) * axis;
  if (!(across.squared_length() > 1e-12)) json["start"].refuse("must not be along the axis");
  const Vector_3 e1 = across / std::sqrt(across.squared_length());
  const auto radii = json["radii"].list(2), angles = json["angles"].list(2);
  const double major = radii[0].number(), minor = radii[1].number();
  const double from = angles[0].number() * CGAL_PI / 180, to = angles[1].number() * CGAL_PI / 180;
  if (!(0 < minor && minor < major)) json["radii"].refuse("must be the large and the small radius");
  if (!(from < to && to - from < 2 * CGAL_PI)) json["angles"].refuse("must ascend, by less than 360 degrees");
  return patch_surface(
      torus_patch(json["centre"].point(), {e1, CGAL::cross_product(axis, e1), axis}, major, minor, from, to));
}

Scene_surface read_ringed(const Scene_value& json) {
  json.allow({"ringed", "radius", "up", "domain"});
  const auto centre = json["ringed"].formulas(3, {"t"});
  const Expression radius = json["radius"].formula({"t", "u"});
  const auto domain = json["domain"].list(2);
  const double from = domain[0].number(), to = domain[1].number();
  if (!(from < to)) json["domain"].refuse("must be [t0, t1] with t0 < t1");
  const auto c = [centre](const auto& t) {
    using T = std::decay_t<decltype(t)>;
    const std::array<T, 1> values{t};
    return std::array<T, 3>{centre[0](values), centre[1](values), centre[2](values)};
  };
  const auto r = [radius](const auto& t, const auto& u) {
    return radius(std::array<std::decay_t<decltype(t)>, 2>{t, u});
  };
  return patch_surface(ringed_patch(c, r, json.has("up") ? unit(json["up"]) : Vector_3(0, 0, 1), from, to));
}

std::vector<Vertex> read_chain(const Scene_value& json, const Blend_mesh& mesh) {
  std::vector<Vertex> chain;
  const auto vertex = [&](const Scene_value& item) {
    const std::size_t i = item.index();
    if (i >= mesh.number_of_vertices()) item.refuse("the mesh has no such vertex");
    return Vertex(static_cast<Blend_mesh::size_type>(i));
  };
  if (json.has("border")) {
    chain = border_chain(mesh, vertex(json["border"]));
    if (chain.empty()) refuse(Status::no_boundary_curve, json, "the vertex lies on no border");
    return chain;
  }
  for (const Scene_value& item : json["chain"].list()) chain.push_back(vertex(item));
  if (chain.size() < 3) json["chain"].refuse("needs three vertices or more");
  for (std::size_t i = 0; i < chain.size(); ++i) {
    const Halfedge h = mesh.halfedge(chain[i], chain[(i + 1) % chain.size()]);
    if (h == Blend_mesh::null_halfedge() || mesh.is_border(h))
      refuse(Status::no_such_edge, json["chain"],
             "after place " + std::to_string(i + 1) + " there is no edge with a face on its left");
  }
  return chain;
}

Scene_surface read_mesh_surface(const Scene_value& json, const std::string& folder) {
  json.allow({"mesh", "chain", "border"});
  const Blend_mesh mesh = read_mesh((std::filesystem::path(folder) / json["mesh"].text()).string());
  const std::vector<Vertex> chain = read_chain(json, mesh);
  return {trimmed_mesh(mesh, {chain}), [mesh, chain](const Scene_value& side) {
            side.allow({"surface"});
            return Scene_curve{Mesh_boundary(mesh, chain), 0};
          }};
}

}  // namespace

Scene_surface read_scene_surface(const Scene_value& json, const std::string& folder) {
  if (json.has("quadric")) return read_quadric_surface(json);
  if (json.has("implicit")) return read_implicit_surface(json);
  if (json.has("patch")) return read_patch(json);
  if (json.has("torus")) return read_torus(json["torus"]);
  if (json.has("ringed")) return read_ringed(json);
  if (json.has("mesh")) return read_mesh_surface(json, folder);
  json.refuse("must have one of 'quadric', 'implicit', 'patch', 'torus', 'ringed' and 'mesh'");
}

}  // namespace cgal_blend::cli
