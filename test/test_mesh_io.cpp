// SPDX-License-Identifier: GPL-3.0-or-later
#include <cgal_blend/mesh_io.h>
#include <cgal_blend/validate.h>

#include "checks.h"
#include "shapes.h"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <sstream>
#include <string>

namespace {

using namespace cgal_blend;
using namespace cgal_blend::test;
namespace fs = std::filesystem;
using Kind = Mesh_io_error::Kind;

/// A fresh folder per test, removed afterwards.
class Mesh_io : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("cgal_blend_io_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  [[nodiscard]] std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string file(const std::string& name, const std::string& bytes) const {
    std::ofstream(path(name), std::ios::binary) << bytes;
    return path(name);
  }

  [[nodiscard]] std::string bytes(const std::string& name) const {
    std::ifstream in(path(name), std::ios::binary);
    std::ostringstream out;
    out << in.rdbuf();
    return out.str();
  }

  [[nodiscard]] std::size_t files() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator());
  }

  fs::path folder_;
};

/// Whatever runs while this lives must print nothing.
class Expect_silence {
 public:
  Expect_silence() {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
  }
  Expect_silence(const Expect_silence&) = delete;
  ~Expect_silence() {
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  }
};

std::optional<Mesh_io_error> refusal(const std::string& path) {
  try {
    const Blend_mesh mesh = read_mesh(path);
  } catch (const Mesh_io_error& e) {
    return e;
  }
  return std::nullopt;
}

#define EXPECT_REFUSED(path, expected_kind, expected_status)                                                     \
  do {                                                                                                           \
    const Expect_silence silence;                                                                                \
    const auto error = refusal(path);                                                                            \
    ASSERT_TRUE(error) << "was read";                                                                            \
    EXPECT_EQ(error->kind, expected_kind) << error->what();                                                      \
    EXPECT_STREQ(cgal_blend::name(error->diagnosis.status), cgal_blend::name(expected_status)) << error->what(); \
    EXPECT_NE(std::string(error->what()).find(path), std::string::npos) << error->what();                        \
    EXPECT_EQ(std::string(error->what()).find('\n'), std::string::npos) << error->what();                        \
  } while (false)

const char* const tetrahedron_off = "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, from.size(), to);
}

/// Coordinates that need all their digits.
Blend_mesh awkward_mesh() {
  return transformed(torus(2, 0.7, 24, 12), placement({1, 2, 3}, 0.7, {1e3, -1e-3, 0.1}, 1.0 / 3));
}

// ---------------------------------------------------------------- round trips

TEST_F(Mesh_io, Round_trip_is_exact) {
  const Blend_mesh mesh = awkward_mesh();
  for (const char* name : {"m.off", "m.obj", "m.ply", "m.OFF"}) {
    write_mesh(path(name), mesh);
    EXPECT_TRUE(identical(read_mesh(path(name)), mesh)) << name;
  }
}

TEST_F(Mesh_io, Round_trip_keeps_extreme_coordinates) {
  const double tiny = std::numeric_limits<double>::denorm_min(), huge = std::numeric_limits<double>::max();
  Blend_mesh mesh = box({0, 0, 0}, {1, 1, 1});
  mesh.point(Vertex(0)) = Point_3(tiny, -huge, 0.1);
  mesh.point(Vertex(1)) = Point_3(-0.0, 1e22, 123456789.123456789);
  for (const char* name : {"m.off", "m.obj", "m.ply"}) {
    write_mesh(path(name), mesh);
    const Blend_mesh back = read_mesh(path(name));
    EXPECT_TRUE(identical(back, mesh)) << name;
    EXPECT_TRUE(std::signbit(back.point(Vertex(1)).x())) << name;
  }
}

TEST_F(Mesh_io, Stl_round_trip_merges_corners) {
  const Blend_mesh mesh = grid_box({0, 0, 0}, {1, 2, 4}, 8);  // coordinates that single precision holds
  write_mesh(path("m.stl"), mesh);
  const Blend_mesh back = read_mesh(path("m.stl"));
  EXPECT_EQ(back.number_of_vertices(), mesh.number_of_vertices());
  EXPECT_TRUE(is_closed_by_counting(back));
  EXPECT_EQ(volume_of(back), 8);
  std::vector<Face> all(mesh.faces().begin(), mesh.faces().end());
  EXPECT_TRUE(faces_kept_in_order(mesh, back, all));
  EXPECT_EQ(fs::file_size(path("m.stl")), 84 + 50 * mesh.number_of_faces());
}

