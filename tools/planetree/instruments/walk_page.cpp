#include "instruments/walk_page.hpp"

#include "instruments/text_bar.hpp"
#include "talk.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace planetree::tool {

namespace {

constexpr std::size_t kWidth = 100;
constexpr std::size_t kMostIndents = 12;
/// In larger leaves only the objects that are hit are named.
constexpr std::size_t kMostNamedObjects = 8;

/// To six digits: enough to follow the walk.
template <class T>
std::string shortText(T number) {
  return fmt::format("{:.6g}", number);
}

template <class T>
std::string shortText(const Interval<T>& part) {
  return fmt::format("[{}, {}]", shortText(part.tMin), shortText(part.tMax));
}

/// The shortest text that is read back as the same bits.
template <class T>
std::string exactText(const Vec3<T>& vector) {
  return fmt::format("({}, {}, {})", vector.x, vector.y, vector.z);
}

/// One line of the table, of pieces that are broken onto further lines where they do not fit.
class Row {
 public:
  Row(std::string head, std::size_t indent) : line_(std::move(head)), indent_(indent) {}

  void add(const std::string& piece) {
    if (columnCount(line_) + 1 + columnCount(piece) > kWidth) {
      text_ += line_ + '\n';
      line_.assign(indent_, ' ');
    } else {
      line_ += ' ';
    }
    line_ += piece;
  }
  void add(const std::vector<std::string>& list) {
    for (std::size_t i = 0; i < list.size(); ++i)
      add(list[i] + (i + 1 < list.size() ? "," : ""));
  }

  [[nodiscard]] std::string take() { return text_ + line_ + '\n'; }

 private:
  std::string text_;
  std::string line_;
  std::size_t indent_;
};

template <class T>
class WalkWriter {
 public:
  WalkWriter(const Walk<T>& walk, const WalkContext& context) : walk_(walk), context_(context) {}

  [[nodiscard]] std::string write() {
    addRay();
    if (walk_.insideBounds) {
      addWay(*walk_.insideBounds);
      addSteps();
    } else {
      line("Between its limits of t it does not meet the bounds.");
    }
    addHit();
    addCounts();
    return std::move(text_);
  }

 private:
  void line(const std::string& text) { text_ += text + '\n'; }

  void addRay() {
    const Ray<T>& ray = walk_.ray;
    line("ray     from " + exactText(ray.origin));
    line("        along " + exactText(ray.direction));
    line(fmt::format("        t from {} to {}", ray.tMin, ray.tMax));
    line("bounds  from " + exactText(context_.bounds.lower));
    line("        to " + exactText(context_.bounds.upper));
    line("");
  }

  void addWay(const Interval<T>& part) {
    const bool beginsInside = part.tMin <= walk_.ray.tMin;
    const bool endsInside = part.tMax >= walk_.ray.tMax;
    line(fmt::format("It {} at t = {} and {} at t = {}.",
                     beginsInside ? "begins inside the bounds" : "enters the bounds",
                     shortText(part.tMin), endsInside ? "ends inside" : "leaves them",
                     shortText(part.tMax)));
  }

  void addSteps() {
    line("Brackets hold the part of the ray in a cell. What is indented happens in the near cell.");
    line("");
    line("level      node");
    for (const WalkStep<T>& step : walk_.steps)
      std::visit([this](const auto& each) { this->add(each); }, step);
    line("");
  }

  void add(const SplitStep<T>& step) {
    const std::string near = step.leftIsNear ? "near left" : "near right";
    const std::string far = step.leftIsNear ? "far right" : "far left";
    Row row = begin(step.visit);
    row.add(fmt::format("split {} at {}:", axisName(step.axis), shortText(step.position)));
    if (step.nearPart && step.farPart) {
      row.add({near + " " + shortText(*step.nearPart), far + " " + shortText(*step.farPart)});
      ++waitingCount_;
    } else {
      row.add(fmt::format("{} {} only", step.nearPart ? near : far,
                          shortText(step.nearPart ? *step.nearPart : *step.farPart)));
    }
    text_ += row.take();
  }

