// A program that uses each library of planetree, its shapes by virtual calls, and its errors. The
// umbrella header is in both translation units of the program: nothing in it may be defined twice.
#include "shadows.hpp"

#include <planetree/mesh/read_mesh.hpp>

#include <iostream>
#include <span>
#include <string>
#include <string_view>

namespace {

constexpr std::string_view kTriangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

bool hitsTheFaceThatWasRead() {
  const auto mesh = planetree::readMesh<float>(std::as_bytes(std::span(kTriangle)), "triangle.obj");
  const auto hit = planetree::buildTree(mesh.view())
                       .findIntersection({.origin = {0.25f, 0.25f, 2}, .direction = {0, 0, -1}});
  return hit && hit->primitive == 0 && hit->t == 2;
}

bool catchesTheErrorOfAMissingFile() {
  try {
    static_cast<void>(planetree::readMesh<float>("there is no such file.ply"));
  } catch (const planetree::Error& error) {
    return error.code() == planetree::ErrorCode::FileNotReadable;
  }
  return false;
}

bool report(const std::string& what, bool holds) {
  std::cout << (holds ? "ok:     " : "FAILED: ") << what << '\n';
  return holds;
}

}  // namespace

int main() {
  bool allHold = report("a ray hits the face that was read", hitsTheFaceThatWasRead());
  allHold &= report("a sphere throws a shadow", isInShadow({0, 0, -3}, {0, 0, 3}));
  allHold &= report("and none beside it", !isInShadow({2, 0, -3}, {2, 0, 3}));
  allHold &= report("an error of the library is caught", catchesTheErrorOfAMissingFile());
  return allHold ? 0 : 1;
}