TEST_F(Mesh_io, Writing_skips_removed_elements_and_keeps_order) {
  Blend_mesh mesh = side_by_side(box({0, 0, 0}, {1, 1, 1}), awkward_mesh());
  for (std::uint32_t f = 0; f < 12; ++f) CGAL::Euler::remove_face(mesh.halfedge(Face(f)), mesh);
  ASSERT_TRUE(mesh.has_garbage());
  write_mesh(path("m.off"), mesh);
  EXPECT_TRUE(identical(read_mesh(path("m.off")), awkward_mesh()));
}

TEST_F(Mesh_io, Faces_begin_at_the_same_corner_after_a_round_trip) {
  write_mesh(path("a.off"), read_mesh(file("t.off", tetrahedron_off)));
  EXPECT_NE(bytes("a.off").find("3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"), std::string::npos) << bytes("a.off");
}

TEST_F(Mesh_io, Vertices_without_faces_keep_their_place) {
  const Blend_mesh mesh =
      read_mesh(file("t.off", "OFF 5 4 0\n9 9 9\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 1 3 2\n3 1 2 4\n3 2 3 4\n3 1 4 3\n"));
  EXPECT_EQ(mesh.number_of_vertices(), 5u);
  EXPECT_EQ(mesh.point(Vertex(0)), Point_3(9, 9, 9));
  EXPECT_TRUE(validate(mesh).ok());
}

// ---------------------------------------------------------------- formats

TEST_F(Mesh_io, Reads_off_with_comments_and_extra_columns) {
  const char* const variants[] = {
      "# first a comment\n\n  OFF # word\n# counts\n4 4 6\n\n0 0 0 # origin\n1 0 0\n0 1 0\n# half way\n0 0 1\n3 0 2 "
      "1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n",
      "COFF\n4 4 0\n0 0 0 255 0 0 255\n1 0 0 255 0 0 255\n0 1 0 0 0 0 0\n0 0 1 1 1 1 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 "
      "3 2\n",
      "NOFF\n4 4 0\n0 0 0 0 0 1\n1 0 0 1 0 0\n0 1 0 0 1 0\n0 0 1 0 0 1\n3 0 2 1 255 0 0\n3 0 1 3\n3 1 2 3 0.5 0.5 0.5 "
      "1\n3 0 3 2\n",
      "OFF 4 4 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n0 0 1\r\n3 0 2 1\r\n3 0 1 3\r\n3 1 2 3\r\n3 0 3 2",
      "OFF\n4 4\n0 0 0\n+1 0. 0\n.0 1e0 0\n0 0 1.0E+0\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"};
  for (const char* text : variants) {
    const Blend_mesh mesh = read_mesh(file("t.off", text));
    EXPECT_TRUE(identical(mesh, read_mesh(file("plain.off", tetrahedron_off)))) << text;
  }
}

TEST_F(Mesh_io, Reads_obj_with_all_kinds_of_indices) {
  const Blend_mesh mesh = read_mesh(
      file("t.obj",
           "# comment\nmtllib x.mtl\no thing\nv 0 0 0\nv 1 0 0 1.0\nv 0 1 0 0.5 0.5 0.5\nv 0 0 1\nvt 0 0\nvn 0 0 1\n"
           "g a\nusemtl m\ns off\nf 1 3 2\nf 1/1 2/1 4/1\nf 2//1 3//1 4//1\nf -4/1/1 -1/1/1 \\\n -2/1/1\n"));
  EXPECT_TRUE(identical(mesh, read_mesh(file("plain.off", tetrahedron_off))));
}