  void add(const LeafStep<T>& step) {
    Row row = begin(step.visit);
    const std::string part = shortText(step.visit.part);
    if (step.objectCount == 0) {
      row.add("empty leaf " + part);
      ++emptyLeafCount_;
    } else {
      row.add(fmt::format("leaf of {} {}:", grouped(step.objectCount), part));
      row.add(testTexts(step));
    }
    text_ += row.take();
    comesBack_ = true;
  }

  void add(const LeftOutStep<T>& step) {
    ++leftOutCount_;
    Row row = begin(step.visit);
    row.add(fmt::format("left out {}:", shortText(step.visit.part)));
    row.add(context_.isAnyHit ? "any hit is enough" : "it begins beyond the hit");
    text_ += row.take();
    comesBack_ = true;
  }

  [[nodiscard]] Row begin(const NodeVisit<T>& visit) {
    if (std::exchange(comesBack_, false))
      --waitingCount_;
    const std::size_t indent = 2 * std::min(waitingCount_, kMostIndents);
    const std::string head =
        fmt::format("{:>5}  {:>8} {}", visit.level, visit.node, std::string(indent, ' '));
    return Row(head, head.size() + 5);
  }

  [[nodiscard]] std::vector<std::string> testTexts(const LeafStep<T>& step) {
    std::vector<std::string> texts;
    std::size_t unnamedCount = 0;
    for (const ObjectTest<T>& test : step.tests) {
      if (test.hit) {
        texts.push_back(hitText(test, step.visit.part));
      } else if (step.tests.size() <= kMostNamedObjects) {
        texts.push_back(fmt::format("{} no", test.primitive));
      } else {
        ++unnamedCount;
      }
    }
    if (unnamedCount > 0) {
      const std::string_view others = unnamedCount < step.tests.size() ? "others no" : "no";
      texts.push_back(fmt::format("{} {}", grouped(unnamedCount), others));
    }
    if (step.tests.size() < step.objectCount)
      texts.push_back(fmt::format("{} not tested", grouped(step.objectCount - step.tests.size())));
    return texts;
  }

  [[nodiscard]] std::string hitText(const ObjectTest<T>& test, const Interval<T>& part) {
    std::string text = fmt::format("{} hit at {}", test.primitive, shortText(test.hit->t));
    if (!test.isAccepted) {
      const bool isSame = best_->primitive == test.primitive;
      return text + (isSame ? " (known)" : test.hit->t > best_->t ? " (farther)" : " (as near)");
    }
    best_ = test.hit;
    if (test.hit->t > part.tMax)
      text += " (beyond the cell)";
    if (test.hit->t < part.tMin)
      text += " (before the cell)";
    return text;
  }

  void addHit() {
    if (!walk_.hit) {
      line("no hit");
      return;
    }
    const Hit<T>& hit = *walk_.hit;
    const std::string source =
        context_.sourceFaces.empty()
            ? ""
            : fmt::format(" (face {} of the file)", context_.sourceFaces[hit.primitive]);
    line(fmt::format("hit     triangle {}{} at t = {}", hit.primitive, source, hit.t));
    line(fmt::format("        u {}, v {}", hit.u, hit.v));
    line("point   " + exactText(walk_.ray.at(hit.t)));
    line("normal  " + exactText(hit.normal));
  }

  void addCounts() {
    line("");
    line(fmt::format("{}, {} ({} empty), {} tested, {} left out",
                     counted(walk_.counts.splitNodes, "split"),
                     counted(walk_.counts.leafNodes, "leaf", "leaves"), grouped(emptyLeafCount_),
                     counted(walk_.counts.objects, "triangle"), counted(leftOutCount_, "node")));
  }

  const Walk<T>& walk_;
  const WalkContext& context_;
  std::string text_;
  std::optional<Hit<T>> best_;
  std::size_t waitingCount_ = 0;  ///< far children that the ray has yet to come to
  bool comesBack_ = false;        ///< the next row is of the child that waited last
  std::uint64_t emptyLeafCount_ = 0;
  std::uint64_t leftOutCount_ = 0;
};

}  // namespace

template <std::floating_point T>
std::string walkPage(const Walk<T>& walk, const WalkContext& context) {
  return WalkWriter<T>(walk, context).write();
}

template std::string walkPage<float>(const Walk<float>&, const WalkContext&);
template std::string walkPage<double>(const Walk<double>&, const WalkContext&);

}  // namespace planetree::tool
