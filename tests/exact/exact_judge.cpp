#include "exact/exact_judge.hpp"

#include "exact/exact_view.hpp"
#include "exact/near_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

namespace planetree::test {
namespace {

using exact::Number;
using exact::Point;
using exact::Polygon;
using Kernel = exact::Kernel;

Kernel::Point_3 toPoint(const Vec3d& p) {
  return {p.x, p.y, p.z};
}

/// On which sides of the ray's line the edges run, by CGAL's own predicate: 1 if the line passes
/// inside of all three, -1 if it passes outside of one, 0 if it meets an edge or the plane only.
int sideOfLine(const Rayd& ray, const Corners& corners) {
  const Kernel::Point_3 origin = toPoint(ray.origin);
  const Kernel::Point_3 ahead =
      origin + Kernel::Vector_3(ray.direction.x, ray.direction.y, ray.direction.z);
  std::array<Kernel::Point_3, 3> points;
  std::transform(corners.begin(), corners.end(), points.begin(), toPoint);
  int positive = 0;
  int negative = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto side = CGAL::orientation(origin, ahead, points[i], points[(i + 1) % 3]);
    positive += side == CGAL::POSITIVE ? 1 : 0;
    negative += side == CGAL::NEGATIVE ? 1 : 0;
  }
  if (positive > 0 && negative > 0)
    return -1;
  return positive == 3 || negative == 3 ? 1 : 0;
}

std::array<Point, 3> sheared(const exact::View& view, const Corners& corners) {
  return {view.of(corners[0]), view.of(corners[1]), view.of(corners[2])};
}

/// The kind of a meeting and, unless it is a miss, its t.
std::pair<Meeting, std::optional<std::pair<Number, Number>>> meetExactly(
    const Rayd& ray, const exact::View& view, const Corners& corners,
    const std::array<Point, 3>& points) {
  const int side = sideOfLine(ray, corners);
  if (side < 0)
    return {Meeting::Miss, {}};
  const Polygon common = exact::clippedToBox({points.begin(), points.end()}, 2, Number(0));
  if (common.empty())
    return {Meeting::Miss, {}};
  const auto [lower, upper] = exact::intervalOfT(common, view.directionZ(), Number(0));
  const bool beginsInside = ray.tMin == -std::numeric_limits<double>::infinity() ||
                            (std::isfinite(ray.tMin) && Number(ray.tMin) < lower);
  const bool endsInside = ray.tMax == std::numeric_limits<double>::infinity() ||
                          (std::isfinite(ray.tMax) && Number(ray.tMax) > upper);
  if ((!beginsInside && (!std::isfinite(ray.tMin) || Number(ray.tMin) > upper)) ||
      (!endsInside && (!std::isfinite(ray.tMax) || Number(ray.tMax) < lower)))
    return {Meeting::Miss, {}};
  const bool isProper = side > 0 && beginsInside && endsInside;
  return {isProper ? Meeting::Hit : Meeting::Touching, std::pair(lower, upper)};
}

/// Two corners of a face, the lower number first, and whether the face has them in this order.
struct Edge {
  std::pair<std::uint32_t, std::uint32_t> places;
  int direction;

  Edge(std::uint32_t from, std::uint32_t to) noexcept
      : places(std::minmax(from, to)),
        direction(from < to   ? 1
                  : from > to ? -1
                              : 0) {}
};

struct NearEdge {
  std::vector<std::size_t> nearFaces;
  int sum = 0;  ///< zero if the edge is struck out
};

struct NearFace {
  std::uint32_t number;
  int winding;
  std::pair<Number, Number> window;
};

/// Near faces and their near edges, gathered one by one and then joined.
class PatchMaker {
 public:
  void addFace(NearFace face) {
    faces_.push_back(std::move(face));
    leaders_.push_back(leaders_.size());
  }
  /// Of the face that was added last.
  void addNearEdge(const Edge& edge) {
    NearEdge& entry = edges_[edge.places];
    entry.nearFaces.push_back(faces_.size() - 1);
    entry.sum += edge.direction;
  }

  [[nodiscard]] std::vector<Patch> makePatches() {
    for (const auto& [places, edge] : edges_) {
      for (const std::size_t face : edge.nearFaces)
        leaders_[leaderOf(face)] = leaderOf(edge.nearFaces.front());
    }
    std::map<std::size_t, Patch> patches;
    std::map<std::size_t, std::pair<Number, Number>> windows;
    for (std::size_t i = 0; i < faces_.size(); ++i) {
      const std::size_t leader = leaderOf(i);
      Patch& patch = patches[leader];
      patch.isCertain = true;
      patch.faces.push_back(faces_[i].number);
      patch.winding += faces_[i].winding;
      const auto [window, isNew] = windows.try_emplace(leader, faces_[i].window);
      window->second.first = std::min(window->second.first, faces_[i].window.first);
      window->second.second = std::max(window->second.second, faces_[i].window.second);
    }
    for (const auto& [places, edge] : edges_) {
      if (edge.sum != 0)
        patches[leaderOf(edge.nearFaces.front())].isCertain = false;
    }
    std::vector<Patch> result;
    for (auto& [leader, patch] : patches) {
      const auto& [lower, upper] = windows.at(leader);
      patch.tLower = CGAL::to_interval(lower).first;
      patch.tUpper = CGAL::to_interval(upper).second;
      result.push_back(std::move(patch));
    }
    return result;
  }