TEST_F(Mesh_io, Reads_ply_of_many_types) {
  const std::string ascii =
      "ply\nformat ascii 1.0\ncomment made by hand\nobj_info x\nelement vertex 4\nproperty float x\nproperty uchar "
      "red\nproperty double y\n"
      "property float z\nproperty list uchar float weights\nelement material 1\nproperty int n\nelement face 4\n"
      "property uchar flag\nproperty list uint8 uint32 vertex_index\nend_header\n"
      "0 255 0 0 2 1 1\n1 0 0 0 0\n0 0 1 0 1 7\n0 0 0 1 0\n99\n7 3 0 2 1\n7 3 0 1 3\n7 3 1 2 3\n7 3 0 3 2\n";
  const Blend_mesh expected = read_mesh(file("plain.off", tetrahedron_off));
  EXPECT_TRUE(identical(read_mesh(file("t.ply", ascii)), expected));
}

TEST_F(Mesh_io, Reads_ply_of_either_byte_order) {
  const Blend_mesh mesh = read_mesh(file("plain.off", tetrahedron_off));
  write_mesh(path("little.ply"), mesh);
  const std::string little = bytes("little.ply");
  const std::size_t body = little.find("end_header\n") + 11;
  std::string big = replaced(little.substr(0, body), "little", "big");
  const auto append_reversed = [&](std::size_t& at, std::size_t size) {
    for (std::size_t i = size; i-- > 0;) big += little[at + i];
    at += size;
  };
  std::size_t at = body;
  for (int i = 0; i < 12; ++i) append_reversed(at, 8);
  for (int f = 0; f < 4; ++f) {
    append_reversed(at, 1);
    for (int i = 0; i < 3; ++i) append_reversed(at, 4);
  }
  ASSERT_EQ(at, little.size());
  EXPECT_TRUE(identical(read_mesh(file("big.ply", big)), mesh));
}

std::string ascii_stl(const Blend_mesh& mesh, const std::string& solid) {
  std::ostringstream out;
  out.precision(17);
  out << "solid " << solid << "\n";
  for (const Face f : mesh.faces()) {
    out << "  facet normal 0 0 0\n    outer loop\n";
    for (const std::size_t v : corners_of(mesh, f)) out << "      vertex " << mesh.point(Vertex(v)) << "\n";
    out << "    endloop\n  endfacet\n";
  }
  out << "endsolid " << solid << "\n";
  return out.str();
}

TEST_F(Mesh_io, Reads_text_stl_with_several_solids) {
  const Blend_mesh a = awkward_mesh(), b = box({9, 9, 9}, {10, 10, 10});
  const Blend_mesh mesh = read_mesh(file("t.stl", ascii_stl(a, "facet vertex") + ascii_stl(b, "")));
  EXPECT_EQ(mesh.number_of_vertices(), a.number_of_vertices() + b.number_of_vertices());
  EXPECT_NEAR(volume_of(mesh), volume_of(a) + 1, 1e-12);
  EXPECT_TRUE(validate(mesh).ok());
}

TEST_F(Mesh_io, Reads_binary_stl_that_begins_with_the_word_solid) {
  write_mesh(path("m.stl"), box({0, 0, 0}, {1, 1, 1}));
  const Blend_mesh mesh = read_mesh(file("solid.stl", "solid" + bytes("m.stl").substr(5)));
  EXPECT_DOUBLE_EQ(volume_of(mesh), 1);
}

TEST_F(Mesh_io, Stl_facets_that_shrink_to_nothing_are_dropped) {
  const std::string needle =
      "facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\nendsolid";
  const Blend_mesh mesh =
      read_mesh(file("t.stl", replaced(ascii_stl(box({0, 0, 0}, {1, 1, 1}), "x"), "endsolid", needle)));
  EXPECT_EQ(mesh.number_of_faces(), 12u);
  EXPECT_TRUE(validate(mesh).ok());
}

TEST_F(Mesh_io, Stl_corners_at_zero_and_minus_zero_are_one) {
  const std::string text = ascii_stl(box({0, 0, 0}, {1, 1, 1}), "x");
  EXPECT_EQ(read_mesh(file("t.stl", replaced(text, "vertex 0 0 0", "vertex -0 0 -0.0"))).number_of_vertices(), 8u);
}

