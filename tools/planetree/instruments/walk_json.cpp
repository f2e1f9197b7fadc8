#include "instruments/walk_json.hpp"

#include "instruments/exact_json.hpp"

#include <nlohmann/json.hpp>

#include <variant>

namespace planetree::tool {

namespace {

template <class T>
Json intervalJson(const Interval<T>& interval) {
  return Json::array({exactJson(interval.tMin), exactJson(interval.tMax)});
}

template <class T>
Json intervalJson(const std::optional<Interval<T>>& interval) {
  return interval ? intervalJson(*interval) : Json(nullptr);
}

template <class T>
Json hitJson(const Hit<T>& hit) {
  return {
      {"t", exactJson(hit.t)}, {"geometry", hit.geometry}, {"primitive", hit.primitive},
      {"u", exactJson(hit.u)}, {"v", exactJson(hit.v)},    {"normal", exactJson(hit.normal)},
  };
}

template <class T>
Json visitJson(const char* kind, const NodeVisit<T>& visit) {
  return {
      {"kind", kind},
      {"level", visit.level},
      {"node", visit.node},
      {"interval", intervalJson(visit.part)},
  };
}

template <class T>
Json stepJson(const SplitStep<T>& step) {
  Json json = visitJson("split", step.visit);
  json["axis"] = axisName(step.axis);
  json["position"] = exactJson(step.position);
  json["near_side"] = step.leftIsNear ? "left" : "right";
  json["near"] = intervalJson(step.nearPart);
  json["far"] = intervalJson(step.farPart);
  return json;
}

template <class T>
Json stepJson(const LeafStep<T>& step) {
  Json tests = Json::array();
  for (const ObjectTest<T>& test : step.tests) {
    tests.push_back({
        {"primitive", test.primitive},
        {"t", test.hit ? exactJson(test.hit->t) : Json(nullptr)},
        {"is_accepted", test.isAccepted},
    });
  }
  Json json = visitJson("leaf", step.visit);
  json["object_count"] = step.objectCount;
  json["tests"] = std::move(tests);
  return json;
}

template <class T>
Json stepJson(const LeftOutStep<T>& step) {
  return visitJson("left_out", step.visit);
}

}  // namespace

template <std::floating_point T>
Json walkJson(const Walk<T>& walk, const WalkContext& context) {
  Json steps = Json::array();
  for (const WalkStep<T>& step : walk.steps)
    steps.push_back(std::visit([](const auto& each) { return stepJson(each); }, step));
  Json hit = nullptr;
  if (walk.hit) {
    hit = hitJson(*walk.hit);
    if (!context.sourceFaces.empty())
      hit["source_face"] = context.sourceFaces[walk.hit->primitive];
  }
  return {
      {"query", context.isAnyHit ? "any" : "closest"},
      {"precision", std::same_as<T, double> ? "double" : "float"},
      {"ray",
       {{"origin", exactJson(walk.ray.origin)},
        {"direction", exactJson(walk.ray.direction)},
        {"t_min", exactJson(walk.ray.tMin)},
        {"t_max", exactJson(walk.ray.tMax)}}},
      {"bounds", exactJson(context.bounds)},
      {"inside_bounds", intervalJson(walk.insideBounds)},
      {"steps", std::move(steps)},
      {"hit", std::move(hit)},
      {"split_count", walk.counts.splitNodes},
      {"leaf_count", walk.counts.leafNodes},
      {"tested_count", walk.counts.objects},
  };
}

template Json walkJson<float>(const Walk<float>&, const WalkContext&);
template Json walkJson<double>(const Walk<double>&, const WalkContext&);

}  // namespace planetree::tool
