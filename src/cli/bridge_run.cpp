// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge_run.h"

#include "failure.h"

#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <fstream>
#include <utility>

namespace cgal_blend::cli {

namespace {

using Label = Bridged_mesh::Label;

class Bridge_run {
 public:
  Bridge_run(const Bridge_scene& scene, Report& report) : scene_(scene), report_(report) {
    std::vector<const Blend_mesh*> first;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      if (is_crossing(i)) continue;
      first.push_back(&scene.bodies[i]);
      add_labels(i);
    }
    if (first.empty()) throw Failure(Exit::input, "input_unreadable", "no body is there before the first bridge");
    result_.mesh = unchecked::put_together(first);
    if (fills_holes() && !CGAL::is_closed(result_.mesh)) fill();
  }

  Bridged_mesh run() {
    for (Bridge_step step : scene_.steps) {
      if (filled_) unchecked::move_spots_to_fillings(*filled_, step.bridge.ends);
      spots_.insert(spots_.end(), step.bridge.ends.begin(), step.bridge.ends.end());
      Blend_mesh next;
      std::optional<Drag> drag;
      const Bridge_outcome outcome = step.crossing ? cross(step, next) : join(step, next, drag);
      report_.stages.blend += outcome.times.parametrize + outcome.times.trim;
      report_.stages.validate += outcome.times.validate;
      add_reports(outcome, step, drag);
      if (!outcome.ok()) throw Failure(outcome.diagnosis, scene_.steps.size() > 1 ? step.where : "");
      relabel(outcome);
      result_.mesh = std::move(next);
      result_.volume = outcome.volume;
      result_.area = outcome.area;
    }
    if (filled_) check_fillings();
    return std::move(result_);
  }

 private:
  [[nodiscard]] bool fills_holes() const {
    return std::any_of(scene_.steps.begin(), scene_.steps.end(),
                       [](const Bridge_step& step) { return step.bridge.options.fill_holes; });
  }

  void fill() {
    filled_ = fill_mesh(result_.mesh);
    if (!filled_->diagnosis.ok()) throw Failure(filled_->diagnosis);
    result_.mesh = filled_->mesh;
    for (std::size_t f = 0; f < result_.mesh.number_of_faces(); ++f) origins_.push_back(static_cast<std::uint32_t>(f));
    result_.labels.resize(origins_.size());
  }

  void check_fillings() const {
    const Diagnosis left = unchecked::check_fillings(*filled_, origins_, spots_);
    if (!left.ok()) throw Failure(left);
  }

  [[nodiscard]] bool is_crossing(std::size_t body) const {
    return std::any_of(scene_.steps.begin(), scene_.steps.end(),
                       [&](const Bridge_step& step) { return step.crossing == body; });
  }

  void add_labels(std::size_t body) {
    result_.labels.insert(result_.labels.end(), scene_.bodies[body].number_of_faces(), Label{false, body, true});
  }

  Bridge_outcome cross(const Bridge_step& step, Blend_mesh& next) {
    add_labels(*step.crossing);
    return unchecked::bridge_intersection(result_.mesh, scene_.bodies[*step.crossing], step.bridge.ends, next,
                                          step.bridge.options);
  }

  Bridge_outcome join(const Bridge_step& step, Blend_mesh& next, std::optional<Drag>& drag) const {
    Bridge_solver solver(result_.mesh, step.bridge.ends, step.bridge.options);
    if (step.drag && solver.diagnosis().ok()) drag = solver.drag(step.drag->s, step.drag->t, step.drag->target);
    return solver.build(next);
  }

  void relabel(const Bridge_outcome& outcome) {
    std::vector<Label> labels;
    std::vector<std::uint32_t> origins;
    for (std::size_t f = 0; f < outcome.origins.size(); ++f) {
      Label label{true, 0, false};
      if (outcome.origins[f] != no_origin) {
        label = result_.labels[outcome.origins[f]];
        label.kept = label.kept && f < outcome.kept_faces;
      }
      labels.push_back(label);
      const bool is_filled = outcome.origins[f] < origins_.size();
      origins.push_back(is_filled ? origins_[outcome.origins[f]] : no_origin);
    }
    origins_ = std::move(origins);
    for (const auto& faces : outcome.bridge_faces) {
      for (const Face f : faces) labels[f.idx()].index = bridges_;
      ++bridges_;
    }
    result_.labels = std::move(labels);
  }

  void add_reports(const Bridge_outcome& outcome, const Bridge_step& step, const std::optional<Drag>& drag) {
    for (std::size_t k = 0; k < outcome.bridges.size(); ++k) {
      const Bridge_report& bridge = outcome.bridges[k];
      Json json = {{"status", name(bridge.diagnosis.status)},
                   {"message", message(bridge.diagnosis)},
                   {"segments", bridge.segments},
                   {"rows", bridge.rows},
                   {"faces", k < outcome.bridge_faces.size() ? outcome.bridge_faces[k].size() : 0},
                   {"lambda", bridge.lambda},
                   {"mu", step.bridge.options.mu},
                   {"order", step.bridge.options.order},
                   {"turn_deg", bridge.turn_deg},
                   {"tangency_deg", bridge.tangency_deg},
                   {"safe_radius", bridge.safe_radius}};
      if (drag) json["drag"] = {{"reached", drag->reached}, {"residual", drag->residual}};
      report_.blends.push_back(std::move(json));
    }
  }

  const Bridge_scene& scene_;
  Report& report_;
  Bridged_mesh result_;
  std::size_t bridges_ = 0;             // made so far
  std::optional<Filled_mesh> filled_;   // if there are holes
  std::vector<std::uint32_t> origins_;  // faces of the filled mesh, per face
  std::vector<Bridge_end> spots_;
};

}  // namespace

Bridged_mesh make_bridges(const Bridge_scene& scene, Report& report) { return Bridge_run(scene, report).run(); }

void write_bridge_labels(const std::string& path, const Bridge_scene& scene, const Bridged_mesh& bridged) {
  std::ofstream out(path, std::ios::binary);
  for (const Label& label : bridged.labels)
    if (label.is_bridge)
      out << "bridge " << label.index + 1 << '\n';
    else
      out << "body " << scene.names[label.index] << '\n';
  if (!out.flush()) throw Failure(Exit::usage, "output_unwritable", "cannot write " + in_quotes(path));
}

}  // namespace cgal_blend::cli
