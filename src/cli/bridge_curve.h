// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_BRIDGE_CURVE_H
#define CGAL_BLEND_CLI_BRIDGE_CURVE_H

#include <cgal_blend/polar_curve.h>

#include <optional>
#include <string>

namespace cgal_blend::cli {

/// Returns the contact curve that `text` spells: circle, ellipse:A,B, rect:A,B[,CORNER], star:DEPTH,ARMS,
/// cross:A,B[,CORNER], or a file of lines "ANGLE DISTANCE", degrees and length units, for a smooth curve through these
/// points. Circle and star take the radius. Throws `Failure` (usage; input for a file); `subject` begins the message.
[[nodiscard]] Polar_curve parse_curve(const std::string& text, std::optional<double> radius,
                                      const std::string& subject);

}  // namespace cgal_blend::cli

#endif