 private:
  [[nodiscard]] std::size_t leaderOf(std::size_t face) const {
    while (leaders_[face] != face)
      face = leaders_[face];
    return face;
  }

  std::vector<NearFace> faces_;
  std::vector<std::size_t> leaders_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, NearEdge> edges_;
};

bool areFinite(const Corners& corners) noexcept {
  return std::all_of(corners.begin(), corners.end(),
                     [](const Vec3d& corner) { return isFinite(corner); });
}

}  // namespace

ExactMeeting meet(const Rayd& ray, const Corners& corners) {
  const exact::View view(ray);
  const auto points = sheared(view, corners);
  const auto [kind, interval] = meetExactly(ray, view, corners, points);
  ExactMeeting meeting;
  meeting.kind = kind;
  meeting.tLower = meeting.tUpper = std::numeric_limits<double>::quiet_NaN();
  if (interval) {
    meeting.tLower = CGAL::to_interval(interval->first).first;
    meeting.tUpper = CGAL::to_interval(interval->second).second;
  }
  const Number distance = std::min({exact::distanceToEdge(points[0], points[1]),
                                    exact::distanceToEdge(points[1], points[2]),
                                    exact::distanceToEdge(points[2], points[0])});
  const double depth = CGAL::to_double(distance);
  meeting.depth = sideOfLine(ray, corners) > 0 ? depth : -depth;
  return meeting;
}

const Patch* Expectation::patchOf(std::uint32_t face) const noexcept {
  for (const Patch& patch : patches) {
    if (std::find(patch.faces.begin(), patch.faces.end(), face) != patch.faces.end())
      return &patch;
  }
  return nullptr;
}

ExactJudge::ExactJudge(std::span<const Corners> faces, const Box3& bounds, double boundInRoundoffs,
                       double roundoff)
    : corners_(faces.begin(), faces.end()),
      bounds_(bounds),
      boundInRoundoffs_(boundInRoundoffs),
      roundoff_(roundoff) {
  std::map<std::tuple<double, double, double>, std::uint32_t> places;
  for (std::uint32_t number = 0; number < corners_.size(); ++number) {
    if (!areFinite(corners_[number]))
      continue;
    Face face{number, corners_[number], {}};
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d& corner = face.corners[i];
      face.places[i] = places
                           .try_emplace({corner.x, corner.y, corner.z},
                                        static_cast<std::uint32_t>(places.size()))
                           .first->second;
    }
    faces_.push_back(face);
  }
}

double ExactJudge::largestDistance(const Rayd& ray) const noexcept {
  double largest = 0.0;
  for (const Axis axis : kAxes) {
    largest =
        std::max({largest, std::fabs(static_cast<double>(bounds_.lower[axis]) - ray.origin[axis]),
                  std::fabs(static_cast<double>(bounds_.upper[axis]) - ray.origin[axis])});
  }
  return largest;
}

Expectation ExactJudge::expect(const Rayd& ray) const {
  // The bounds of nothing are not finite.
  if (faces_.empty())
    return {};
  const double distance = largestDistance(ray);
  const double bound = boundInRoundoffs_ * roundoff_ * distance;
  const NearFilter filter(ray, bound * 1.001 + 0x1p-46 * distance);
  const exact::View view(ray);
  const Number exactBound(bound);

  Expectation expectation;
  PatchMaker patches;
  for (const Face& face : faces_) {
    if (!filter.mayBeNear(face.corners)) {
      ++expectation.missCount;
      continue;
    }
    const auto points = sheared(view, face.corners);
    const Meeting kind = meetExactly(ray, view, face.corners, points).first;
    expectation.hitCount += kind == Meeting::Hit ? 1u : 0u;
    expectation.missCount += kind == Meeting::Miss ? 1u : 0u;
    expectation.touchingCount += kind == Meeting::Touching ? 1u : 0u;

    const Polygon nearPart = exact::clippedToBox({points.begin(), points.end()}, 2, exactBound);
    if (nearPart.empty())
      continue;
    const int towardZ = ray.direction[RayAxes(ray.direction).z] > 0.0 ? 1 : -1;
    patches.addFace({face.number, exact::windingAlongZ(points) * towardZ,
                     exact::intervalOfT(nearPart, view.directionZ(), exactBound)});
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      if (exact::distanceToEdge(points[i], points[next]) <= exactBound)
        patches.addNearEdge({face.places[i], face.places[next]});
    }
  }
  expectation.patches = patches.makePatches();
  return expectation;
}

bool ExactJudge::isWithin(const Rayd& ray, double t, std::uint32_t face, int roundoffs) const {
  if (!std::isfinite(t) || face >= corners_.size() || !areFinite(corners_[face]))
    return false;
  Polygon polygon;
  for (const Vec3d& corner : corners_[face]) {
    Point relative;
    for (const Axis axis : kAxes) {
      relative[static_cast<std::size_t>(axis)] =
          Number(corner[axis]) - Number(ray.origin[axis]) - Number(t) * Number(ray.direction[axis]);
    }
    polygon.push_back(relative);
  }
  const Number unit = Number(roundoff_) * Number(largestDistance(ray));
  return !exact::clippedToBox(polygon, 3, unit * Number(roundoffs)).empty();
}

int ExactJudge::distanceInRoundoffs(const Rayd& ray, double t, std::uint32_t face, int most) const {
  int roundoffs = 0;
  while (roundoffs < most && !isWithin(ray, t, face, roundoffs))
    ++roundoffs;
  return roundoffs;
}

}  // namespace planetree::test
