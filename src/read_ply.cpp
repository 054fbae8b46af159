// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_formats.h"

#include <algorithm>
#include <cstring>
#include <optional>

namespace cgal_blend::internal {

namespace {

enum class Type { i8, u8, i16, u16, i32, u32, f32, f64 };

struct Property {
  std::string_view name;
  Type type;
  std::optional<Type> size_type;  ///< of lists
};

struct Element {
  std::string_view name;
  std::size_t count;
  std::vector<Property> properties;
};

Type parse_type(const Text_cursor& in, std::string_view name) {
  static constexpr struct {
    const char* names[2];
    Type type;
  } table[] = {{{"char", "int8"}, Type::i8},      {{"uchar", "uint8"}, Type::u8},    {{"short", "int16"}, Type::i16},
               {{"ushort", "uint16"}, Type::u16}, {{"int", "int32"}, Type::i32},     {{"uint", "uint32"}, Type::u32},
               {{"float", "float32"}, Type::f32}, {{"double", "float64"}, Type::f64}};
  for (const auto& row : table)
    if (name == row.names[0] || name == row.names[1]) return row.type;
  in.fail("unknown PLY type \"" + std::string(name.substr(0, 30)) + "\"");
}

std::size_t byte_size(Type type) {
  switch (type) {
    case Type::i8:
    case Type::u8: return 1;
    case Type::i16:
    case Type::u16: return 2;
    case Type::i32:
    case Type::u32:
    case Type::f32: return 4;
    case Type::f64: return 8;
  }
  return 0;
}

template <class T>
double load(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return static_cast<double>(value);
}

double load(Type type, const char* bytes) {
  switch (type) {
    case Type::i8: return load<std::int8_t>(bytes);
    case Type::u8: return load<std::uint8_t>(bytes);
    case Type::i16: return load<std::int16_t>(bytes);
    case Type::u16: return load<std::uint16_t>(bytes);
    case Type::i32: return load<std::int32_t>(bytes);
    case Type::u32: return load<std::uint32_t>(bytes);
    case Type::f32: return load<float>(bytes);
    case Type::f64: return load<double>(bytes);
  }
  return 0;
}

bool host_is_little_endian() {
  const std::uint16_t one = 1;
  unsigned char first;
  std::memcpy(&first, &one, 1);
  return first == 1;
}

/// Values of the body one after another, whether text or binary; a double holds all of them exactly.
class Values {
 public:
  Values(std::string_view body, std::string_view format, std::size_t first_line)
      : text_(body, first_line),
        bytes_(body),
        ascii_(format == "ascii"),
        swap_((format == "binary_big_endian") == host_is_little_endian()) {}

  double next(Type type) {
    if (ascii_) return text_.number();
    const std::size_t size = byte_size(type);
    if (bytes_.size() < size) fail("the file ends too early");
    char buffer[8];
    for (std::size_t i = 0; i < size; ++i) buffer[i] = bytes_[swap_ ? size - 1 - i : i];
    bytes_.remove_prefix(size);
    return load(type, buffer);
  }

  std::uint32_t index(Type type, std::size_t limit, const char* what) {
    const double value = next(type);
    if (!(value >= 0 && value < static_cast<double>(limit) && value < 4e9) ||
        value != static_cast<std::uint32_t>(value))
      fail(std::string("a face has a wrong ") + what);
    return static_cast<std::uint32_t>(value);
  }

  [[nodiscard]] std::size_t size() const { return bytes_.size(); }

  [[noreturn]] void fail(const std::string& what) const {
    if (ascii_) text_.fail(what);
    throw Malformed_file(what);
  }