TEST_F(Mesh_io, Polygons_are_split_in_place_without_folds) {
  // An L-shaped prism of two hexagons, reflex at vertex 3 and 9, and six quadrangles.
  const Blend_mesh mesh = read_mesh(
      file("l.off",
           "OFF\n12 8 0\n0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 1\n2 0 1\n2 1 1\n1 1 1\n1 2 1\n0 2 1\n"
           "6 5 4 3 2 1 0\n6 6 7 8 9 10 11\n4 0 1 7 6\n4 1 2 8 7\n4 2 3 9 8\n4 3 4 10 9\n4 4 5 11 10\n4 5 0 6 11\n"));
  EXPECT_EQ(mesh.number_of_faces(), 2 * 4 + 6 * 2u);
  EXPECT_DOUBLE_EQ(volume_of(mesh), 3);
  EXPECT_DOUBLE_EQ(area_of(mesh), 2 * 3 + 8);
  EXPECT_TRUE(validate(mesh).ok());
  for (std::uint32_t f = 0; f < 4; ++f)
    for (const std::size_t v : corners_of(mesh, Face(f))) EXPECT_LT(v, 6u);
}

TEST_F(Mesh_io, Large_polygons_lose_no_area_and_gain_no_flat_face) {
  // A star-shaped prism with a corner in the middle of every side: reflex and straight corners by turns.
  const int n = 200;
  std::ostringstream text;
  text.precision(17);
  text << "OFF\n" << 2 * n << " " << n + 2 << " 0\n";
  std::vector<std::pair<double, double>> outline;
  for (int i = 0; i < n; i += 2) {
    const double angle = 2 * pi * i / n, radius = i % 4 == 0 ? 4 : 2;
    outline.emplace_back(std::round(1024 * radius * std::cos(angle)), std::round(1024 * radius * std::sin(angle)));
  }
  double area = 0;
  for (const int z : {0, 1})
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const auto [x, y] = outline[i];
      const auto [u, v] = outline[(i + 1) % outline.size()];
      text << x << " " << y << " " << z << "\n" << (x + u) / 2 << " " << (y + v) / 2 << " " << z << "\n";
      area += z * (x * v - u * y) / 2;
    }
  for (const int z : {0, 1}) {
    text << n;
    for (int i = 0; i < n; ++i) text << " " << (z == 0 ? n - 1 - i : n + i);
    text << "\n";
  }
  for (int i = 0; i < n; ++i) text << "4 " << i << " " << (i + 1) % n << " " << n + (i + 1) % n << " " << n + i << "\n";
  const Blend_mesh mesh = read_mesh(file("star.off", text.str()));
  EXPECT_EQ(mesh.number_of_faces(), 2u * (n - 2) + 2 * n);
  EXPECT_DOUBLE_EQ(volume_of(mesh), area);
  EXPECT_TRUE(validate(mesh).ok()) << message(validate(mesh).diagnosis);
}

TEST_F(Mesh_io, A_reflex_quadrangle_is_split_inside) {
  // The arrowhead 0 1 2 3 is reflex at 2; only the diagonal 0-2 lies inside, and 1-3 is shorter.
  const Blend_mesh mesh = read_mesh(
      file("a.off", "OFF\n5 5 0\n0 0 0\n5 1 0\n3 0 0\n5 -1 0\n2 0 1\n4 0 1 2 3\n3 1 0 4\n3 2 1 4\n3 3 2 4\n3 0 3 4\n"));
  EXPECT_EQ(validate(mesh).diagnosis.status, Status::ok) << message(validate(mesh).diagnosis);
}

// ---------------------------------------------------------------- refusals

TEST_F(Mesh_io, Refuses_files_that_cannot_be_opened) {
  EXPECT_REFUSED(path("missing.off"), Kind::unreadable, Status::ok);
  fs::create_directory(folder_ / "folder.off");
  EXPECT_REFUSED(path("folder.off"), Kind::unreadable, Status::ok);
}

TEST_F(Mesh_io, Refuses_unknown_formats) {
  EXPECT_REFUSED(file("mesh.step", "x"), Kind::unknown_format, Status::ok);
  EXPECT_REFUSED(file("mesh", "x"), Kind::unknown_format, Status::ok);
}

