// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_SRC_REFUSAL_H
#define CGAL_BLEND_SRC_REFUSAL_H

#include "base_surface.h"

#include <cgal_blend/status.h>

namespace cgal_blend {

/// A status with its place.
inline Diagnosis refusal(Status status, const Vec& at) {
  Diagnosis diagnosis;
  diagnosis.status = status;
  diagnosis.point = to_point(at);
  return diagnosis;
}

/// A result that failed its check, in terms of mapping: vertices moved, so faces are in each other's way.
inline Diagnosis refusal_of_result(Diagnosis diagnosis) {
  diagnosis.status = Status::region_too_coarse;
  diagnosis.detail.clear();
  return diagnosis;
}

}  // namespace cgal_blend

#endif
