// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/fuse.h>

#include "fuse_assembly.h"
#include "fuse_frame.h"
#include "fuse_sides.h"
#include "hermite_transition.h"
#include "number_text.h"
#include "slab_tessellation.h"
#include "stopwatch.h"

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <string>
#include <utility>

namespace cgal_blend {

namespace {

Diagnosis wrong(const char* what) { return {Status::invalid_parameter, what, std::nullopt, std::nullopt}; }

bool within(double value, double low, double high) { return value >= low && value <= high; }

Diagnosis check_options(const Fuse_options& options) {
  for (const double value : options.eta)
    if (!within(value, 0, 1)) return wrong("control values of eta must lie between 0 and 1");
  for (const double value : options.weight)
    if (!within(value, 1e-6, 1e6)) return wrong("weights of the sides must lie between 1e-6 and 1e6");
  if (!within(options.step, 1e-3, 100))
    return wrong("step of the sections must lie between 0.001 and 100 edges of the rings");
  if (!(options.edge >= 0) || !std::isfinite(options.edge)) return wrong("edge length must be a positive number");
  if (!within(options.grading, 1, 100)) return wrong("grading must lie between 1 and 100");
  if (!within(options.least_angle, 0, 30)) return wrong("least angle must lie between 0 and 30 degrees");
  return {};
}

Diagnosis check_side(const Fusion_side& side) {
  if (side.meshes.empty()) return wrong("each side of a fusion needs a mesh");
  return side.plane ? check(*side.plane) : Diagnosis{};
}

const char* side_name(std::size_t i) { return i == 0 ? "lower side" : "upper side"; }

/// Meshes with holes must leave their plane downwards: nothing has been cut off.
Diagnosis check_below(const Fuse_side& side) {
  if (side.cut) return {};
  for (const Fuse_part& part : side.parts) {
    const auto height = [&](Vertex v) { return (part.mesh->point(v) - side.plane.point) * side.plane.normal; };
    for (const auto& ring : part.cut.rings)
      for (const std::size_t i : ring)
        for (const Vertex v : vertices_around_target(part.mesh->halfedge(part.cut.vertices[i]), *part.mesh))
          if (height(v) > planar_hole * side.mean_edge * static_cast<double>(ring.size()))
            return {Status::sides_interpenetrate,
                    "a mesh rises above its own opening, or is inside out",
                    part.mesh->point(v),
                    {}};
  }
  return {};
}

// A transition of more facets than this is a mistyped edge length: it would take hours and all memory.
constexpr double most_facets = 5e6;

/// Refuses an edge length that makes too many facets: of equilateral triangles on a cylinder as wide as the wider side.
Diagnosis check_edge(double edge, const std::array<Fuse_side, 2>& sides, double height) {
  double around = 0;
  for (const Fuse_side& side : sides) {
    double length = 0;
    for (const Section_loop& loop : side.points) length += side.mean_edge * static_cast<double>(loop.size());
    around = std::max(around, length);
  }
  const double least = std::sqrt(around * height / most_facets * 4 / std::sqrt(3.0));
  if (edge == 0 || edge >= least) return {};
  return {Status::invalid_parameter,
          "edges this short would make millions of facets; at least " + number_text(least),
          {},
          {}};
}

/// One fusion from the cut to the check.
class Fusion {
 public:
  Fusion(const Fusion_side& lower, const Fusion_side& upper, const Fuse_options& options)
      : given_{&lower, &upper}, options_(options) {}

  Fuse_outcome run(Blend_mesh& out) {
    outcome_.diagnosis = check_options(options_);
    for (const Fusion_side* side : given_)
      if (outcome_.ok()) outcome_.diagnosis = check_side(*side);
    if (!outcome_.ok()) return outcome_;
    // Where collapsed edges made a ring cross something, it is taken as it was cut.
    std::array<bool, 2> tried{};
    do {
      tried = tidy_;
      outcome_.diagnosis = {};
      attempt(out);
    } while (tidy_ != tried);
    return outcome_;
  }

 private:
  bool go_on(double fraction) {
    if (options_.progress && !options_.progress(fraction)) outcome_.diagnosis.status = Status::cancelled;
    return outcome_.ok();
  }

  void attempt(Blend_mesh& out);
  bool open();
  bool make_sections(const Fuse_frame& frame, std::array<Opening_sections, 2>& sections);
  Slab_tessellation tessellate(const std::array<Opening_sections, 2>& sections, double height);
  bool place(const Fuse_frame& frame, const Slab_tessellation& slab, std::vector<Point_3>& inner);
  void join(const Fuse_frame& frame, Blend_mesh& out);

