// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef CGAL_BLEND_TEST_FUSION_CHECKS_H
#define CGAL_BLEND_TEST_FUSION_CHECKS_H

#include "checks.h"

#include <cgal_blend/fuse.h>
#include <cgal_blend/validate.h>

#include <gtest/gtest.h>

namespace cgal_blend::test {

inline void expect_valid(const Fuse_outcome& outcome, const Blend_mesh& mesh) {
  ASSERT_TRUE(outcome.ok()) << message(outcome.diagnosis);
  const Validity_report report = validate(mesh);
  EXPECT_TRUE(report.ok()) << message(report.diagnosis);
  EXPECT_TRUE(is_closed_by_counting(mesh));
  EXPECT_TRUE(has_single_fans(mesh));
  EXPECT_EQ(outcome.changed_faces.size() + outcome.kept_faces, mesh.number_of_faces());
}

}  // namespace cgal_blend::test

#endif