TEST_F(Mesh_io, Refuses_empty_files_and_meshes) {
  for (const char* name : {"e.off", "e.obj", "e.ply", "e.stl"}) {
    EXPECT_REFUSED(file(name, ""), Kind::bad_mesh, Status::input_empty);
    EXPECT_REFUSED(file(name, "\n \n"), Kind::bad_mesh, Status::input_empty);
  }
  EXPECT_REFUSED(file("e.off", "OFF\n0 0 0\n"), Kind::bad_mesh, Status::input_empty);
  EXPECT_REFUSED(file("e.obj", "# nothing\nv 0 0 0\n"), Kind::bad_mesh, Status::input_empty);
  EXPECT_REFUSED(file("e.stl", "solid x\nendsolid x\n"), Kind::bad_mesh, Status::input_empty);
}

TEST_F(Mesh_io, Refuses_cut_off_files_wherever_they_are_cut) {
  std::string failures;
  const auto try_cut = [&](const std::string& name, const std::string& whole, std::size_t size) {
    const auto error = refusal(file("cut" + name, whole.substr(0, size)));
    if (!error || error->kind != Kind::unreadable)
      failures += name + " after " + std::to_string(size) + " bytes: " + (error ? error->what() : "was read") + "\n";
  };
  const Blend_mesh mesh = transformed(box({0, 0, 0}, {1, 1, 1}), placement({1, 2, 3}, 0.5));
  for (const char* name : {"m.off", "m.ply", "m.stl"}) {
    write_mesh(path(name), mesh);
    const std::string whole = bytes(name);
    for (std::size_t size = 1; size + 2 < whole.size(); size += 3) try_cut(name, whole, size);
    for (std::size_t last = 3; last < 12; ++last) try_cut(name, whole, whole.size() - last);
  }
  const std::string text = ascii_stl(mesh, "x");
  for (std::size_t size = 6; size < text.rfind("endsolid"); size += 11) try_cut("m.stl", text, size);
  EXPECT_EQ(failures, "");
  EXPECT_REFUSED(file("cut.obj", "v 0 0 0\nv 1 0 0\nv 0 1"), Kind::unreadable, Status::ok);
  EXPECT_REFUSED(file("cut.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2"), Kind::unreadable, Status::ok);
}

TEST_F(Mesh_io, Refuses_malformed_files) {
  const auto off = [&](const std::string& from, const std::string& to) {
    return file("t.off", replaced(tetrahedron_off, from, to));
  };
  EXPECT_REFUSED(off("OFF", "FOO"), Kind::unreadable, Status::ok);
  EXPECT_REFUSED(off("OFF", "4OFF"), Kind::unreadable, Status::ok);
  EXPECT_REFUSED(off("3 0 3 2", "3 0 3 4"), Kind::unreadable, Status::ok);
  EXPECT_REFUSED(off("3 0 3 2", "3 0 3 -1"), Kind::unreadable, Status::ok);
  EXPECT_REFUSED(off("3 0 3 2", "2 0 3"), Kind::unreadable, Status::ok);
  EXPECT_REFUSED(off("0 0 1", "0 zero 1"), Kind::unreadable, Status::ok);
  EXPECT_REFUSED(off("4 4 6", "4000000000 4 6"), Kind::unreadable, Status::ok);
  EXPECT_REFUSED(off("4 4 6", "-4 4 6"), Kind::unreadable, Status::ok);
  EXPECT_REFUSED(off("3 0 3 2", "4000000000 0 3 2"), Kind::unreadable, Status::ok);
  EXPECT_REFUSED(file("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"), Kind::unreadable, Status::ok);
  EXPECT_REFUSED(file("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n"), Kind::unreadable, Status::ok);
  EXPECT_REFUSED(file("t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -4 -1 -2\n"), Kind::unreadable, Status::ok);
  EXPECT_REFUSED(file("t.ply", "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\nend_header\n1\n"),
                 Kind::unreadable, Status::ok);
  EXPECT_REFUSED(file("t.ply",
                      "ply\nformat ascii 1.0\nelement vertex 3\nelement face 1\nproperty list uchar int vertex_index\n"
                      "end_header\n3 0 1 2\n"),
                 Kind::unreadable, Status::ok);
  EXPECT_REFUSED(file("t.ply", "ply\nformat middle_endian 1.0\nelement vertex 0\nend_header\n"), Kind::unreadable,
                 Status::ok);
  EXPECT_REFUSED(
      file("t.stl",
           "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\nendsolid\n"),
      Kind::unreadable, Status::ok);
}

