// SPDX-License-Identifier: GPL-3.0-or-later
#include "job.h"

#include "curvature_picture.h"
#include "failure.h"
#include "paths.h"
#include "progress.h"

#include <cgal_blend/mesh_io.h>
#include <cgal_blend/validate.h>

#include <algorithm>
#include <iostream>
#include <new>
#include <utility>

namespace cgal_blend::cli {

namespace {

Failure from_mesh_io(const Mesh_io_error& error) {
  using Kind = Mesh_io_error::Kind;
  switch (error.kind) {
    case Kind::bad_mesh: return {Exit::input, name(error.diagnosis.status), error.what()};
    case Kind::unwritable: return {Exit::usage, "output_unwritable", error.what()};
    case Kind::unreadable:
    case Kind::unknown_format: break;
  }
  return {Exit::input, "input_unreadable", error.what()};
}

// Runs the body; whatever goes wrong in it comes back as a failure.
std::optional<Failure> attempt(const std::function<void()>& body) {
  try {
    body();
    return std::nullopt;
  } catch (const Failure& failure) {
    return failure;
  } catch (const Mesh_io_error& error) {
    return from_mesh_io(error);
  } catch (const std::bad_alloc&) {
    return Failure(Exit::blend, "out_of_memory", "there is not enough memory for this operation");
  } catch (const std::exception& error) {
    return Failure(Exit::result, "internal_error", std::string("this is a defect of the program: ") + error.what());
  }
}

std::string one_line(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

std::string success_message(const std::vector<Blend_report>& blends) {
  const auto is_sharp = [](const Blend_report& blend) { return !blend.diagnosis.ok(); };
  const auto sharp = std::count_if(blends.begin(), blends.end(), is_sharp);
  if (sharp == 0) return describe(Status::ok);
  return std::to_string(sharp) + " of " + std::to_string(blends.size()) +
         " curves could not be blended and were left sharp";
}

std::string flat_ends(const Blend_report& blend) {
  if (blend.flat_ends == 0) return "";
  return blend.flat_ends == 1 ? ", 1 flat end" : ", 2 flat ends";
}

void print_summary(const Fillet_outcome& outcome, const Blend_mesh& mesh, const std::string& file,
                   const Flaw_counts& flaws) {
  std::cout << file << ": " << mesh.number_of_vertices() << " vertices, " << mesh.number_of_faces()
            << " faces, closed, manifold, ";
  if (flaws.any())
    std::cout << "flaws of the input left as they were (" << flaws.self_intersections << " self-intersections, "
              << flaws.degenerate_faces << " degenerate faces, " << flaws.short_edges << " short edges)";
  else
    std::cout << "no self-intersections";
  std::cout << "; volume " << outcome.volume << ", area " << outcome.area << "\n";
  for (std::size_t i = 0; i < outcome.blends.size(); ++i) {
    const Blend_report& blend = outcome.blends[i];
    std::cout << "  blend " << i + 1 << ": " << (blend.convex ? "convex" : "concave") << " curve of " << blend.edges
              << " edges, ";
    if (blend.diagnosis.ok())
      std::cout << "radius " << blend.radius << " within " << 100 * blend.radius_error << " %, tangent within "
                << blend.tangency_deg << " degrees" << flat_ends(blend) << "\n";
    else
      std::cout << "left sharp: " << message(blend.diagnosis) << "\n";
  }
}

}  // namespace

int run_job(const std::string& command, const Output_options& output, const std::vector<std::string>& inputs,
            const std::function<void(Report&)>& body) {
  Report report;
  report.command = command;
  std::string report_path;  // stays empty, and nothing is written there, if it turns out to be no place for a report
  std::optional<Failure> failure = attempt([&] {
    check_report_path(output, inputs);
    report_path = output.report;
    check_mesh_path(output);
    check_curvature_path(output, inputs);
    body(report);
  });
  if (failure) {
    report.status = failure->status;
    report.message = one_line(failure->what());
  }
  if (!report_path.empty() && !write_report(report, report_path) && !failure)
    failure = Failure(Exit::usage, "output_unwritable", "cannot write the report " + in_quotes(report_path));
  if (!failure) return 0;
  std::cerr << "cgal-blend: " << one_line(failure->what()) << std::endl;
  return static_cast<int>(failure->exit);
}

Blend_mesh read_placed(const std::string& path, Json& entry, Report& report, const Transform& placement) {
  const Timer timer(report.read);
  Blend_mesh mesh = read_mesh(path);
  apply(placement, mesh);
  entry = input_json(path, mesh);
  return mesh;
}

Blend_mesh read_operand(const std::string& path, Json& entry, Report& report, const Transform& placement,
                        std::vector<Flaw>* flaws) {
  Blend_mesh mesh = read_placed(path, entry, report, placement);
  const Timer timer(report.check_input);
  Validity_report validity = validate(mesh, flaws ? Flaw_policy::accept : Flaw_policy::refuse);
  if (flaws) {
    report.accepted = {validity.self_intersections, validity.degenerate_faces, validity.short_edges};
    add_flaws(report.accepted, entry);
    *flaws = std::move(validity.flaws);
  }
  if (!validity.ok()) throw Failure(validity.diagnosis, in_quotes(path));
  return mesh;
}

void blend_and_write(const std::function<Fillet_outcome(Blend_mesh&, const Fillet_options&)>& engine,
                     const Fillet_options& options, const Output_options& output, Report& report) {
  Blend_mesh mesh;
  Fillet_outcome outcome;
  {
    Progress_line line(!output.quiet);
    Fillet_options with_progress = options;
    with_progress.progress = [&line](double fraction) {
      line.show(fraction);
      return true;
    };
    outcome = engine(mesh, with_progress);
  }
  report.stages = outcome.times;
  report.blends = blends_json(outcome.blends);
  if (!outcome.ok()) throw Failure(outcome.diagnosis);
  {
    const Timer timer(report.write);
    write_mesh(output.mesh, mesh);
    if (!output.curvature.empty()) report.curvature = write_curvature_picture(output.curvature, mesh);
  }
  report.output = output_json(output.mesh, mesh, outcome);
  if (report.accepted.any()) add_flaws(report.accepted, report.output);
  report.message = success_message(outcome.blends);
  if (output.summary()) print_summary(outcome, mesh, output.mesh, report.accepted);
}

}  // namespace cgal_blend::cli
