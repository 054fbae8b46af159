// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_BOOLEAN_OPERATION_H
#define CGAL_BLEND_BOOLEAN_OPERATION_H

namespace cgal_blend {

enum class Boolean_operation { union_, intersection, difference };

}  // namespace cgal_blend

#endif
