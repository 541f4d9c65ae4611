#include "formats/obj_text.hpp"

#include <algorithm>

#include "formats/numbers.hpp"
#include "formats/obj_names.hpp"

namespace mansard {

void ObjText::comment(std::string_view lines) {
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    text_.put("# ");
    text_.put(lines.substr(0, end));
    text_.put("\n");
    lines.remove_prefix(end == lines.npos ? lines.size() : end + 1);
  }
}

void ObjText::name(std::string_view key, std::string_view name) {
  if (name.empty()) name = "_";
  text_.put(key);
  char* const to = text_.room(name.size() + 1);
  char* const end = std::ranges::transform(name, to, safe_letter).out;
  *end = '\n';
  text_.advance(end + 1);
}

void ObjText::points(std::span<const Vec3> points) {
  for (const Vec3& p : points) {
    char* to = text_.room(4 * number_length);
    *to++ = 'v';
    text_.advance(put_vector(to, p));
  }
}

void ObjText::uvs(std::span<const Vec2> uvs) {
  for (const Vec2& uv : uvs) {
    char* to = text_.room(4 * number_length);
    *to++ = 'v';
    *to++ = 't';
    *to++ = ' ';
    to = put_number(to, uv.x);
    *to++ = ' ';
    to = put_number(to, uv.y);
    *to++ = '\n';
    text_.advance(to);
  }
}

void ObjText::normal(const Vec3& normal) {
  char* to = text_.room(4 * number_length);
  *to++ = 'v';
  *to++ = 'n';
  text_.advance(put_vector(to, normal));
}

char* ObjText::put_vector(char* to, Vec3 v) const {
  if (up_ == Up::z) v = {v.x, -v.z, v.y};
  *to++ = ' ';
  to = put_number(to, v.x);
  *to++ = ' ';
  to = put_number(to, v.y);
  *to++ = ' ';
  to = put_number(to, v.z);
  *to++ = '\n';
  return to;
}

void ObjText::face(const Surface& surface, std::size_t polygon, uint64_t normal,
                   const ObjCounts& before) {
  const bool with_uvs = surface.has_uvs();
  const std::size_t begin = surface.begin(polygon), end = surface.ends[polygon];
  char* to = text_.room((end - begin) * 4 * number_length + 2);
  *to++ = 'f';
  point_.set(before.points + begin + 1);
  uv_.set(before.uvs + begin + 1);
  normal_.set(normal);
  for (std::size_t i = begin; i < end; ++i) {
    *to++ = ' ';
    to = point_.put(to);
    *to++ = '/';
    if (with_uvs) to = uv_.put(to);
    *to++ = '/';
    to = normal_.put(to);
    point_.next();
    uv_.next();
  }
  *to++ = '\n';
  text_.advance(to);
}

}  // namespace mansard