TEST_F(Mesh_io, Malformed_text_is_told_with_its_line) {
  const auto error = refusal(file("t.off", replaced(tetrahedron_off, "0 0 1", "0 zero 1")));
  ASSERT_TRUE(error);
  EXPECT_NE(std::string(error->what()).find("line 6"), std::string::npos) << error->what();
  EXPECT_NE(std::string(error->what()).find("zero"), std::string::npos) << error->what();
}

TEST_F(Mesh_io, Names_coordinates_that_are_not_finite) {
  for (const char* bad : {"nan", "NaN", "-nan", "nan(ind)", "-nan(ind)", "inf", "-inf", "Infinity", "1e999", "1.#QNAN",
                          "-1.#IND", "1.#INF"}) {
    EXPECT_REFUSED(file("t.off", replaced(tetrahedron_off, "0 0 1", std::string("0 ") + bad + " 1")), Kind::bad_mesh,
                   Status::input_not_finite);
    EXPECT_REFUSED(file("t.obj", std::string("v 0 0 0\nv 1 0 0\nv 0 1 ") + bad + "\nf 1 2 3\n"), Kind::bad_mesh,
                   Status::input_not_finite);
  }
  const auto error = refusal(file("t.off", replaced(tetrahedron_off, "0 0 1", "0 nan 1")));
  ASSERT_TRUE(error);
  EXPECT_EQ(error->diagnosis.detail, "vertex 3");
}

TEST_F(Mesh_io, Names_coordinates_that_are_not_finite_in_binary_files) {
  Blend_mesh mesh = box({0, 0, 0}, {1, 1, 1});
  mesh.point(Vertex(2)) = Point_3(0, std::numeric_limits<double>::infinity(), 0);
  for (const char* name : {"m.off", "m.obj", "m.ply", "m.stl"}) {
    write_mesh(path(name), mesh);
    EXPECT_REFUSED(path(name), Kind::bad_mesh, Status::input_not_finite);
  }
}

TEST_F(Mesh_io, Names_what_no_halfedge_structure_can_hold) {
  const std::string square = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 0 -1\n1 1 0\n";
  const auto soup = [&](const std::string& faces, int count) {
    return file("t.off", "OFF\n6 " + std::to_string(count) + " 0\n" + square + faces);
  };
  // Three faces at the edge 0-1.
  EXPECT_REFUSED(soup("3 0 1 2\n3 1 0 3\n3 0 1 4\n", 3), Kind::bad_mesh, Status::input_not_manifold);
  EXPECT_EQ(refusal(path("t.off"))->diagnosis.point, Point_3(0.5, 0, 0));
  // Two faces that share vertex 0 only.
  EXPECT_REFUSED(soup("3 0 1 2\n3 0 3 5\n", 2), Kind::bad_mesh, Status::input_not_manifold);
  EXPECT_EQ(refusal(path("t.off"))->diagnosis.point, Point_3(0, 0, 0));
  // Two faces that run the same way along 1-2.
  EXPECT_REFUSED(soup("3 0 1 2\n3 1 2 5\n", 2), Kind::bad_mesh, Status::input_misoriented);
  EXPECT_EQ(refusal(path("t.off"))->diagnosis.point, Point_3(0.5, 0.5, 0));
  // A face with a vertex twice.
  EXPECT_REFUSED(soup("3 0 1 1\n", 1), Kind::bad_mesh, Status::input_degenerate);
  EXPECT_EQ(refusal(path("t.off"))->diagnosis.point, Point_3(1, 0, 0));
}

TEST_F(Mesh_io, What_a_halfedge_structure_can_hold_is_left_to_validation) {
  const auto status = [&](const std::string& text) {
    return validate(read_mesh(file("t.off", text))).diagnosis.status;
  };
  EXPECT_EQ(status(replaced(replaced(tetrahedron_off, "4 4 6", "4 3 6"), "3 0 3 2\n", "")), Status::input_not_closed);
  EXPECT_EQ(status("OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n3 0 3 1\n3 1 3 2\n3 0 2 3\n"),
            Status::input_misoriented);
  EXPECT_EQ(status("OFF\n4 4 0\n0 0 0\n1 0 0\n2 0 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n"),
            Status::input_degenerate);
}

