// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_CLI_VALUES_H
#define CGAL_BLEND_CLI_VALUES_H

#include <cgal_blend/fillet.h>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cgal_blend::cli {

/// Returns the finite number that `text` as a whole spells, whatever the locale; nothing otherwise.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// Returns the parts of `text` between any of the `separators`; empty parts are kept if `keep_empty`.
[[nodiscard]] std::vector<std::string> split(const std::string& text, const char* separators, bool keep_empty);

/// Returns the radius that `text` spells: a number > 0, or a list FRACTION:RADIUS,FRACTION:RADIUS,... Throws `Failure`
/// (usage) for anything else.
[[nodiscard]] Radius_law parse_radius(const std::string& text);

/// Returns one radius for each of `count` booleans: `text` spells one for all, or numbers with commas. Throws `Failure`
/// (usage) as `parse_radius`, and for numbers of another count.
[[nodiscard]] std::vector<Radius_law> parse_radii(const std::string& text, std::size_t count);

/// Returns the smooth law through pairs of fraction and radius; throws `Failure` (usage) if they make none. `subject`
/// begins the message.
[[nodiscard]] Radius_law make_law(const std::vector<Piecewise_radius::Pair>& pairs, const std::string& subject);

/// Throws `Failure` unless the radius is a finite number > 0; `subject` begins the message.
void require_radius(double radius, const std::string& subject);

/// Returns the profile that `text` spells: arc, chamfer, conic:W0, sharp, g2, hermite[:M1,M2], bspline:X,Y;X,Y;...
/// Throws `Failure` (usage) for anything else; `subject` begins the message.
[[nodiscard]] Profile parse_profile(const std::string& text, const std::string& subject);

/// Returns the mode that `text` names; throws `Failure` (usage).
[[nodiscard]] Blend_mode parse_mode(const std::string& mode);

}  // namespace cgal_blend::cli

#endif