 private:
  Text_cursor text_;
  std::string_view bytes_;
  bool ascii_, swap_;
};

struct Header {
  std::string_view format;
  std::vector<Element> elements;
};

Property read_property(Text_cursor& in) {
  Property property;
  std::string_view type = in.token_on_line();
  if (type == "list") {
    property.size_type = parse_type(in, in.token_on_line());
    type = in.token_on_line();
  }
  property.type = parse_type(in, type);
  property.name = in.token_on_line();
  return property;
}

Header read_header(std::string_view text) {
  Text_cursor in(text);
  if (in.token() != "ply") in.fail("a PLY file begins with the word ply");
  Header header;
  for (std::string_view word = in.token(); word != "end_header"; word = in.token()) {
    if (word == "format") {
      header.format = in.token_on_line();
    } else if (word == "element") {
      const std::string_view name = in.token_on_line();
      header.elements.push_back({name, in.count(), {}});
    } else if (word == "property") {
      if (header.elements.empty()) in.fail("a property stands before the first element");
      header.elements.back().properties.push_back(read_property(in));
    }
    in.skip_line();
  }
  if (header.format != "ascii" && header.format != "binary_little_endian" && header.format != "binary_big_endian")
    in.fail("unknown PLY format \"" + std::string(header.format.substr(0, 30)) + "\"");
  return header;
}

/// Reads a list property, handing the values to `use`; `limit` bounds its length.
template <class Use>
void read_list(Values& in, const Property& property, Use&& use) {
  const std::uint32_t size = in.index(*property.size_type, in.size() + 1, "number of corners");
  for (std::uint32_t k = 0; k < size; ++k) use();
}

void read_vertex(Values& in, const Element& element, Polygon_soup& soup) {
  double xyz[3] = {0, 0, 0};
  for (const Property& p : element.properties) {
    if (p.size_type) {
      read_list(in, p, [&] { in.next(p.type); });
      continue;
    }
    const double value = in.next(p.type);
    if (p.name.size() == 1 && p.name[0] >= 'x' && p.name[0] <= 'z') xyz[p.name[0] - 'x'] = value;
  }
  soup.points.emplace_back(xyz[0], xyz[1], xyz[2]);
}

void read_face(Values& in, const Element& element, std::size_t vertices, Polygon_soup& soup) {
  const std::size_t begin = soup.corners.size();
  for (const Property& p : element.properties) {
    if (!p.size_type)
      in.next(p.type);
    else if (p.name != "vertex_indices" && p.name != "vertex_index")
      read_list(in, p, [&] { in.next(p.type); });
    else
      read_list(in, p, [&] { soup.corners.push_back(in.index(p.type, vertices, "vertex index")); });
  }
  if (soup.corners.size() < begin + 3) in.fail("a face has less than three corners");
  soup.end_polygon();
}

void skip_element(Values& in, const Element& element) {
  for (const Property& p : element.properties) {
    if (p.size_type)
      read_list(in, p, [&] { in.next(p.type); });
    else
      in.next(p.type);
  }
}

/// Offset of the body: behind the line end that follows "end_header".
std::size_t find_body(std::string_view bytes) {
  std::size_t at = bytes.find("\nend_header");
  if (at != std::string_view::npos) at = bytes.find('\n', at + 1);
  if (at == std::string_view::npos) throw Malformed_file("the head of the PLY file has no end");
  return at + 1;
}

bool has_coordinates(const Element& element) {
  bool found[3] = {false, false, false};
  for (const Property& p : element.properties)
    if (!p.size_type && p.name.size() == 1 && p.name[0] >= 'x' && p.name[0] <= 'z') found[p.name[0] - 'x'] = true;
  return found[0] && found[1] && found[2];
}

/// Number of vertices; their element must be there once, with coordinates.
std::size_t count_vertices(const Header& header) {
  const auto is_vertex = [](const Element& element) { return element.name == "vertex"; };
  const auto vertex = std::find_if(header.elements.begin(), header.elements.end(), is_vertex);
  if (vertex == header.elements.end() || !has_coordinates(*vertex))
    throw Malformed_file("there are no vertices with x, y and z");
  if (std::count_if(header.elements.begin(), header.elements.end(), is_vertex) > 1)
    throw Malformed_file("the vertices are there twice");
  return vertex->count;
}

}  // namespace

Polygon_soup read_ply(std::string_view bytes) {
  const std::size_t body = find_body(bytes);
  const Header header = read_header(bytes.substr(0, body));
  const auto first_line = 1 + static_cast<std::size_t>(std::count(bytes.begin(), bytes.begin() + body, '\n'));
  Values in(bytes.substr(body), header.format, first_line);
  const std::size_t vertices = count_vertices(header);
  Polygon_soup soup;
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;  // nothing is stored for it
    if (element.count > in.size()) in.fail("the file ends too early");
    for (std::size_t i = 0; i < element.count; ++i) {
      if (element.name == "vertex")
        read_vertex(in, element, soup);
      else if (element.name == "face")
        read_face(in, element, vertices, soup);
      else
        skip_element(in, element);
    }
  }
  return soup;
}

}  // namespace cgal_blend::internal