// ---------------------------------------------------------------- writing

TEST_F(Mesh_io, Writing_leaves_nothing_but_the_file) {
  write_mesh(path("m.off"), awkward_mesh());
  write_mesh(path("m.off"), box({0, 0, 0}, {1, 1, 1}));
  EXPECT_EQ(files(), 1u);
  EXPECT_DOUBLE_EQ(volume_of(read_mesh(path("m.off"))), 1);
}

#define EXPECT_UNWRITABLE(path, mesh, expected_kind)      \
  try {                                                   \
    write_mesh(path, mesh);                               \
    ADD_FAILURE() << "was written";                       \
  } catch (const Mesh_io_error& error) {                  \
    EXPECT_EQ(error.kind, expected_kind) << error.what(); \
  }

TEST_F(Mesh_io, Refuses_targets_that_cannot_be_written) {
  const Blend_mesh mesh = box({0, 0, 0}, {1, 1, 1});
  EXPECT_UNWRITABLE(path("no/such/folder/m.off"), mesh, Kind::unwritable);
  EXPECT_UNWRITABLE(path("m.step"), mesh, Kind::unknown_format);
  fs::create_directory(folder_ / "folder.off");
  EXPECT_UNWRITABLE(path("folder.off"), mesh, Kind::unwritable);
  fs::remove(folder_ / "folder.off");
  EXPECT_EQ(files(), 0u);
}

TEST_F(Mesh_io, A_write_protected_file_stays_as_it_is) {
  fs::permissions(file("m.off", "precious"), fs::perms::owner_read);
  EXPECT_UNWRITABLE(path("m.off"), box({0, 0, 0}, {1, 1, 1}), Kind::unwritable);
  EXPECT_EQ(bytes("m.off"), "precious");
  EXPECT_EQ(files(), 1u);
}

TEST_F(Mesh_io, A_full_disk_leaves_the_old_file) {
  if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  // The name that the writer will pick first for its temporary file leads to a full device.
  file("m.off", "precious");
  fs::create_symlink("/dev/full", folder_ / "m.off.part0");
  write_mesh(path("m.off"), box({0, 0, 0}, {1, 1, 1}));  // it must not follow a link that it did not make
  EXPECT_DOUBLE_EQ(volume_of(read_mesh(path("m.off"))), 1);
  EXPECT_TRUE(fs::is_symlink(folder_ / "m.off.part0"));
}

TEST_F(Mesh_io, A_link_to_the_target_stays_a_link) {
  file("real.off", "old");
  fs::create_symlink(folder_ / "real.off", folder_ / "link.off");
  write_mesh(path("link.off"), box({0, 0, 0}, {1, 1, 1}));
  EXPECT_TRUE(fs::is_symlink(folder_ / "link.off"));
  EXPECT_DOUBLE_EQ(volume_of(read_mesh(path("real.off"))), 1);
}

TEST_F(Mesh_io, Stl_that_rounding_would_spoil_is_not_written) {
  // Seven digits cannot tell these corners apart.
  const Blend_mesh mesh = box({1e6, 0, 0}, {1e6 + 0.01, 1, 1});
  ASSERT_TRUE(validate(mesh).ok());
  EXPECT_UNWRITABLE(path("m.stl"), mesh, Kind::unwritable);
  EXPECT_EQ(files(), 0u);
  write_mesh(path("m.ply"), mesh);
  EXPECT_TRUE(identical(read_mesh(path("m.ply")), mesh));
}

TEST_F(Mesh_io, Same_mesh_same_bytes) {
  for (const char* name : {"m.off", "m.obj", "m.ply", "m.stl"}) {
    write_mesh(path(name), awkward_mesh());
    const std::string first = bytes(name);
    write_mesh(path(name), awkward_mesh());
    EXPECT_EQ(bytes(name), first);
  }
}

// ---------------------------------------------------------------- curvature