  std::array<const Fusion_side*, 2> given_;
  const Fuse_options& options_;
  Fuse_outcome outcome_;
  std::array<Fuse_side, 2> sides_;
  std::array<bool, 2> tidy_{true, true};  // whether short edges of rings are collapsed
  std::size_t side_vertices_ = 0;
};

void Fusion::attempt(Blend_mesh& out) {
  if (!open() || !go_on(0.1)) return;
  const Fuse_frame frame(sides_[0].plane, sides_[1].plane);
  outcome_.angle = frame.angle() * 180 / CGAL_PI;
  outcome_.height = frame.height();
  outcome_.diagnosis = frame.diagnosis();
  if (outcome_.ok()) join(frame, out);
}

bool Fusion::open() {
  const Stopwatch watch;
  for (const std::size_t i : {0, 1}) {
    sides_[i] = open_side(*given_[i], tidy_[i]);
    outcome_.diagnosis = sides_[i].diagnosis;
    if (outcome_.ok()) outcome_.diagnosis = check_below(sides_[i]);
    if (!outcome_.ok()) {
      put_before(outcome_.diagnosis, side_name(i));
      return false;
    }
    outcome_.rings[i] = sides_[i].points.size();
    add_shifted_sections(sides_[i], options_.step);
  }
  side_vertices_ = number_vertices(sides_);
  outcome_.times.cut = watch.milliseconds();
  return true;
}

bool Fusion::make_sections(const Fuse_frame& frame, std::array<Opening_sections, 2>& sections) {
  for (const std::size_t i : {0, 1}) {
    sections[i] = sections_in_frame(sides_[i], i, frame);
    outcome_.diagnosis = check_rings(sides_[i], sections[i], i == 1);
    if (outcome_.ok()) continue;
    if (outcome_.diagnosis.status == Status::openings_overlap) tidy_[i] = !sides_[i].cut;
    put_before(outcome_.diagnosis, side_name(i));
    return false;
  }
  return true;
}

Slab_tessellation Fusion::tessellate(const std::array<Opening_sections, 2>& sections, double height) {
  Stopwatch watch;
  const Hermite_transition psi(sections, height, {options_.model, options_.eta, options_.weight});
  outcome_.one_sided = {psi.one_sided(0), psi.one_sided(1)};
  outcome_.times.openings = watch.milliseconds();
  watch = Stopwatch();
  Slab_options slab;
  slab.edge = options_.edge;
  slab.grading = options_.grading;
  slab.least_angle = options_.least_angle;
  if (options_.progress) slab.progress = [this](double x) { return options_.progress(0.2 + 0.6 * x); };
  Slab_tessellation result = tessellate_slab(psi, slab);
  outcome_.times.tessellate = watch.milliseconds();
  return result;
}

/// Places the transition, in space; false if it folds.
bool Fusion::place(const Fuse_frame& frame, const Slab_tessellation& slab, std::vector<Point_3>& inner) {
  const std::vector<Point_3>& all = slab.points;
  std::function<Point_3(const Point_3&)> placed = [&](const Point_3& p) { return frame.from_frame(p); };
  if (std::any_of(all.begin(), all.end(), [&](const Point_3& p) { return frame.is_tight(p); })) {
    Paced_bend bend(frame.ends(), all);
    const auto fold = bend.fold();
    if (fold && std::any_of(all.begin(), all.end(), [&](const Point_3& p) { return frame.folds(p); })) {
      const char* detail = "the way from the one opening to the other is too tight; move the sides apart";
      outcome_.diagnosis = {Status::blend_folds, detail, bend(*fold), {}};
      return false;
    }
    if (!fold) placed = std::move(bend);
  }
  std::size_t first = 0;
  for (const Fuse_side& side : sides_)
    for (const auto& ring : side.rings) first += ring.size();
  std::transform(all.begin() + static_cast<std::ptrdiff_t>(first), all.end(), std::back_inserter(inner), placed);
  return true;
}

void Fusion::join(const Fuse_frame& frame, Blend_mesh& out) {
  std::array<Opening_sections, 2> sections;
  if (!make_sections(frame, sections) || !go_on(0.2)) return;
  outcome_.diagnosis = check_edge(options_.edge, sides_, frame.height());
  if (!outcome_.ok()) return;
  const Slab_tessellation slab = tessellate(sections, frame.height());
  outcome_.diagnosis = slab.diagnosis;
  if (outcome_.diagnosis.point) outcome_.diagnosis.point = frame.from_frame(*outcome_.diagnosis.point);
  std::vector<Point_3> inner;
  if (!outcome_.ok() || !place(frame, slab, inner) || !go_on(0.8)) return;
  Stopwatch watch;
  Fused_mesh fused = sew(sides_, side_vertices_, slab, inner);
  outcome_.times.assemble = watch.milliseconds();
  outcome_.diagnosis = fused.diagnosis;
  if (!outcome_.ok() || !go_on(0.9)) return;
  watch = Stopwatch();
  finish(sides_, fused, frame.is_bent(), outcome_);
  outcome_.times.validate = watch.milliseconds();
  if (outcome_.ok()) out = std::move(fused.mesh);
}

}  // namespace

namespace unchecked {

Fuse_outcome fuse(const Fusion_side& lower, const Fusion_side& upper, Blend_mesh& out, const Fuse_options& options) {
  return Fusion(lower, upper, options).run(out);
}

}  // namespace unchecked

}  // namespace cgal_blend
