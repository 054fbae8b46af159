// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_FACE_ORIGIN_H
#define CGAL_BLEND_FACE_ORIGIN_H

#include <cstdint>
#include <limits>

namespace cgal_blend {

/// Stands for the origin of a face that is no part of a face of the input.
inline constexpr std::uint32_t no_origin = std::numeric_limits<std::uint32_t>::max();

}  // namespace cgal_blend

#endif