TEST_F(Mesh_io, Curvature_is_written_beside_the_mesh) {
  Blend_mesh mesh = awkward_mesh();
  mesh.add_vertex({1, 2, 3});
  std::vector<double> curvatures;
  std::vector<std::array<unsigned char, 3>> colours;
  for (std::size_t i = 0; i < mesh.number_of_vertices(); ++i) {
    curvatures.push_back(0.1 * static_cast<double>(i) - 7);
    colours.push_back({static_cast<unsigned char>(i), 255, static_cast<unsigned char>(7 * i)});
  }
  write_curvature_ply(path("m.PLY"), mesh, curvatures, colours);
  EXPECT_TRUE(identical(read_mesh(path("m.PLY")), mesh));
  const std::string text = bytes("m.PLY");
  EXPECT_NE(
      text.find("property uchar red\nproperty uchar green\nproperty uchar blue\nproperty double mean_curvature\n"),
      std::string::npos);
  const std::string end = "end_header\n";
  const std::size_t stride = 3 * sizeof(double) + 3 + sizeof(double), body = text.find(end) + end.size();
  for (const std::size_t i : {std::size_t(0), std::size_t(100), curvatures.size() - 1}) {
    const char* vertex = text.data() + body + i * stride + 3 * sizeof(double);
    for (int k = 0; k < 3; ++k) EXPECT_EQ(static_cast<unsigned char>(vertex[k]), colours[i][k]);
    double curvature = 0;
    std::memcpy(&curvature, vertex + 3, sizeof curvature);
    EXPECT_EQ(curvature, curvatures[i]);
  }
}

TEST_F(Mesh_io, Curvature_goes_to_ply_only_and_replaces_whole_files) {
  const Blend_mesh mesh = box({0, 0, 0}, {1, 1, 1});
  const auto kind = [&](const std::string& name) {
    try {
      write_curvature_ply(path(name), mesh, std::vector<double>(8), {8, {0, 0, 0}});
    } catch (const Mesh_io_error& error) {
      return error.kind;
    }
    return Kind::bad_mesh;
  };
  for (const char* name : {"m.off", "m.stl", "m.step"}) EXPECT_EQ(kind(name), Kind::unknown_format) << name;
  EXPECT_EQ(kind("nowhere/m.ply"), Kind::unwritable);
  EXPECT_EQ(files(), 0u);
  file("m.ply", "what was there before");
  write_curvature_ply(path("m.ply"), mesh, std::vector<double>(8), {8, {0, 0, 0}});
  EXPECT_TRUE(identical(read_mesh(path("m.ply")), mesh));
  EXPECT_EQ(files(), 1u);
}

// ---------------------------------------------------------------- models from elsewhere

#ifdef CGAL_BLEND_SHARED
constexpr const char* shared_folder = CGAL_BLEND_SHARED;
#else
constexpr const char* shared_folder = "";
#endif

class Shared_models : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(model("gen_box.off"))) GTEST_SKIP() << "no shared models";
  }
  [[nodiscard]] static std::string model(const std::string& name) {
    return std::string(shared_folder) + "/data/models/" + name;
  }
};

TEST_F(Shared_models, Clean_ones_are_read_and_valid) {
  const struct {
    const char* name;
    std::size_t vertices, faces;
  } table[] = {{"gen_box.off", 8, 12},         {"couplingdown.off", 1841, 3714},    {"spot.off", 2930, 5856},
               {"plate_holes.stl", 618, 1252}, {"gen_torus_64x32.off", 2048, 4096}, {"teapot_body.off", 1601, 3198}};
  for (const auto& row : table) {
    const Validity_report r = validate(read_mesh(model(row.name)));
    EXPECT_TRUE(r.ok()) << row.name << ": " << message(r.diagnosis);
    EXPECT_EQ(r.vertices, row.vertices) << row.name;
    EXPECT_EQ(r.faces, row.faces) << row.name;
    EXPECT_EQ(r.components, 1u) << row.name;
  }
}

TEST_F(Shared_models, Dirty_ones_are_refused_by_name) {
  EXPECT_REFUSED(model("oblong_shuffled.off"), Kind::bad_mesh, Status::input_misoriented);
  EXPECT_REFUSED(model("teapot_raw.obj"), Kind::bad_mesh, Status::input_not_manifold);
}

}  // namespace
